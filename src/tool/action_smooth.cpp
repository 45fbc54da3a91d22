#include "tool/actions.hpp"
#include "tool/corner_loop.hpp"
#include "tool/mass_units.hpp"

namespace bozzetto {
namespace {

// Thinner support is dropped, or it would grow a cell a dab.
constexpr float kThinnest = 1e-4f;

enum class Colours { one, many };

struct Smoothing {
  const float* potential;
  float strength;
  Lowpass lowpass;

  BOZZETTO_KERNEL float value(Corner old, float amount, int n) const {
    return old.value + amount * (lowpass.value[n] - old.value);
  }
};

template <Colours kColours>
struct SmoothRule {
  Smoothing smoothing;

  BOZZETTO_KERNEL Corner operator()(Corner old, int n) const {
    const float amount = pull(smoothing.strength, smoothing.potential[n], old.attributes);
    const float value = smoothing.value(old, amount, n);
    const float kept = pick(lessMask(value, kThinnest), 0.0f, value);
    const Attributes mixed = (old.attributes & kHoldBits) | colour(old, amount, n);
    const auto hit = positiveMask(amount);
    return {pick(hit, kept, old.value), pick(hit, mixed, old.attributes)};
  }

  // Colours mix by the density that brings them.
  BOZZETTO_KERNEL Attributes colour(Corner old, float amount, int n) const {
    if constexpr (kColours == Colours::one) return smoothing.lowpass.onlyColour;
    const float own = (1.0f - amount) * old.value;
    const float weight = own + amount * smoothing.lowpass.value[n];
    Attributes mixed = 0;
    for (int c = 0; c < 3; ++c) {
      const auto channel = static_cast<float>(static_cast<int>(old.attributes >> 8 * c & 255));
      const float sum = own * channel + amount * smoothing.lowpass.premultiplied[c][n];
      mixed |= static_cast<Attributes>(nearest(sum / weight) & 255) << 8 * c;
    }
    return mixed;
  }
};

BOZZETTO_KERNEL MassUnits droppedKernel(const BlockView& block, const Smoothing& smoothing) {
  MassUnits sum = 0;
  for (int n = 0; n < block.count; ++n) {
    const Corner old{block.value[n], block.attributes[n]};
    const float amount = pull(smoothing.strength, smoothing.potential[n], old.attributes);
    const float value = smoothing.value(old, amount, n);
    const auto gone = positiveMask(amount) & lessMask(value, kThinnest);
    sum += massUnits(pick(gone, value, 0.0f));
  }
  return sum;
}

BOZZETTO_SIMD_DISPATCH(MassUnits, droppedMass, droppedKernel,
                       (const BlockView& block, const Smoothing& smoothing), (block, smoothing))

class Smooth final : public Action {
 public:
  // Asked for blocks whose neighbours are all like them.
  bool leaves(const BlockSummary& block) const override { return !block.present || block.uniform; }
  bool wantsLowpass() const override { return true; }

  Outcome apply(const BlockView& block, float strength) const override {
    const Smoothing smoothing{block.potential, strength, *block.lowpass};
    const bool oneColour = block.lowpass->premultiplied[0] == nullptr;
    Outcome outcome = oneColour ? run(block, SmoothRule<Colours::one>{smoothing})
                                : run(block, SmoothRule<Colours::many>{smoothing});
    if (outcome.low <= 0) outcome.dropped = droppedMass(block, smoothing);
    return outcome;
  }
};

}  // namespace

std::unique_ptr<Action> makeSmooth() { return std::make_unique<Smooth>(); }

}  // namespace bozzetto
