#include "tool/actions.hpp"
#include "tool/corner_loop.hpp"

namespace bozzetto {
namespace {

struct PaintSoftRule {
  const float* potential;
  float strength;
  Attributes tool;

  BOZZETTO_KERNEL Corner operator()(Corner old, int n) const {
    const float amount = pull(strength, potential[n], old.attributes);
    const Attributes mixed = blended(old.attributes, tool, amount / (amount + old.value),
                                     lessMask(1.0f / 64.0f, amount));
    return {old.value, pick(positiveMask(amount), mixed, old.attributes)};
  }
};

class PaintSoft final : public Action {
 public:
  explicit PaintSoft(Colour colour) : tool_(packAttributes(colour)) {}

  bool leaves(const BlockSummary& block) const override {
    if (!block.present) return true;
    return block.uniform &&
           (sameColour(block.attributes, tool_) || holdOf(block.attributes) == 255);
  }
  Outcome apply(const BlockView& block, float strength) const override {
    if (!meetsOtherColour(block, tool_)) return {};
    return run(block, PaintSoftRule{block.potential, strength, tool_});
  }

 private:
  Attributes tool_;
};

}  // namespace

std::unique_ptr<Action> makePaintSoft(Colour colour) { return std::make_unique<PaintSoft>(colour); }

}  // namespace bozzetto
