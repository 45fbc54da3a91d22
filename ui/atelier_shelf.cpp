// What is done with shelves: all of it operations, or files of the user's own library.
#include <algorithm>

#include "bozzetto/sculptor/user_tools.hpp"
#include "ui/atelier.hpp"

namespace bozzetto::ui {
namespace {

namespace fs = std::filesystem;
using Place = ToolEntry::Place;

ToolSource named(const std::string& name) {
  ToolSource source;
  source.from = "shelf:" + name;
  return source;
}

const char* ownerOf(Place place) {
  constexpr const char* owners[] = {"this scene", "your library", "the starter library"};
  return owners[int(place)];
}

// The hand has it by its name, which means the scene's tool before others.
bool isHeld(const Atelier& atelier, const ToolEntry& entry) {
  const SculptState& sculpt = atelier.sculpt;
  const ShelfCard* meant = cardNamed(atelier.shelf.cards, entry.name);
  return sculpt.isFreeform() && sculpt.freeform->source.from == named(entry.name).from &&
         meant != nullptr && meant->entry.place == entry.place;
}

}  // namespace

std::vector<std::string> tagsOf(const std::string& text) {
  std::vector<std::string> tags;
  for (std::size_t at = text.find_first_not_of(", "); at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(", ", at), text.size());
    tags.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(", ", end);
  }
  return tags;
}

const ShelfCard* cardNamed(const std::vector<ShelfCard>& cards, const std::string& name) {
  const ShelfCard* found = nullptr;
  for (const ShelfCard& card : cards) {
    if (card.entry.name != name) continue;
    if (found == nullptr || card.entry.place < found->entry.place) found = &card;
  }
  return found;
}

std::string freeName(const std::vector<ShelfCard>& cards, const std::string& wanted) {
  std::string name = wanted;
  for (int n = 2; cardNamed(cards, name) != nullptr; ++n) name = wanted + " " + std::to_string(n);
  return name;
}

// Nobody draws them where nobody looks.
void Atelier::wantPictures() {
  const auto pictures = thumbnail ? ShelfPictures::made : ShelfPictures::none;
  worker_.post([pictures](ClayDesk& desk) { desk.setPictures(pictures); });
}

void Atelier::listShelf() {
  wantPictures();
  worker_.post([](ClayDesk& desk) { desk.listShelf(); });
}

void Atelier::takeTool(const ToolEntry& entry) {
  touch();
  const ShelfCard* meant = cardNamed(shelf.cards, entry.name);
  if (meant != nullptr && meant->entry.place != entry.place)
    return say(Message::Kind::error, entry.name + ": " + ownerOf(meant->entry.place) +
                                         " has a tool of that name, which hides this one. "
                                         "Rename that first");
  if (anotherComes()) return;
  taking_ = {worker_.start("Taking " + entry.name,
                           [source = named(entry.name)](ClayDesk& desk, Progress&) {
                             desk.takeTool(source);
                           }),
             sculpt.action};
  whenDone(taking_.first, {});
}

// Strokes would still be those of the tool before.
bool Atelier::toolComes() {
  const bool comes =
      taking_.first && std::ranges::find(jobs_, taking_.first, &Job::job) != jobs_.end();
  if (comes) say(Message::Kind::note, taking_.first->title() + ": strokes wait until it is there");
  return comes;
}

void Atelier::keep(ShelfKeepOperation operation, std::function<void()> then) {
  touch();
  const auto work = [operation](ClayDesk& desk, Progress& progress) {
    desk.apply(operation, progress);
    desk.listShelf();
  };
  begin("Keeping " + operation.name, work, std::move(then));
}

// With what the hand does now, so that it comes back as it was used.
void Atelier::keepClay(const std::string& name, std::vector<std::string> tags,
                       ShelfDrawer::Part wanted, std::optional<PatchSource> patch) {
  ShelfKeepOperation operation{name, std::move(tags)};
  operation.preset = sculpt.preset();
  if (wanted != ShelfDrawer::Part::toolInHand) operation.source.patch = patch;
  if (wanted == ShelfDrawer::Part::toolInHand) {
    if (sculpt.isFreeform()) operation.source = sculpt.freeform->source;
    operation.preset.insert(operation.preset.begin(), sculpt.presetOfTool("shelf:" + name));
  }
  if (wanted == ShelfDrawer::Part::insideBox && options.boxSize)
    operation.source.region = WorldRegion{options.boxSize->low, options.boxSize->high, {}};
  if (wanted == ShelfDrawer::Part::insideLasso && lasso_) operation.source.region = part();
  // What the hand has by that name means the new one from now on.
  keep(std::move(operation), [this, name, wanted] {
    if (wanted == ShelfDrawer::Part::toolInHand || !sculpt.isFreeform()) return;
    if (sculpt.freeform->name == name) takeTool({name, {}, Place::document});
  });
}

