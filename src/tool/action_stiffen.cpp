// Painted stiffness is clay of its own, value |o|, white where o > 0 and black where o < 0: what
// interpolates densities and colours interpolates o (clay/stiffness.hpp).
#include "tool/actions.hpp"
#include "tool/corner_loop.hpp"

namespace bozzetto {
namespace {

constexpr Attributes kWhite = kColourBits;
constexpr float kSteps = 127;  // from none to all

BOZZETTO_KERNEL float offsetAt(Corner corner) {
  const float white = static_cast<float>(static_cast<int>(corner.attributes & 255));
  return corner.value * (white * (2.0f / 255.0f) - 1.0f);
}

struct StiffenRule {
  const float* potential;
  float strength;
  float way;  // 1 stiffer, −1 softer

  BOZZETTO_KERNEL Corner operator()(Corner old, int n) const {
    // At least one step where more than a trace is asked for, so that slow strokes arrive.
    const float share = strength * potential[n];
    const int least = static_cast<int>(positiveMask(positive(share - 1.0f / 255))) & 1;
    const int before = nearest(offsetAt(old) * kSteps);
    const int grown = std::max(nearest(share * kSteps), least);
    const int after = std::clamp(before + static_cast<int>(way) * grown, -127, 127);
    const auto size = static_cast<float>(std::max(after, -after));
    return {size * (1.0f / kSteps), kWhite & static_cast<Attributes>(signMask(0 - after))};
  }
};

class Stiffen final : public Action {
 public:
  explicit Stiffen(float way) : way_(way) {}
  bool leaves(const BlockSummary& block) const override {
    return block.present && block.uniform && offsetAt({block.value, block.attributes}) == way_;
  }
  Outcome apply(const BlockView& block, float strength) const override {
    return run(block, StiffenRule{block.potential, strength, way_});
  }

 private:
  float way_;
};

}  // namespace

std::unique_ptr<Action> makeStiffen() { return std::make_unique<Stiffen>(1.0f); }
std::unique_ptr<Action> makeSoften() { return std::make_unique<Stiffen>(-1.0f); }

}  // namespace bozzetto
