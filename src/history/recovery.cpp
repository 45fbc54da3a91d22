#include "bozzetto/history/recovery.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>

#include "bozzetto/base/file.hpp"
#include "history/folder_listing.hpp"
#include "history/history_parts.hpp"

namespace bozzetto {
namespace {

using undo::FileHead;
using undo::FolderListing;
using undo::Journal;
using undo::UndoFile;

/// A state by number and mark: the same number may have come twice, the mark not.
using StateName = std::pair<StepNumber, std::uint64_t>;
constexpr StateName kNothing{0, 0};  // a document that began empty

std::string digitsOf(const HistoryIdentity& identity) {
  std::string text;
  for (int n = 0; n < 4; ++n) {
    char digits[3];
    std::snprintf(digits, sizeof digits, "%02x", identity[n]);
    text += digits;
  }
  return text;
}

// The steps of a listing as a forest: which state at the top each state hangs on.
class Forest {
 public:
  explicit Forest(const std::map<StepNumber, FileHead>& steps) : steps_(&steps) {
    for (const auto& [number, head] : steps) {
      const auto parent = steps.find(head.step.parent);
      const bool known = parent != steps.end() && parent->second.step.mark == head.step.parentMark;
      top_[number] =
          known ? top_[head.step.parent] : StateName{head.step.parent, head.step.parentMark};
    }
  }

  /// A state that no step leads to is its own top.
  StateName topOf(StateName state) const {
    const auto step = steps_->find(state.first);
    const bool known = step != steps_->end() && step->second.step.mark == state.second;
    return known ? top_.at(state.first) : state;
  }

  /// All that hangs on a top.
  StepTree tree(StateName top) const {
    StepTree tree(top.first, top.second);
    for (const auto& [number, head] : *steps_) {
      if (top_.at(number) == top) tree.add(head.step);
    }
    return tree;
  }

 private:
  const std::map<StepNumber, FileHead>* steps_;
  std::map<StepNumber, StateName> top_;
};

StateName nameOf(const HistoryPlace& place) { return {place.place, place.mark}; }
HistoryPlace placeOf(const FileHead& head) {
  const bool step = head.kind == undo::FileKind::step;
  return {head.step.number, step ? head.step.number : head.step.parent, head.step.mark,
          head.moment};
}

template <int Side>
class Recovery {
 public:
  Recovery(const HistoryFolder& where, const std::optional<SavedScene<Side>>& saved,
           FolderListing listing)
      : where_(where), saved_(saved), listing_(std::move(listing)) {}

  /// Tries the states from the latest on; a file that turns out bad is left out and all is tried
  /// again.
  void run() {
    while (!tryAll()) {
    }
  }

  StepTree tree;
  Field<Side> field;
  Beside beside;
  const FolderListing& listing() const { return listing_; }

  std::uint64_t latestMoment() const {
    std::uint64_t latest = saved_ ? saved_->place.moment : 0;
    if (listing_.place) latest = std::max(latest, listing_.place->place.moment);
    for (const auto* heads : {&listing_.steps, &listing_.checkpoints})
      for (const auto& [number, head] : *heads) latest = std::max(latest, head.moment);
    return latest;
  }

  std::vector<Anchor> anchors() const {
    std::vector<Anchor> anchors;
    if (tree.root() == 0 && tree.markOf(0) == kNothing.second) anchors.push_back({0, false});
    for (const auto& [state, head] : listing_.checkpoints) {
      if (has(placeOf(head))) anchors.push_back({state, true});
    }
    return anchors;
  }

  bool has(const HistoryPlace& place) const {
    return tree.has(place.place) && tree.markOf(place.place) == place.mark;
  }

 private:
  // States in which the document was, the latest first.
  std::vector<HistoryPlace> candidates() const {
    std::vector<HistoryPlace> places;
    if (listing_.place) places.push_back(listing_.place->place);
    for (const auto* heads : {&listing_.steps, &listing_.checkpoints})
      for (const auto& [number, head] : *heads) places.push_back(placeOf(head));
    if (!saved_) places.push_back({});
    std::ranges::stable_sort(places, std::greater(), &HistoryPlace::moment);
    if (!saved_) return places;
    // Somebody put an older file back: that is what they want to see.
    const bool putBack = listing_.place && saved_->place.moment < listing_.place->savedMoment;
    const auto later = [&](const HistoryPlace& p) { return p.moment > saved_->place.moment; };
    const auto at = putBack ? places.begin() : std::ranges::find_if_not(places, later);
    places.insert(at, saved_->place);
    return places;
  }