void Atelier::choosePart(ShelfDrawer::Part wanted) {
  shelf.part = wanted;
  lassoNext_ = false;
  if (wanted == ShelfDrawer::Part::insideLasso && !lasso_) run(Command::lasso);
  if (wanted == ShelfDrawer::Part::insideBox && !options.boxSize) run(Command::fitBox);
  options.box = wanted == ShelfDrawer::Part::insideBox;
}

// Under its own name, where it takes the place of what it came from; of others, in front of them.
void Atelier::keepStand() {
  if (!sculpt.isFreeform()) return;
  ShelfKeepOperation operation{sculpt.freeform->name};
  operation.source = sculpt.freeform->source;
  const auto stands = sculpt.freeform->sculpture;
  keep(std::move(operation), [this, stands] {
    if (!sculpt.isFreeform() || sculpt.freeform->sculpture != stands) return;
    sculpt.freeform->kept = stands;
    sculpt.freeform->standAsKept();
  });
}

// The scene that was left may have taken the tool in the hand with it.
void Atelier::lookForTool() {
  const std::string name = sculpt.freeform->name;
  const auto isThere = std::make_shared<bool>(false);
  const auto work = [name, isThere](ClayDesk& desk, Progress&) {
    *isThere = std::ranges::any_of(desk.sculptor().tools().list(),
                                   [&](const ToolEntry& entry) { return entry.name == name; });
  };
  begin("Looking for " + name, work, [this, name, isThere] {
    if (*isThere || !sculpt.isFreeform() || sculpt.freeform->name != name) return;
    sculpt.drop();
    say(Message::Kind::note, name + " stayed with the other scene");
  });
}

void Atelier::keepFile(const fs::path& path) {
  dialog = Dialog::none;
  ShelfKeepOperation operation{freeName(shelf.cards, path.stem().string())};
  operation.source.from = fs::absolute(path).string();
  keep(std::move(operation));
}

// What names are taken only the desk knows: the drawer may never have been open.
void Atelier::takeFile(const fs::path& path) {
  touch();
  const std::string stem = path.stem().string(), opens = keymap.chordText(Command::open);
  const auto work = [=, from = fs::absolute(path).string()](ClayDesk& desk, Progress& progress) {
    std::vector<ShelfCard> cards;
    for (ToolEntry& entry : desk.sculptor().tools().list())
      cards.push_back({std::move(entry), nullptr, 0});
    ShelfKeepOperation operation{freeName(cards, stem)};
    operation.source.from = from;
    desk.apply(operation, progress);
    desk.takeTool(named(operation.name));
    desk.listShelf();
    desk.note(operation.name + " is a tool: it is on the shelf now, and in hand. " + opens +
              " opens it as a scene");
  };
  begin("Taking " + stem, work);
}

void Atelier::keepLetters(const std::string& text, double size, double depth) {
  ShelfKeepOperation operation{freeName(shelf.cards, text), {"text"}};
  operation.source.text = text;
  operation.source.letterSize = size;
  operation.source.letterDepth = depth;
  keep(std::move(operation));
}

void Atelier::renameTool(const ToolEntry& entry, const std::string& to,
                         std::vector<std::string> tags) {
  touch();
  const ShelfCard* taken = to == entry.name ? nullptr : cardNamed(shelf.cards, to);
  if (taken != nullptr)
    return say(Message::Kind::error, to + ": " + ownerOf(taken->entry.place) +
                                         " has a tool of that name. Another name is needed");
  const auto work = [entry, to, tags = std::move(tags)](ClayDesk& desk, Progress&) {
    if (entry.place == Place::user)
      return desk.changeLibrary([&] { renameUserTool(entry.name, to, tags); });
    desk.apply(ShelfRenameOperation{entry.name, to, tags});
    desk.listShelf();
  };
  begin("Renaming " + entry.name, work, [this, to, held = isHeld(*this, entry)] {
    if (!held || !sculpt.isFreeform()) return;
    sculpt.freeform->name = to;
    sculpt.freeform->source.from = named(to).from;
  });
}

void Atelier::dropTool(const ToolEntry& entry) {
  touch();
  const auto work = [entry](ClayDesk& desk, Progress&) {
    if (entry.place == Place::user) return desk.changeLibrary([&] { dropUserTool(entry.name); });
    desk.apply(ShelfDropOperation{entry.name});
    desk.listShelf();
  };
  begin("Deleting " + entry.name, work, [this, held = isHeld(*this, entry)] {
    if (held) sculpt.drop();
  });
}

void Atelier::shareTool(const ToolEntry& entry, const fs::path& path) {
  dialog = Dialog::none;
  ask([entry, path](ClayDesk& desk) { desk.shareTool(entry.name, path); });
}

void Atelier::keepForUser(const ToolEntry& entry, const std::string& as) {
  ask([entry, as](ClayDesk& desk) { desk.keepForUser(entry.name, as); });
}

}  // namespace bozzetto::ui
