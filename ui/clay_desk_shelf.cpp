// Shelves: listing them with pictures, and what is done with their tools beside sculpting.
#include <algorithm>

#include "bozzetto/base/hash.hpp"
#include "bozzetto/render/thumbnail.hpp"
#include "bozzetto/sculptor/user_tools.hpp"
#include "ui/clay_desk.hpp"

namespace bozzetto::ui {
namespace {

namespace fs = std::filesystem;

void setPicture(ShelfCard& card, std::shared_ptr<const Bytes> picture) {
  card.pictureId = picture->empty() ? 1 : hash64(*picture) | 1;
  card.picture = std::move(picture);
}

// Among the user's own.
void addDamaged(std::vector<ShelfCard>& cards) {
  const auto own = std::ranges::find_if(
      cards, [](const ShelfCard& card) { return card.entry.place > ToolEntry::Place::document; });
  std::vector<ShelfCard> damaged;
  for (DamagedTool& tool : damagedTools()) {
    ShelfCard card{{std::move(tool.name), {}, ToolEntry::Place::user}, nullptr, 0};
    setPicture(card, std::make_shared<const Bytes>());
    card.trouble = std::move(tool.why);
    damaged.push_back(std::move(card));
  }
  cards.insert(own, std::make_move_iterator(damaged.begin()),
               std::make_move_iterator(damaged.end()));
}

}  // namespace

void ClayDesk::listShelf() {
  cards_.clear();
  const ToolLibrary& tools = bench().tools();
  for (ToolEntry& entry : tools.list()) {
    ShelfCard card{std::move(entry), nullptr, 0};
    if (card.entry.place == ToolEntry::Place::document) {
      const auto item = std::ranges::find(tools.shelf, card.entry.name, &ShelfItem::name);
      if (!item->thumbnail.empty())
        setPicture(card, std::make_shared<const Bytes>(item->thumbnail));
    } else if (card.entry.place == ToolEntry::Place::starter) {
      const auto made = starterPictures_.find(card.entry.name);
      if (made != starterPictures_.end()) setPicture(card, made->second);
    }
    cards_.push_back(std::move(card));
  }
  addDamaged(cards_);
  // The alphabet, which is long, comes last.
  std::stable_partition(cards_.begin(), cards_.end(), [](const ShelfCard& card) {
    return std::ranges::find(card.entry.tags, "alphabet") == card.entry.tags.end();
  });
  out_.shelf = cards_;
  if (rest_ == Rest::nothing) rest_ = Rest::pictures;
}

// What a tool looks like, kept where the tool is.
void ClayDesk::picture(ShelfCard& card) {
  ShelfTool tool;
  switch (card.entry.place) {
    case ToolEntry::Place::document:
      tool = bench().tools().find(card.entry.name);
      break;
    case ToolEntry::Place::user:
      tool = loadTool(userToolFile(card.entry.name));
      break;
    case ToolEntry::Place::starter:
      tool = makeStarter(card.entry.name);
      break;
  }
  auto made = std::make_shared<const Bytes>(tool.thumbnail.empty() ? thumbnailOf(likenessOf(tool))
                                                                   : tool.thumbnail);
  if (card.entry.place == ToolEntry::Place::starter) starterPictures_[card.entry.name] = made;
  if (card.entry.place == ToolEntry::Place::document) {
    auto& shelf = bench().tools().shelf;
    std::ranges::find(shelf, card.entry.name, &ShelfItem::name)->thumbnail = *made;
  }
  setPicture(card, std::move(made));
}

// One picture at a time, so that strokes need not wait long. False when all are there.
bool ClayDesk::pictureNext() {
  const auto next = std::ranges::find(cards_, 0u, &ShelfCard::pictureId);
  if (pictures_ == ShelfPictures::none || next == cards_.end()) return false;
  try {
    picture(*next);
  } catch (const Error& error) {
    setPicture(*next, std::make_shared<const Bytes>());
    fail(error.what());
  }
  out_.shelf = cards_;
  return true;
}

void ClayDesk::takeTool(const ToolSource& source) {
  ToolLibrary& tools = bench().tools();
  const ShelfTool tool = tools.load(source);
  const bool isPreset = tool.clay.tree.empty() && !tool.preset.empty();
  unprepared_ = isPreset ? nullptr : tools.sculpture(source);
  out_.taken = freeformOf(tool, source, unprepared_);
}

void ClayDesk::shareTool(const std::string& name, const fs::path& path) {
  share(bench().tools().find(name), path);
  note("Saved " + path.filename().string());
}

void ClayDesk::share(ShelfTool tool, const fs::path& path) {
  if (tool.thumbnail.empty()) tool.thumbnail = thumbnailOf(likenessOf(tool));
  saveTool(path, tool);
}

void ClayDesk::keepForUser(const std::string& name, const std::string& as) {
  const fs::path file = userToolFile(as);
  if (isStarter(as) && !fs::exists(file))
    throw Error(as + ": a starter is called so, another name expected");
  ShelfTool tool = bench().tools().find(name);
  tool.name = as;
  fs::create_directories(userToolFolder());
  share(std::move(tool), file);
  note(as + " is in your library now");
  changeLibrary([] {});
}

// Names mean other tools from now on.
void ClayDesk::changeLibrary(const std::function<void()>& change) {
  change();
  bench().tools().forget();
  listShelf();
}

}  // namespace bozzetto::ui
