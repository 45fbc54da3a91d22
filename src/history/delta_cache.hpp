// Deltas held as block pointers, the longest unused first to go.
#pragma once
#include <map>
#include <memory>
#include <vector>

#include "bozzetto/history/step.hpp"

namespace bozzetto::undo {

template <int Side>
class DeltaCache {
 public:
  using DeltaPointer = std::shared_ptr<const Delta<CornerBlock<Side>>>;

  void put(StepNumber step, DeltaPointer delta) {
    erase(step);
    const std::size_t bytes = bytesOf(*delta);
    bytes_ += bytes;
    byUse_[++clock_] = step;
    held_[step] = {std::move(delta), bytes, clock_};
  }

  /// Null when it is not held.
  DeltaPointer find(StepNumber step) {
    const auto held = held_.find(step);
    if (held == held_.end()) return nullptr;
    byUse_.erase(held->second.used);
    byUse_[held->second.used = ++clock_] = step;
    return held->second.delta;
  }

  /// What was held, or null.
  DeltaPointer erase(StepNumber step) {
    const auto held = held_.find(step);
    if (held == held_.end()) return nullptr;
    DeltaPointer delta = std::move(held->second.delta);
    bytes_ -= held->second.bytes;
    byUse_.erase(held->second.used);
    held_.erase(held);
    return delta;
  }

  /// Longest unused first.
  const std::map<std::uint64_t, StepNumber>& byUse() const { return byUse_; }
  std::size_t size() const { return held_.size(); }
  std::size_t bytes() const { return bytes_; }

 private:
  struct Held {
    DeltaPointer delta;
    std::size_t bytes = 0;
    std::uint64_t used = 0;
  };

  // Along a branch the blocks after a step are those before the next: one side counts.
  static std::size_t bytesOf(const Delta<CornerBlock<Side>>& delta) {
    const auto own = [](const auto& block) { return block && !block->interned ? 1u : 0u; };
    std::size_t before = 0, after = 0;
    for (const auto& change : delta.changes) {
      before += own(change.before);
      after += own(change.after);
    }
    return std::max(before, after) * sizeof(CornerBlock<Side>) +
           delta.changes.size() * sizeof(Change<CornerBlock<Side>>);
  }

  std::map<StepNumber, Held> held_;
  std::map<std::uint64_t, StepNumber> byUse_;
  std::size_t bytes_ = 0;
  std::uint64_t clock_ = 0;
};

}  // namespace bozzetto::undo
