#include "tool/actions.hpp"
#include "tool/corner_loop.hpp"

namespace bozzetto {
namespace {

struct PaintRule {
  const float* potential;
  Attributes tool;

  BOZZETTO_KERNEL Corner operator()(Corner old, int n) const {
    const auto hit = positiveMask(potential[n]) & yieldMask(old.attributes);
    const Attributes painted = tool | (old.attributes & kHoldBits);
    return {old.value, pick(hit, painted, old.attributes)};
  }
};

class Paint final : public Action {
 public:
  explicit Paint(Colour colour) : tool_(packAttributes(colour)) {}

  bool leaves(const BlockSummary& block) const override {
    if (!block.present) return true;
    return block.uniform &&
           (sameColour(block.attributes, tool_) || holdOf(block.attributes) >= kHardHold);
  }
  Outcome apply(const BlockView& block, float) const override {
    return run(block, PaintRule{block.potential, tool_});
  }

 private:
  Attributes tool_;
};

}  // namespace

std::unique_ptr<Action> makePaint(Colour colour) { return std::make_unique<Paint>(colour); }

}  // namespace bozzetto
