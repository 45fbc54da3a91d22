// The document's shelf: what is kept on it, under which names.
#include <algorithm>

#include "sculptor/run.hpp"

namespace bozzetto {
namespace {

std::vector<ShelfItem>::iterator itemNamed(ToolLibrary& tools, const std::string& name) {
  const auto item = std::ranges::find(tools.shelf, name, &ShelfItem::name);
  if (item == tools.shelf.end())
    throw Error("the document's shelf holds nothing called '" + name.substr(0, 40) + "'");
  return item;
}

// What the source means, with what it says of region, pivot and contact.
template <int Side>
ShelfTool toolFrom(const ToolSource& source, Workbench<Side>& bench, const Telling& telling) {
  ShelfTool tool;
  if (source.isAtHand()) {
    tool.clay = withSide<8>(bench.field());
  } else {
    tool = bench.tools.load(source, telling.progress);
  }
  tool.clay = sculptureOf(tool, source)->clay();
  if (source.region) tool.thumbnail.clear();
  if (source.pivot) tool.pivot = source.pivot;
  if (source.contact) tool.contact = source.contact;
  return tool;
}

}  // namespace

template <int Side>
void run(const ShelfKeepOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  ShelfTool tool = toolFrom(operation.source, bench, telling);
  tool.name = operation.name;
  if (!operation.tags.empty()) tool.tags = operation.tags;
  if (!operation.preset.empty()) tool.preset.clear();
  for (const std::string& line : operation.preset)
    tool.preset.push_back(parseOperation(line, "shelf_keep: preset"));
  ShelfItem item = toItem(tool);
  auto& shelf = bench.tools.shelf;
  const auto old = std::ranges::find(shelf, item.name, &ShelfItem::name);
  if (old == shelf.end()) {
    shelf.push_back(std::move(item));
  } else {
    *old = std::move(item);
  }
  bench.tools.forget();
}

template <int Side>
void run(const ShelfRenameOperation& operation, Workbench<Side>& bench, const Telling&) {
  const auto item = itemNamed(bench.tools, operation.name);
  const bool taken = std::ranges::count(bench.tools.shelf, operation.to, &ShelfItem::name) > 0;
  if (taken && operation.to != operation.name)
    throw Error("the document's shelf holds a '" + operation.to.substr(0, 40) + "' already");
  ShelfTool tool = fromItem(*item);
  tool.name = operation.to;
  if (operation.tags) tool.tags = *operation.tags;
  *item = toItem(tool);
  bench.tools.forget();
}

template <int Side>
void run(const ShelfDropOperation& operation, Workbench<Side>& bench, const Telling&) {
  bench.tools.shelf.erase(itemNamed(bench.tools, operation.name));
  bench.tools.forget();
}

BOZZETTO_RUNS(ShelfKeepOperation);
BOZZETTO_RUNS(ShelfRenameOperation);
BOZZETTO_RUNS(ShelfDropOperation);

}  // namespace bozzetto
