#include "bozzetto/history/history.hpp"

#include <chrono>
#include <cstring>

#include "history/folder_listing.hpp"
#include "history/history_state.hpp"

namespace bozzetto {
namespace {

std::int64_t millisecondsNow() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::milliseconds>(now).count();
}

template <int Side>
HistoryParts<Side> inMemory(HistoryLimits limits) {
  HistoryParts<Side> parts;
  parts.limits = limits;
  return parts;
}

}  // namespace

template <int Side>
History<Side>::History(HistoryLimits limits) : History(inMemory<Side>(limits)) {}

template <int Side>
History<Side>::History(HistoryParts<Side> parts)
    : state_(std::make_unique<State>(std::move(parts))) {}

template <int Side>
History<Side>::History(History&&) noexcept = default;
template <int Side>
History<Side>& History<Side>::operator=(History&&) noexcept = default;
template <int Side>
History<Side>::~History() = default;

template <int Side>
StepNumber History<Side>::push(DeltaPointer delta, StepNote note, Beside beside, Bytes thumbnail) {
  State& state = *state_;
  const Step step = state.newStep(*delta, std::move(note));
  state.parts.tree.add(step);
  state.parts.tree.moveTo(step.number);
  state.parts.scale = step.note.after;
  typename State::Change change{std::move(delta), state.parts.beside, beside};
  state.parts.beside = std::move(beside);
  state.cache.put(step.number, change);
  if (state.parts.journal) {
    state.parts.journal->add(typename undo::Journal<Side>::StepEvent{
        state.parts.moment, step, std::move(change), std::move(thumbnail)});
  }
  state.makeRoom();
  return step.number;
}

template <int Side>
const StepTree& History<Side>::tree() const {
  return state_->parts.tree;
}

template <int Side>
const Beside& History<Side>::beside() const {
  return state_->parts.beside;
}

template <int Side>
void History<Side>::place(Beside beside) {
  state_->parts.beside = std::move(beside);
}

template <int Side>
std::vector<Step> History<Side>::steps() const {
  state_->takeNews();
  return tree().steps();
}

template <int Side>
Bytes History<Side>::thumbnail(StepNumber step) const {
  if (tree().find(step) == nullptr) return {};
  const auto held = state_->pictures.find(step);
  if (held != state_->pictures.end()) return held->second;
  if (state_->parts.files == nullptr) return {};
  FileSystem& files = *state_->parts.files;
  try {
    const auto later = state_->parts.folder / undo::pictureFileName(step);
    if (files.info(later)) return readFile(later, undo::kMostThumbnailBytes, files);
    const auto file = state_->parts.folder / undo::stepFileName(step);
    if (undo::readHead(file, files).thumbnailBytes == 0) return {};
    const Bytes bytes = state_->bytesOf(step);
    const auto picture = undo::UndoFile<Side>(bytes, "").thumbnail();
    return {picture.begin(), picture.end()};
  } catch (const Error&) {
    return {};
  }
}

template <int Side>
void History<Side>::setThumbnail(StepNumber step, Bytes png) {
  if (tree().find(step) == nullptr) return;
  if (state_->parts.journal) {
    state_->parts.journal->add(
        typename undo::Journal<Side>::PictureEvent{undo::pictureFileName(step), std::move(png)});
  } else {
    state_->pictures[step] = std::move(png);
  }
}

template <int Side>
typename History<Side>::Journey History<Side>::goTo(StepNumber target, Tree& clay,
                                                    const FieldScale& scale) {
  State& state = *state_;
  StepTree& tree = state.parts.tree;
  if (!tree.has(target)) {
    throw Error("step " + std::to_string(target) + ": not in the history");
  }
  Journey journey{nullptr, scale, ""};
  StepNumber reached = tree.place();
  Edit<Block> edit(clay);
  const auto legs = tree.path(tree.place(), target);
  const StepNumber lost = state.walk(
      legs, edit.tree(), state.parts.beside, journey.trouble,
      [&](const StepTree::Leg& leg, const Delta<Block>& delta) {
        const bool forward = leg.direction == Direction::forward;
        for (const auto& change : delta.changes) {
          edit.replace({change.key, change.length}, forward ? change.after : change.before);
        }
        const Step& step = *tree.find(leg.step);
        journey.scale = forward ? step.note.after : step.note.before;
        reached = forward ? step.number : step.parent;
      });
  journey.delta = std::make_shared<const Delta<Block>>(edit.commit());
  tree.moveTo(reached);
  state.parts.scale = journey.scale;
  ++state.parts.moment;
  if (lost != 0) state.cutOff(lost);
  if (state.parts.journal) {
    state.parts.journal->add(typename undo::Journal<Side>::MoveEvent{
        state.now(), state.parts.savedMoment, journey.delta});
  }
  state.makeRoom();
  return journey;
}

