// What a history forgets, and what it must not: the rotation of undo-files (Ferley §3.3),
// checkpoints, memory.
#include <algorithm>

#include "history/history_state.hpp"

namespace bozzetto {
namespace {

// Recovery goes over at most so much from the nearest checkpoint or save.
constexpr std::size_t kStepsBetweenAnchors = 500;
constexpr std::uint64_t kBytesBetweenAnchors = 256u << 20;

constexpr std::size_t kCheckpointsKept = 2;
constexpr std::size_t kLeastSteps = 10;    // stay undoable whatever the memory
constexpr std::size_t kMostSteps = 1'000;  // that have a file are held as blocks as well

}  // namespace

template <int Side>
void History<Side>::State::makeRoom() {
  takeNews();
  if (parts.journal) {
    const bool far =
        stepsSinceAnchor > kStepsBetweenAnchors || bytesSinceAnchor > kBytesBetweenAnchors;
    if (far) requestCheckpoint();
    rotate();
  }
  shrinkMemory();
}

template <int Side>
void History<Side>::State::takeNews() {
  if (!parts.journal) return;
  const auto news = parts.journal->news();
  for (const auto& written : news.written) {
    parts.tree.noteWritten(written.step, written.corners, written.bytes);
    bytesSinceAnchor += written.bytes;
  }
  if (news.checkpoint || news.checkpointFailed) checkpointRunning = false;
  if (!news.checkpoint) return;
  if (!parts.tree.has(*news.checkpoint)) {
    parts.journal->remove(undo::checkpointFileName(*news.checkpoint));
    return;
  }
  std::erase_if(parts.anchors, [&](const Anchor& a) { return a.state == *news.checkpoint; });
  parts.anchors.push_back({*news.checkpoint, true});
  const auto isFile = [](const Anchor& anchor) { return anchor.file; };
  while (std::ranges::count_if(parts.anchors, isFile) > std::ptrdiff_t{kCheckpointsKept}) {
    dropAnchor(std::ranges::find_if(parts.anchors, isFile)->state);
  }
}

template <int Side>
void History<Side>::State::requestCheckpoint() {
  if (!parts.journal || checkpointRunning) return;
  checkpointRunning = true;
  stepsSinceAnchor = 0;
  bytesSinceAnchor = 0;
  parts.journal->add(
      typename undo::Journal<Side>::CheckpointEvent{now(), parts.scale, parts.beside});
}

template <int Side>
bool History<Side>::State::overLimits() const {
  const std::size_t count = parts.tree.size() + parts.lostSteps.size();
  if (parts.limits.steps != 0 && count > parts.limits.steps) return true;
  return parts.limits.diskBytes != 0 && parts.tree.writtenBytes() > parts.limits.diskBytes;
}

// Recovery could start without this state too.
template <int Side>
bool History<Side>::State::anchoredWithout(StepNumber state) const {
  if (parts.saved && *parts.saved != state && parts.tree.has(*parts.saved)) return true;
  return std::ranges::any_of(parts.anchors, [&](const Anchor& a) { return a.state != state; });
}

// The oldest undo-files go; where recovery needs one a checkpoint is made first.
template <int Side>
void History<Side>::State::rotate() {
  while (overLimits()) {
    if (!parts.lostSteps.empty()) {
      removeStep(parts.lostSteps.front());
      parts.lostSteps.erase(parts.lostSteps.begin());
      continue;
    }
    const auto oldest = parts.tree.nextToDrop();
    if (!oldest || parts.tree.find(*oldest)->bytes == 0) return;
    if (!anchoredWithout(parts.tree.stateThatGoesWith(*oldest))) return requestCheckpoint();
    dropStep(*oldest);
  }
}

template <int Side>
void History<Side>::State::dropStep(StepNumber number) {
  forget(number);
  const StepNumber state = parts.tree.drop(number);
  if (parts.journal) {
    removeStep(number);
    dropAnchor(state);
  }
  if (parts.saved == state) parts.saved.reset();
}

// An undo-file, and its picture.
template <int Side>
void History<Side>::State::removeStep(StepNumber step) {
  parts.journal->remove(undo::stepFileName(step));
  parts.journal->remove(undo::pictureFileName(step));
}

template <int Side>
void History<Side>::State::dropAnchor(StepNumber state) {
  for (const Anchor& anchor : parts.anchors) {
    if (anchor.state == state && anchor.file) {
      parts.journal->remove(undo::checkpointFileName(state));
    }
  }
  std::erase_if(parts.anchors, [&](const Anchor& anchor) { return anchor.state == state; });
}

template <int Side>
void History<Side>::State::forget(StepNumber step) {
  letGo(cache.erase(step));
  pictures.erase(step);
  const auto inMemory = packed.find(step);
  if (inMemory == packed.end()) return;
  packedBytes -= inMemory->second.size();
  packed.erase(inMemory);
}

// Thousands of blocks are not freed on the caller's time.
template <int Side>
void History<Side>::State::letGo(Change change) {
  if (change.clay && parts.journal) parts.journal->release(std::move(change));
}

// Blocks that a file has go first; without a folder, old steps are packed, then forgotten.
template <int Side>
void History<Side>::State::shrinkMemory() {
  const auto tooMuch = [&] {
    return memoryBytes() > parts.limits.memoryBytes || (parts.journal && cache.size() > kMostSteps);
  };
  while (tooMuch() && packOldest()) {
  }
  while (!parts.journal && packedBytes > parts.limits.memoryBytes &&
         parts.tree.size() > kLeastSteps) {
    const auto oldest = parts.tree.nextToDrop();
    if (!oldest) return;
    dropStep(*oldest);
  }
}

// False when no delta can go.
template <int Side>
bool History<Side>::State::packOldest() {
  if (cache.size() <= kLeastSteps) return false;
  for (const auto& each : cache.byUse()) {
    const StepNumber number = each.second;  // its own: erasing takes the entry away
    const Step& step = *parts.tree.find(number);
    const bool written = step.bytes != 0 || packed.contains(number);
    if (!written && parts.journal) continue;
    Change change = cache.erase(number);
    if (!written) {
      undo::FileHead head;
      head.step = step;
      const Bytes beside = undo::encodeBesidePart(change.before, change.after);
      Bytes bytes = undo::encodeUndoFile<Side>(head, *change.clay, {{}, beside});
      bytes.shrink_to_fit();
      packedBytes += bytes.size();
      packed[number] = std::move(bytes);
    }
    letGo(std::move(change));
    return true;
  }
  return false;
}

template struct History<1>::State;
template struct History<8>::State;

}  // namespace bozzetto
