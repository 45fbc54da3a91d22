// The document's shelf: what is kept on it, under which names.
#include <algorithm>

#include "sculptor/run.hpp"
#include "sculptor/tool_notes.hpp"

namespace bozzetto {
namespace {

std::vector<ShelfItem>::iterator itemNamed(ToolLibrary& tools, const std::string& name) {
  const auto item = std::ranges::find(tools.shelf, name, &ShelfItem::name);
  if (item == tools.shelf.end())
    throw Error("the document's shelf holds nothing called '" + name.substr(0, 40) + "'");
  return item;
}

// A preset without clay: of a plain shape, or where there is no clay.
bool standsAlone(const std::vector<Operation>& preset, const ToolSource& source, bool airOnly) {
  if (preset.empty() || !source.isAtHand() || source.region || source.patch) return false;
  return airOnly || plainShapeOf(preset) != nullptr;
}

// A preset that takes a tool of the old name takes that of the new one.
void renameIn(std::vector<Operation>& preset, const std::string& from, const std::string& to) {
  for (Operation& operation : preset) {
    auto* taken = std::get_if<ToolOperation>(&operation);
    if (taken && taken->source && taken->source->from == "shelf:" + from)
      taken->source->from = "shelf:" + to;
  }
}

// What the source means, with all that it says of it.
template <int Side>
ShelfTool toolFrom(const ToolSource& source, Workbench<Side>& bench, const Telling& telling) {
  ShelfTool tool;
  if (source.isAtHand()) {
    tool.clay = withSide<8>(bench.field());
  } else {
    tool = bench.tools.load(source, telling.progress);
  }
  const bool isPreset = tool.clay.tree.empty() && !tool.preset.empty() && !source.region;
  return isPreset ? tool : shapedBy(source, std::move(tool));
}

}  // namespace

template <int Side>
void run(const ShelfKeepOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  requireToolName(operation.name);
  std::vector<Operation> preset;
  for (const std::string& line : operation.preset)
    preset.push_back(presetOperation(parseJson(line, "shelf_keep"), "shelf_keep", preset.size()));
  ShelfTool tool;
  if (!standsAlone(preset, operation.source, bench.field().tree.empty()))
    tool = toolFrom(operation.source, bench, telling);
  tool.name = operation.name;
  if (!operation.tags.empty()) tool.tags = operation.tags;
  if (!preset.empty()) tool.preset = std::move(preset);
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
  requireToolName(operation.to);
  const auto item = itemNamed(bench.tools, operation.name);
  const bool taken = std::ranges::count(bench.tools.shelf, operation.to, &ShelfItem::name) > 0;
  if (taken && operation.to != operation.name)
    throw Error("the document's shelf holds a '" + operation.to.substr(0, 40) + "' already");
  ShelfTool tool = fromItem(*item);
  tool.name = operation.to;
  renameIn(tool.preset, operation.name, operation.to);
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