template <int Side>
Field<Side> History<Side>::fieldAt(StepNumber target, const Field<Side>& clay) {
  if (!tree().has(target)) {
    throw Error("step " + std::to_string(target) + ": not in the history");
  }
  Field<Side> field = clay;
  Beside beside = state_->parts.beside;
  std::string trouble;
  const auto legs = tree().path(tree().place(), target);
  state_->walk(legs, field.tree, beside, trouble,
               [&](const StepTree::Leg& leg, const Delta<Block>& delta) {
                 delta.apply(field.tree, leg.direction);
                 const StepNote& note = tree().find(leg.step)->note;
                 field.scale = leg.direction == Direction::forward ? note.after : note.before;
               });
  if (!trouble.empty()) throw Error(trouble);
  state_->makeRoom();
  return field;
}

template <int Side>
std::size_t History<Side>::memoryBytes() const {
  return state_->memoryBytes();
}

template <int Side>
bool History<Side>::onDisk() const {
  return state_->parts.journal != nullptr;
}

template <int Side>
std::filesystem::path History<Side>::folder() const {
  return state_->parts.folder;
}

template <int Side>
HistoryPlace History<Side>::savePlace() const {
  return state_->now();
}

template <int Side>
void History<Side>::markSaved(const HistoryPlace& place) {
  State& state = *state_;
  state.parts.saved = place.place;
  state.parts.savedMoment = place.moment;
  state.stepsSinceAnchor = 0;
  state.bytesSinceAnchor = 0;
  if (state.parts.journal) {
    state.parts.journal->add(
        typename undo::Journal<Side>::MoveEvent{state.now(), place.moment, nullptr});
  }
}

template <int Side>
std::optional<StepNumber> History<Side>::savedState() const {
  return state_->parts.saved;
}

template <int Side>
std::uint64_t History<Side>::moment() const {
  return state_->parts.moment;
}

template <int Side>
std::uint64_t History<Side>::durableMoment() const {
  return onDisk() ? state_->parts.journal->durableMoment() : 0;
}

template <int Side>
void History<Side>::waitDurable() {
  if (!onDisk()) return;
  state_->parts.journal->waitDurable(moment());
  state_->makeRoom();
}

template <int Side>
std::string History<Side>::trouble() const {
  return onDisk() ? state_->parts.journal->trouble() : "";
}

template <int Side>
HistoryPlace History<Side>::State::now() const {
  const StepTree& tree = parts.tree;
  return {tree.place(), tree.tip(), tree.markOf(tree.place()), parts.moment};
}

template <int Side>
Step History<Side>::State::newStep(const Delta<Block>& delta, StepNote note) {
  Step step;
  step.number = ++parts.lastNumber;
  step.parent = parts.tree.place();
  step.mark = random() | 1;  // never 0
  step.parentMark = parts.tree.markOf(step.parent);
  step.time = millisecondsNow();
  step.note = std::move(note);
  for (const auto& change : delta.changes) {
    step.changedBlocks += static_cast<std::uint64_t>(change.length);
  }
  ++parts.moment;
  ++stepsSinceAnchor;
  return step;
}

template <int Side>
Bytes History<Side>::State::bytesOf(StepNumber step) const {
  const auto inMemory = packed.find(step);
  if (inMemory != packed.end()) return inMemory->second;
  if (parts.files == nullptr) throw Error("step " + std::to_string(step) + ": not held");
  return readFile(parts.folder / undo::stepFileName(step), std::size_t{1} << 40, *parts.files);
}

template <int Side>
typename History<Side>::State::Change History<Side>::State::changeOf(const StepTree::Leg& leg,
                                                                     const Tree& clay,
                                                                     const Beside& beside) {
  if (Change held = cache.find(leg.step); held.clay) return held;
  const Bytes bytes = bytesOf(leg.step);
  const std::string name = parts.files == nullptr
                               ? "step " + std::to_string(leg.step)
                               : (parts.folder / undo::stepFileName(leg.step)).string();
  const undo::UndoFile<Side> file(bytes, name);
  if (file.head().step.mark != parts.tree.markOf(leg.step)) {
    throw Error(name + ": of another history");
  }
  Change change{std::make_shared<const Delta<Block>>(file.unpack(clay, leg.direction)), beside,
                file.beside(beside, leg.direction)};
  if (leg.direction == Direction::backward) std::swap(change.before, change.after);
  cache.put(leg.step, change);
  return change;
}

template <int Side>
template <class Take>
StepNumber History<Side>::State::walk(const std::vector<StepTree::Leg>& legs, const Tree& clay,
                                      Beside& beside, std::string& trouble, const Take& take) {
  for (const StepTree::Leg& leg : legs) {
    Change change;
    try {
      change = changeOf(leg, clay, beside);
    } catch (const Error& error) {
      trouble = error.what();
      return leg.step;
    }
    take(leg, *change.clay);
    beside = change.beside(leg.direction);
  }
  return 0;
}

// A step that cannot be read, and all that only it leads to.
template <int Side>
void History<Side>::State::cutOff(StepNumber lost) {
  for (const StepNumber step : parts.tree.cut(lost)) {
    forget(step);
    parts.lostSteps.push_back(step);
  }
  const auto gone = [&](const Anchor& anchor) { return !parts.tree.has(anchor.state); };
  std::erase_if(parts.anchors, gone);
  if (parts.saved && !parts.tree.has(*parts.saved)) parts.saved.reset();
  if (!anchoredWithout(0) && parts.tree.root() != 0) requestCheckpoint();
}

template class History<1>;
template class History<8>;

}  // namespace bozzetto