  bool tryAll() {
    const Forest forest(listing_.steps);
    for (const HistoryPlace& place : candidates()) {
      const StateName top = forest.topOf(nameOf(place));
      if (!canStart(forest, top)) continue;
      tree = forest.tree(top);
      if (!load(place)) return false;
      tree.moveTo(place.place);
      tree.aimAt(place.tip);
      return true;
    }
    throw Error(where_.path.string() + ": nothing to recover from");
  }

  bool canStart(const Forest& forest, StateName top) const {
    if (top == kNothing) return true;
    if (saved_ && forest.topOf(nameOf(saved_->place)) == top) return true;
    return std::ranges::any_of(listing_.checkpoints, [&](const auto& each) {
      return forest.topOf(nameOf(placeOf(each.second))) == top;
    });
  }

  // From the nearest sound state of the tree to the place. False when a file was bad.
  bool load(const HistoryPlace& place) {
    StepNumber start = 0;
    std::size_t shortest = SIZE_MAX;
    const auto consider = [&](StepNumber state) {
      const std::size_t length = tree.path(state, place.place).size();
      if (length < shortest) shortest = length, start = state;
    };
    const bool savedIsThere = saved_ && has(saved_->place);
    if (savedIsThere) consider(saved_->place.place);
    for (const Anchor& anchor : anchors()) consider(anchor.state);
    if (savedIsThere && start == saved_->place.place) {
      field = saved_->field;
      beside = saved_->beside;
    } else if (!loadAnchor(start)) {
      return false;
    }
    for (const StepTree::Leg& leg : tree.path(start, place.place)) {
      if (!follow(leg)) return false;
    }
    return true;
  }

  bool loadAnchor(StepNumber state) {
    field = {};
    beside = {};
    const auto checkpoint = listing_.checkpoints.find(state);
    if (checkpoint == listing_.checkpoints.end()) return true;
    const auto path = where_.path / undo::checkpointFileName(state);
    try {
      const Bytes bytes = readFile(path, std::size_t{1} << 40, *where_.files);
      const UndoFile<Side> file(bytes, path.string());
      field.tree = file.tree();
      beside = file.beside();
      field.scale = checkpoint->second.step.note.after;
      return true;
    } catch (const Error& error) {
      listing_.notices.push_back(error.what());
      listing_.checkpoints.erase(checkpoint);
      return false;
    }
  }

  bool follow(const StepTree::Leg& leg) {
    const auto path = where_.path / undo::stepFileName(leg.step);
    try {
      const Bytes bytes = readFile(path, std::size_t{1} << 40, *where_.files);
      const UndoFile<Side> file(bytes, path.string());
      const Beside beyond = file.beside(beside, leg.direction);
      file.unpack(field.tree, leg.direction).apply(field.tree, leg.direction);
      beside = beyond;
      const StepNote& note = file.head().step.note;
      field.scale = leg.direction == Direction::forward ? note.after : note.before;
      return true;
    } catch (const Error& error) {
      listing_.notices.push_back(error.what());
      listing_.steps.erase(leg.step);
      return false;
    }
  }

