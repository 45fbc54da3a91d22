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

// Twice the density: a wall that slopes over a cell, and inside nothing is left of thin blades.
struct CutRule {
  const float* potential;

  BOZZETTO_KERNEL Corner operator()(Corner old, int n) const {
    const float left = lesser(old.value, positive(1.0f - 2.0f * potential[n]));
    return {pick(yieldMask(old.attributes), left, old.value), old.attributes};
  }
};

class Erase final : public Action {
 public:
  explicit Erase(ToolBody body) : body_(body) {}
  bool leaves(const BlockSummary& block) const override {
    return !block.present || (block.uniform && holdOf(block.attributes) >= kHardHold);
  }
  Outcome apply(const BlockView& block, float) const override {
    if (body_ == ToolBody::sculpture) return run(block, CutRule{block.potential});
    if (block.oneColour && holdOf(block.only) < kHardHold)
      return runValues(block, EraseValueRule{block.potential}, block.only);
    return run(block, EraseRule{block.potential});
  }

 private:
  ToolBody body_;
};

}  // namespace

std::unique_ptr<Action> makeErase(ToolBody body) { return std::make_unique<Erase>(body); }

}  // namespace bozzetto
