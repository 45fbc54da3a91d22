// The stamp (Ferley §4.3): its potential is def(d) already.
#include "tool/actions.hpp"
#include "tool/corner_loop.hpp"
#include "tool/stamp_weight.hpp"

namespace bozzetto {
namespace {

struct StampRule {
  const float* def;
  float strength;
  Lowpass lowpass;
  float perIso;  // 1 / iso

  BOZZETTO_KERNEL Corner operator()(Corner old, int n) const {
    const float amount = pull(strength, 1.0f, old.attributes) * def[n];
    const float rise = positive(amount) * riseWeight(lowpass.value[n] * perIso);
    const float fall = positive(-amount);
    const float value = lesser(positive((old.value + rise) - fall), greater(old.value, 1.0f));
    const Attributes own = (old.attributes & kHoldBits) | colourAt(lowpass, n);
    return {value, pick(positiveMask(old.value), old.attributes, own)};
  }
};

class Stamp final : public Action {
 public:
  explicit Stamp(double iso) : perIso_(static_cast<float>(1 / iso)) {}
  // Asked for blocks whose neighbours are all like them.
  bool leaves(const BlockSummary& block) const override {
    return !block.present || (block.uniform && holdOf(block.attributes) == 255);
  }
  bool wantsLowpass() const override { return true; }
  Outcome apply(const BlockView& block, float strength) const override {
    return run(block, StampRule{block.potential, strength, *block.lowpass, perIso_});
  }

 private:
  float perIso_;
};

}  // namespace

std::unique_ptr<Action> makeStamp(double iso) { return std::make_unique<Stamp>(iso); }

}  // namespace bozzetto