  const HistoryFolder& where_;
  const std::optional<SavedScene<Side>>& saved_;
  FolderListing listing_;
};

// Files of another scene are nobody's business; when we are to write here they are put aside.
void noteStrangers(const HistoryFolder& where, const FolderListing& listing,
                   std::vector<std::string>& notices) {
  std::size_t count = 0;
  for (const auto& [identity, number] : listing.strangers) count += number;
  if (count == 0) return;
  notices.push_back(where.path.string() + ": " + std::to_string(count) +
                    " files belong to another scene and are ignored");
}

// A program that was killed may take a while to end: a lock is waited for, a second at most.
std::optional<FileLock> lockFolder(const HistoryFolder& where) {
  constexpr timespec kPause{0, 50'000'000};
  constexpr int kTries = 20;
  where.files->makePrivateFolder(where.path);
  where.files->syncFolder(folderOf(where.path));
  for (int n = 1;; ++n) {
    auto lock = FileLock::tryTake(where.path / undo::kLockFile, *where.files);
    if (lock || n == kTries) return lock;
    ::nanosleep(&kPause, nullptr);
  }
}

// A folder that is another scene's as a whole gets another name.
std::optional<FileLock> lockOwnFolder(const HistoryFolder& where,
                                      std::vector<std::string>& notices) {
  std::optional<FileLock> lock = lockFolder(where);
  if (!lock) return lock;
  const FolderListing listing = undo::listFolder(where.path, where.identity, *where.files);
  const bool foreign = !listing.strangers.empty() && listing.steps.empty() &&
                       listing.checkpoints.empty() && !listing.place;
  if (!foreign) return lock;
  const std::string aside = where.path.string() + "." + digitsOf(listing.strangers.begin()->first);
  where.files->rename(where.path, aside, Existing::refuse);
  where.files->syncFolder(folderOf(where.path));
  notices.push_back(where.path.string() + ": the history of another scene; kept as " + aside);
  return lockFolder(where);
}

}  // namespace

template <int Side>
OpenedHistory<Side> openHistory(const HistoryFolder& where,
                                const std::optional<SavedScene<Side>>& saved, HistoryAccess access,
                                const HistoryLimits& limits) {
  OpenedHistory<Side> opened;
  HistoryParts<Side> parts;
  parts.limits = limits;
  if (access == HistoryAccess::write) {
    parts.lock = lockOwnFolder(where, opened.notices);
    opened.readOnly = !parts.lock;
    if (parts.lock) removeLeftovers(where.path, *where.files);
  }
  FolderListing listing = undo::listFolder(where.path, where.identity, *where.files);
  noteStrangers(where, listing, opened.notices);
  Recovery<Side> recovery(where, saved, std::move(listing));
  recovery.run();

  const FolderListing& found = recovery.listing();
  opened.notices.insert(opened.notices.end(), found.notices.begin(), found.notices.end());
  opened.field = std::move(recovery.field);
  parts.anchors = recovery.anchors();
  parts.moment = recovery.latestMoment();
  parts.savedMoment = saved ? saved->place.moment : 0;
  if (saved && recovery.has(saved->place)) parts.saved = saved->place.place;
  parts.tree = std::move(recovery.tree);
  parts.scale = opened.field.scale;
  parts.beside = std::move(recovery.beside);
  parts.lastNumber = std::max(found.lastNumber, saved ? saved->place.place : 0);
  for (const auto& [state, head] : found.checkpoints)
    parts.lastNumber = std::max(parts.lastNumber, state);
  for (const std::string& name : found.names) {
    const StepNumber number = static_cast<StepNumber>(std::stoul(name));
    if (!name.ends_with(undo::kStepEnding) || parts.tree.find(number) != nullptr) continue;
    parts.lostSteps.push_back(number);
  }

  opened.recovered =
      saved ? parts.saved != parts.tree.place() : parts.tree.size() > 0 || parts.tree.root() != 0;
  opened.unsavedSteps = parts.saved ? parts.tree.path(*parts.saved, parts.tree.place()).size()
                                    : parts.tree.undoDepth();
  if (const Step* step = parts.tree.find(parts.tree.place())) opened.time = step->time;
  parts.files = where.files;
  parts.folder = where.path;
  if (parts.lock) {
    parts.journal = std::make_unique<Journal<Side>>(
        *where.files, where.path, where.identity,
        typename Journal<Side>::Start{opened.field.tree, parts.moment});
  }
  opened.history = History<Side>(std::move(parts));
  return opened;
}

template OpenedHistory<1> openHistory(const HistoryFolder&, const std::optional<SavedScene<1>>&,
                                      HistoryAccess, const HistoryLimits&);
template OpenedHistory<8> openHistory(const HistoryFolder&, const std::optional<SavedScene<8>>&,
                                      HistoryAccess, const HistoryLimits&);

std::optional<HistoryIdentity> identityOf(const std::filesystem::path& folder, FileSystem& files) {
  // Nobody's identity: all files are strangers then; of these the latest counts.
  std::optional<HistoryIdentity> latest;
  std::uint64_t moment = 0;
  std::vector<std::string> names;
  try {
    names = files.list(folder);
  } catch (const Error&) {
  }
  for (const std::string& name : names) {
    if (!name.ends_with(undo::kStepEnding) && !name.ends_with(undo::kCheckpointEnding)) continue;
    try {
      const FileHead head = undo::readHead(folder / name, files);
      if (latest && head.moment < moment) continue;
      latest = head.identity;
      moment = head.moment;
    } catch (const Error&) {
    }
  }
  return latest;
}

}  // namespace bozzetto
