#include "tool/actions.hpp"
#include "tool/corner_loop.hpp"

namespace bozzetto {
namespace {

struct RemoveRule {
  const float* potential;
  float strength;

  BOZZETTO_KERNEL Corner operator()(Corner old, int n) const {
    const float rest = old.value - pull(strength, potential[n], old.attributes);
    return {positive(rest), old.attributes};
  }
};

// Free clay of one colour.
struct RemoveValueRule {
  const float* potential;
  float strength;

  BOZZETTO_KERNEL float operator()(float old, int n) const {
    return positive(old - strength * potential[n]);
  }
};

class Remove final : public Action {
 public:
  bool leaves(const BlockSummary& block) const override {
    return !block.present || (block.uniform && holdOf(block.attributes) == 255);
  }
  Outcome apply(const BlockView& block, float strength) const override {
    if (block.oneColour && holdOf(block.only) == 0)
      return runValues(block, RemoveValueRule{block.potential, strength}, block.only);
    return run(block, RemoveRule{block.potential, strength});
  }
};

}  // namespace

std::unique_ptr<Action> makeRemove() { return std::make_unique<Remove>(); }

}  // namespace bozzetto
