#include "tool/actions.hpp"
#include "tool/corner_loop.hpp"

namespace bozzetto {
namespace {

// Where all clay in reach has the tool's colour, or there is none, nothing needs blending.
struct AddRule {
  const float* potential;
  float strength;
  Attributes tool;

  BOZZETTO_KERNEL Corner operator()(Corner old, int n) const {
    const float amount = pull(strength, potential[n], old.attributes);
    const float sum = old.value + amount;
    const float value = lesser(sum, 1.0f);
    const Attributes painted = tool | (old.attributes & kHoldBits);
    const auto hit = positiveMask(amount);
    return {pick(hit, value, old.value), pick(hit, painted, old.attributes)};
  }
};

// Free clay of the tool's colour, or none.
struct AddValueRule {
  const float* potential;
  float strength;

  BOZZETTO_KERNEL float operator()(float old, int n) const {
    const float amount = strength * potential[n];
    return pick(positiveMask(amount), lesser(old + amount, 1.0f), old);
  }
};

struct AddBlendRule {
  const float* potential;
  float strength;
  Attributes tool;

  BOZZETTO_KERNEL Corner operator()(Corner old, int n) const {
    const float amount = pull(strength, potential[n], old.attributes);
    const float sum = old.value + amount;
    const float value = lesser(sum, 1.0f);
    const Attributes mixed =
        blended(old.attributes, tool, amount / sum, lessMask(1.0f / 64.0f, amount));
    const auto hit = positiveMask(amount);
    return {pick(hit, value, old.value), pick(hit, mixed, old.attributes)};
  }
};

class Add final : public Action {
 public:
  explicit Add(Colour colour) : tool_(packAttributes(colour)) {}

  bool leaves(const BlockSummary& block) const override {
    const bool full = block.uniform && block.value == 1;
    return full && (sameColour(block.attributes, tool_) || holdOf(block.attributes) == 255);
  }

  Outcome apply(const BlockView& block, float strength) const override {
    if (block.oneColour && (block.only == tool_ || block.only == 0))
      return runValues(block, AddValueRule{block.potential, strength}, tool_);
    if (meetsOtherColour(block, tool_))
      return run(block, AddBlendRule{block.potential, strength, tool_});
    return run(block, AddRule{block.potential, strength, tool_});
  }

 private:
  Attributes tool_;
};

}  // namespace

std::unique_ptr<Action> makeAdd(Colour colour) { return std::make_unique<Add>(colour); }

}  // namespace bozzetto
