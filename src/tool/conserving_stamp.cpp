#include "tool/conserving_stamp.hpp"

#include <algorithm>
#include <cmath>

#include "tool/local_count.hpp"
#include "tool/lowpass.hpp"
#include "tool/mass_units.hpp"
#include "tool/stamp_weight.hpp"

namespace bozzetto {
namespace {

constexpr double kWidest = 4;  // reference radii
constexpr int kMostLayers = 64;

template <int Side>
Key cornerIn(int n) {
  return {n / (Side * Side), n / Side % Side, n % Side};
}

template <int Side>
Neighbourhood<Side> neighbourhoodOf(const KeyTree<CornerBlock<Side>>& tree, Key block) {
  Neighbourhood<Side> near;
  std::size_t n = 0;
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      for (int k = -1; k <= 1; ++k) near[n++] = tree.find(block + Key{i, j, k});
  return near;
}

}  // namespace

// Presses, where asked to, and lists the corners that may rise.
template <int Side>
void ConservingStamp<Side>::look(double widening, bool press) {
  widening_ = widening;
  risers_.clear();
  const StampOptions& o = dab_->options;
  const auto depth = makeStampDepth(
      dab_->tool, {o.profile, dab_->iso, std::min(kWidest, widening * (o.rise + o.fall))});
  const DabPose influence = influenceOf(*depth, dab_->pose);
  const KeyBox box = dabBox(influence);
  const LocalFrame frame = depth->frame(dab_->pose);
  if (press) {
    const LocalFrame local = localFrame(influence);
    visited_ = box.count();
    computed_ = countLocal(local, box.low - local.cell, box.high - local.cell);
  }
  using Geometry = BlockGeometry<Side>;
  const Key low = Geometry::blockOf(box.low), high = Geometry::blockOf(box.high);
  for (auto i = low.i; i <= high.i; ++i)
    for (auto j = low.j; j <= high.j; ++j)
      for (auto k = low.k; k <= high.k; ++k) {
        const Key first = Geometry::firstCornerOf({i, j, k}) - frame.cell;
        if (depth->misses(frame, first, first + Key{Side - 1, Side - 1, Side - 1})) continue;
        lookAt(*depth, frame, {i, j, k}, press);
      }
  // One order whatever the block side: what rounding leaves over goes to the first.
  std::ranges::sort(risers_, {}, &Riser::at);
}

template <int Side>
void ConservingStamp<Side>::lookAt(const Potential& depth, const LocalFrame& frame, Key block,
                                   bool press) {
  const Neighbourhood<Side> near = neighbourhoodOf<Side>(edit_->tree(), block);
  const bool clay = std::any_of(near.begin(), near.end(), [](auto* each) { return each; });
  const bool full = std::all_of(near.begin(), near.end(),
                                [](auto* each) { return each != nullptr && each->low >= 1; });
  if (!clay || (full && !press)) return;
  alignas(64) float d[Block::kCount];
  depth.evaluate(frame, BlockGeometry<Side>::firstCornerOf(block) - frame.cell, Side, d);
  const double surface = 1 - dab_->iso;
  const bool rim = std::any_of(d, d + Block::kCount,
                               [&](float each) { return static_cast<double>(each) >= surface; });
  if (rim && !full) {
    LowpassBuffer<Side> buffer;
    lowpass<Side>(near, buffer);
    for (int n = 0; n < Block::kCount; ++n) {
      const float value = near[13] == nullptr ? 0 : near[13]->value[std::size_t(n)];
      const Attributes own = near[13] == nullptr ? 0 : near[13]->attributes[std::size_t(n)];
      if (static_cast<double>(d[n]) < surface || value >= 1) continue;
      const float weight = riseWeight(buffer.result.value[n] / static_cast<float>(dab_->iso)) *
                           pull(static_cast<float>(dab_->strength), 1.0f, own);
      const float shape = weight * rimShape(static_cast<double>(d[n]));
      const Attributes colour = value > 0 ? own : colourAt(buffer.result, n);
      const Key at = BlockGeometry<Side>::firstCornerOf(block) + cornerIn<Side>(n);
      if (shape > 0) risers_.push_back({at, block, n, value, shape, colour});
    }
  }
  if (press && near[13] != nullptr) pressBlock(block, d);
}

// The bulge with height 1, its rim widened.
template <int Side>
float ConservingStamp<Side>::rimShape(double depth) const {
  StampOptions o = dab_->options;
  const double height = o.height > 0 ? o.height : 1, surface = 1 - dab_->iso;
  if (o.height <= 0) o.slope = 0;
  o.height = height;
  const double narrow = surface + (depth - surface) / widening_;
  return static_cast<float>(std::max(0.0, StampCurve(o, dab_->iso)(narrow) / height));
}

template <int Side>
void ConservingStamp<Side>::pressBlock(Key block, const float* depth) {
  const StampCurve curve(dab_->options, dab_->iso);
  const Block* old = edit_->read(block);
  for (int n = 0; n < Block::kCount; ++n) {
    const float value = old->value[std::size_t(n)];
    const double d = static_cast<double>(depth[n]);
    if (!(value > 0) || d >= curve.surface()) continue;
    const Attributes own = old->attributes[std::size_t(n)];
    const float amount = pull(static_cast<float>(dab_->strength), 1.0f, own);
    const float made = positive(value + amount * static_cast<float>(curve(d)));
    if (made == value) continue;
    pressed_ += massUnits(value) - massUnits(made);
    write(block, n, made, own);
    old = edit_->read(block);
  }
}

template <int Side>
MassUnits ConservingStamp<Side>::gain(double height) const {
  const auto high = static_cast<float>(height);
  MassUnits sum = 0;
  for (const Riser& riser : risers_)
    sum += massUnits(lesser(riser.value + high * riser.shape, 1.0f)) - massUnits(riser.value);
  return sum;
}

// The height whose gain is the mass, or just under it.
template <int Side>
double ConservingStamp<Side>::heightFor(MassUnits mass) const {
  double low = 0, high = kHighest;
  for (int n = 0; n < 60 && high - low > 1e-9 * high; ++n) {
    const double middle = 0.5 * (low + high);
    (gain(middle) <= mass ? low : high) = middle;
  }
  return low;
}

// Raises all, then gives what rounding left over to the first corners with room. Returns what it
// raised.
template <int Side>
MassUnits ConservingStamp<Side>::raise(double height, MassUnits mass) {
  MassUnits rest = mass - gain(height);
  const auto high = static_cast<float>(height);
  for (const Riser& riser : risers_) {
    float made = lesser(riser.value + high * riser.shape, 1.0f);
    if (rest > 0 && made < 1) {
      const auto more = static_cast<float>(static_cast<double>(rest) * kMassUnit);
      const float filled = lesser(made + more, 1.0f);
      const MassUnits taken = massUnits(filled) - massUnits(made);
      if (taken <= rest) {
        made = filled;
        rest -= taken;
      }
    }
    if (made != riser.value) write(riser.block, riser.corner, made, riser.attributes);
  }
  return mass - rest;
}

template <int Side>
void ConservingStamp<Side>::write(Key block, int corner, float value, Attributes attributes) {
  Block& out = edit_->write(block);
  const auto n = static_cast<std::size_t>(corner);
  out.value[n] = value;
  out.attributes[n] = value > 0 ? attributes : 0;
  ++dirty_;
  if (touched_.empty() || touched_.back() != block) touched_.push_back(block);
}

template <int Side>
void ConservingStamp<Side>::apply(DabReport& report) {
  const double wide = dab_->options.rise + dab_->options.fall;
  const double widest = std::max(1.0, kWidest / wide);
  look(1, true);
  MassUnits rest = pressed_;
  double widening = 1;
  for (int layer = 0; rest > 0 && layer < kMostLayers; ++layer) {
    look(widening, false);
    while (room() < rest && widening < widest) {
      widening = std::min(1.5 * widening, widest);
      look(widening, false);
    }
    if (risers_.empty()) break;
    const MassUnits raised = raise(heightFor(rest), rest);
    rest -= raised;
    if (raised <= 0) break;
  }
  std::ranges::sort(touched_);
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  for (const Key& block : touched_) {
    edit_->write(block).updateRange();
    report.changed.push_back(KeyRun{block, 1});
  }
  report.visited += visited_;
  report.computed += computed_;
  report.dirty += dirty_;
}

template class ConservingStamp<1>;
template class ConservingStamp<8>;

}  // namespace bozzetto
