// The stamp (Ferley §4.3): its potential is def(d) already.
#include "tool/actions.hpp"
#include "tool/corner_loop.hpp"
#include "tool/stamp_weight.hpp"

namespace bozzetto {
namespace {

enum class Rise { densities, climbs };

// The print of a sculpture has its wall: what is pressed often is not pressed beyond it. Its
// density falls so fast that any curve of it would end on the cells.
struct SculptedStampRule {
  const float* def;
  const float* body;
  const float* swept;
  float strength;
  Lowpass lowpass;

  BOZZETTO_KERNEL Corner operator()(Corner old, int n) const {
    const float amount = pull(strength, 1.0f, old.attributes) * positive(def[n]);
    const float climbs = lesser(amount * kClimbPerDensity, kFarthestClimb) * lowpass.climb[n];
    const float rise = pick(lessMask(old.value + climbs, kThinnestClay), 0.0f, climbs);
    const float risen = lesser(old.value + rise, greater(old.value, 1.0f - swept[n]));
    const float pressed = risen - pull(strength, body[n], old.attributes);
    const float wall = lesser(risen, 1.0f - body[n]);
    const float value = pick(positiveMask(body[n]), greater(pressed, positive(wall)), risen);
    const Attributes own = (old.attributes & kHoldBits) | colourAt(lowpass, n);
    return {value, pick(positiveMask(old.value), old.attributes, own)};
  }
};

template <Rise kRise>
struct StampRule {
  const float* def;
  const float* swept;  // null where densities rise
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
    const float rises = amount * (1.0f - swept[n]);
    const float climbs = lesser(rises * kClimbPerDensity, kFarthestClimb) * lowpass.climb[n];
    return pick(lessMask(old + climbs, kThinnestClay), 0.0f, climbs);
  }
};

class Stamp final : public Action {
 public:
  Stamp(StampProfile profile, double iso, ToolBody body)
      : rise_(profile == StampProfile::paper ? Rise::densities : Rise::climbs),
        body_(body),
        perIso_(static_cast<float>(1 / iso)) {}
  // Asked for blocks whose neighbours are all like them.
  bool leaves(const BlockSummary& block) const override {
    return !block.present || (block.uniform && holdOf(block.attributes) == 255);
  }
  bool wantsLowpass() const override { return true; }
  bool wantsBody() const override { return rise_ == Rise::climbs; }
  Outcome apply(const BlockView& block, float strength) const override {
    if (rise_ == Rise::climbs && body_ == ToolBody::sculpture)
      return run(block, SculptedStampRule{block.potential, block.body, block.swept, strength,
                                          *block.lowpass});
    return rise_ == Rise::climbs ? with<Rise::climbs>(block, strength)
                                 : with<Rise::densities>(block, strength);
  }

 private:
  template <Rise kRise>
  Outcome with(const BlockView& block, float strength) const {
    return run(block,
               StampRule<kRise>{block.potential, block.swept, strength, *block.lowpass, perIso_});
  }

  Rise rise_;
  ToolBody body_;
  float perIso_;
};

}  // namespace

std::unique_ptr<Action> makeStamp(StampProfile profile, double iso, ToolBody body) {
  return std::make_unique<Stamp>(profile, iso, body);
}

}  // namespace bozzetto
