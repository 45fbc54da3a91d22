// Add and the paints with a colour of its own for every corner: what a sculpted tool brings along.
#include "tool/actions.hpp"
#include "tool/corner_loop.hpp"

namespace bozzetto {
namespace {

struct AddOwnRule {
  const float* potential;
  const Attributes* tool;
  float strength;

  BOZZETTO_KERNEL Corner operator()(Corner old, int n) const {
    const float amount = pull(strength, potential[n], old.attributes);
    const float sum = old.value + amount;
    const Attributes mixed =
        blended(old.attributes, tool[n], amount / sum, lessMask(1.0f / 64.0f, amount));
    const auto hit = positiveMask(amount);
    return {pick(hit, lesser(sum, 1.0f), old.value), pick(hit, mixed, old.attributes)};
  }
};

struct PaintOwnRule {
  const float* potential;
  const Attributes* tool;

  BOZZETTO_KERNEL Corner operator()(Corner old, int n) const {
    const auto hit = positiveMask(potential[n]) & yieldMask(old.attributes);
    const Attributes painted = (tool[n] & kColourBits) | (old.attributes & kHoldBits);
    return {old.value, pick(hit, painted, old.attributes)};
  }
};

struct PaintSoftOwnRule {
  const float* potential;
  const Attributes* tool;
  float strength;

  BOZZETTO_KERNEL Corner operator()(Corner old, int n) const {
    const float amount = pull(strength, potential[n], old.attributes);
    const Attributes mixed = blended(old.attributes, tool[n], amount / (amount + old.value),
                                     lessMask(1.0f / 64.0f, amount));
    return {old.value, pick(positiveMask(amount), mixed, old.attributes)};
  }
};

class OwnColours final : public Action {
 public:
  explicit OwnColours(ActionKind kind) : kind_(kind) {}

  bool leaves(const BlockSummary& block) const override {
    if (!block.present) return kind_ != ActionKind::add;
    return block.uniform && holdOf(block.attributes) == 255;
  }
  bool wantsColours() const override { return true; }

  Outcome apply(const BlockView& block, float strength) const override {
    const Attributes* tool = block.toolColours;
    if (kind_ == ActionKind::add) return run(block, AddOwnRule{block.potential, tool, strength});
    if (kind_ == ActionKind::paint) return run(block, PaintOwnRule{block.potential, tool});
    return run(block, PaintSoftOwnRule{block.potential, tool, strength});
  }

 private:
  ActionKind kind_;
};

}  // namespace

std::unique_ptr<Action> makeOwnColours(ActionKind kind) {
  return std::make_unique<OwnColours>(kind);
}

}  // namespace bozzetto
