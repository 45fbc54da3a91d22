#include "tool/actions.hpp"
#include "tool/corner_loop.hpp"

namespace bozzetto {
namespace {

struct HoldRule {
  const float* potential;
  float strength;

  BOZZETTO_KERNEL Corner operator()(Corner old, int n) const {
    const int hold = static_cast<int>(old.attributes >> 24);
    // At least one step where more than a trace is asked for, so that slow strokes arrive.
    const float share = strength * potential[n];
    const float wanted = share * static_cast<float>(255 - hold);
    const int least = static_cast<int>(positiveMask(positive(share - 1.0f / 255))) & 1;
    const int grown = std::min(255, hold + std::max(nearest(wanted), least));
    return {old.value, (old.attributes & kColourBits) | static_cast<Attributes>(grown) << 24};
  }
};

class Hold final : public Action {
 public:
  bool leaves(const BlockSummary& block) const override {
    return !block.present || (block.uniform && holdOf(block.attributes) == 255);
  }
  Outcome apply(const BlockView& block, float strength) const override {
    return run(block, HoldRule{block.potential, strength});
  }
};

}  // namespace

std::unique_ptr<Action> makeHold() { return std::make_unique<Hold>(); }

}  // namespace bozzetto
