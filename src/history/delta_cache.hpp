// What steps changed, held as block pointers, the longest unused first to go.
#pragma once
#include <map>
#include <memory>
#include <vector>

#include "bozzetto/history/step.hpp"
#include "history/step_change.hpp"

namespace bozzetto::undo {

template <int Side>
class DeltaCache {
 public:
  using Change = StepChange<Side>;

  void put(StepNumber step, Change change) {
    erase(step);
    const std::size_t bytes = bytesOf(change);
    bytes_ += bytes;
    byUse_[++clock_] = step;
    held_[step] = {std::move(change), bytes, clock_};
  }

  /// Nothing when it is not held.
  Change find(StepNumber step) {
    const auto held = held_.find(step);
    if (held == held_.end()) return {};
    byUse_.erase(held->second.used);
    byUse_[held->second.used = ++clock_] = step;
    return held->second.change;
  }

  /// What was held, or nothing.
  Change erase(StepNumber step) {
    const auto held = held_.find(step);
    if (held == held_.end()) return {};
    Change change = std::move(held->second.change);
    bytes_ -= held->second.bytes;
    byUse_.erase(held->second.used);
    held_.erase(held);
    return change;
  }

  /// Longest unused first.
  const std::map<std::uint64_t, StepNumber>& byUse() const { return byUse_; }
  std::size_t size() const { return held_.size(); }
  std::size_t bytes() const { return bytes_; }

 private:
  struct Held {
    Change change;
    std::size_t bytes = 0;
    std::uint64_t used = 0;
  };

  // Along a branch what is after a step is before the next: one side counts.
  static std::size_t bytesOf(const Change& change) {
    const std::size_t beside =
        change.before == change.after ? 0 : std::max(bytesOf(change.before), bytesOf(change.after));
    return bytesOf(*change.clay) + beside;
  }

  // Points with names, places and velocities; faces and cells are about as much again.
  static std::size_t bytesOf(const Beside& beside) {
    const SolidRef& solid = beside.solid;
    const std::size_t supports = beside.supports ? beside.supports->size() : 0;
    return supports + (solid ? solid->control.points.size() * 200 + sizeof(Solid) : 0);
  }

  static std::size_t bytesOf(const Delta<CornerBlock<Side>>& delta) {
    const auto own = [](const auto& block) { return block && !block->interned ? 1u : 0u; };
    std::size_t before = 0, after = 0;
    for (const auto& change : delta.changes) {
      before += own(change.before);
      after += own(change.after);
    }
    return std::max(before, after) * sizeof(CornerBlock<Side>) +
           delta.changes.size() * sizeof(delta.changes[0]);
  }

  std::map<StepNumber, Held> held_;
  std::map<std::uint64_t, StepNumber> byUse_;
  std::size_t bytes_ = 0;
  std::uint64_t clock_ = 0;
};

}  // namespace bozzetto::undo
