// The stamp (Ferley §4.3): its potential is def(d) already.
#include "tool/actions.hpp"
#include "tool/corner_loop.hpp"
#include "tool/stamp_weight.hpp"

namespace bozzetto {
namespace {

// A bulge of density n lifts clay whose density falls by ½ a cell, as fills leave it, by n / ½
// cells. That way is what counts, however steep the clay has become: density added as such would
// catch on the cells, and rims of many dabs had terraces.
constexpr float kPerCell = 2.0f;
constexpr float kFarthest = 0.577f;  // cells a dab: beyond 1/√3 corners outgrow their neighbours
constexpr float kThinnest = 1e-4f;   // support that would grow a cell a dab

enum class Rise { densities, climbs };

template <Rise kRise>
struct StampRule {
  const float* def;
  float strength;
  Lowpass lowpass;
  float perIso;  // 1 / iso

  BOZZETTO_KERNEL Corner operator()(Corner old, int n) const {
    const float amount = pull(strength, 1.0f, old.attributes) * def[n];
    const float rise = raised(old.value, positive(amount), n);
    const float fall = positive(-amount);
    const float value = lesser(positive((old.value + rise) - fall), greater(old.value, 1.0f));
    const Attributes own = (old.attributes & kHoldBits) | colourAt(lowpass, n);
    return {value, pick(positiveMask(old.value), old.attributes, own)};
  }

  BOZZETTO_KERNEL float raised(float old, float amount, int n) const {
    if constexpr (kRise == Rise::densities) return amount * riseWeight(lowpass.value[n] * perIso);
    const float climbs = lesser(amount * kPerCell, kFarthest) * lowpass.climb[n];
    return pick(lessMask(old + climbs, kThinnest), 0.0f, climbs);
  }
};

class Stamp final : public Action {
 public:
  Stamp(StampProfile profile, double iso)
      : rise_(profile == StampProfile::paper ? Rise::densities : Rise::climbs),
        perIso_(static_cast<float>(1 / iso)) {}
  // Asked for blocks whose neighbours are all like them.
  bool leaves(const BlockSummary& block) const override {
    return !block.present || (block.uniform && holdOf(block.attributes) == 255);
  }
  bool wantsLowpass() const override { return true; }
  Outcome apply(const BlockView& block, float strength) const override {
    return rise_ == Rise::climbs ? with<Rise::climbs>(block, strength)
                                 : with<Rise::densities>(block, strength);
  }

 private:
  template <Rise kRise>
  Outcome with(const BlockView& block, float strength) const {
    return run(block, StampRule<kRise>{block.potential, strength, *block.lowpass, perIso_});
  }

  Rise rise_;
  float perIso_;
};

}  // namespace

std::unique_ptr<Action> makeStamp(StampProfile profile, double iso) {
  return std::make_unique<Stamp>(profile, iso);
}

}  // namespace bozzetto
