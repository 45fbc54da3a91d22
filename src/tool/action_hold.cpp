// Hold and its opposite: the strength is what comes of it, however often dabs overlap.
#include "tool/actions.hpp"
#include "tool/corner_loop.hpp"

namespace bozzetto {
namespace {

BOZZETTO_KERNEL Corner withHold(Corner old, int hold) {
  return {old.value, (old.attributes & kColourBits) | static_cast<Attributes>(hold) << 24};
}

// p of the way, and at least one step where that is more than a trace, so that it arrives.
BOZZETTO_KERNEL int stepOf(float potential, int way) {
  const int least = static_cast<int>(positiveMask(positive(potential - 1.0f / 255))) & 1;
  return std::min(way, std::max(nearest(potential * static_cast<float>(way)), least));
}

struct HoldRule {
  const float* potential;
  int wanted;

  BOZZETTO_KERNEL Corner operator()(Corner old, int n) const {
    const int hold = static_cast<int>(old.attributes >> 24);
    return withHold(old, hold + stepOf(potential[n], std::max(0, wanted - hold)));
  }
};

struct FreeRule {
  const float* potential;
  int wanted;

  BOZZETTO_KERNEL Corner operator()(Corner old, int n) const {
    const int hold = static_cast<int>(old.attributes >> 24);
    return withHold(old, hold - stepOf(potential[n], std::max(0, hold - wanted)));
  }
};

class Hold final : public Action {
 public:
  bool leaves(const BlockSummary& block) const override {
    return !block.present || (block.uniform && holdOf(block.attributes) == 255);
  }
  Outcome apply(const BlockView& block, float strength) const override {
    return run(block, HoldRule{block.potential, nearest(255 * strength)});
  }
};

class Free final : public Action {
 public:
  bool leaves(const BlockSummary& block) const override {
    return !block.present || (block.uniform && holdOf(block.attributes) == 0);
  }
  Outcome apply(const BlockView& block, float strength) const override {
    return run(block, FreeRule{block.potential, 255 - nearest(255 * strength)});
  }
};

}  // namespace

std::unique_ptr<Action> makeHold() { return std::make_unique<Hold>(); }
std::unique_ptr<Action> makeFree() { return std::make_unique<Free>(); }

}  // namespace bozzetto
