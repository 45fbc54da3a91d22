#include "tool/actions.hpp"
#include "tool/corner_loop.hpp"

namespace bozzetto {
namespace {

struct EraseRule {
  const float* potential;

  BOZZETTO_KERNEL Corner operator()(Corner old, int n) const {
    const auto hit = positiveMask(potential[n]) & yieldMask(old.attributes);
    return {pick(hit, 0.0f, old.value), old.attributes};
  }
};

// Clay of one colour that yields.
struct EraseValueRule {
  const float* potential;

  BOZZETTO_KERNEL float operator()(float old, int n) const {
    return pick(positiveMask(potential[n]), 0.0f, old);
  }
};

class Erase final : public Action {
 public:
  bool leaves(const BlockSummary& block) const override {
    return !block.present || (block.uniform && holdOf(block.attributes) >= kHardHold);
  }
  Outcome apply(const BlockView& block, float) const override {
    if (block.oneColour && holdOf(block.only) < kHardHold)
      return runValues(block, EraseValueRule{block.potential}, block.only);
    return run(block, EraseRule{block.potential});
  }
};

}  // namespace

std::unique_ptr<Action> makeErase() { return std::make_unique<Erase>(); }

}  // namespace bozzetto
