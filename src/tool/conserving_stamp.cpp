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
constexpr double kWall = 1.7321;   // cells that a sculpture's density reaches beyond its surface
constexpr int kRoundingBits = 30;  // of the mass pressed what may stay missing: 1e-9

template <int Side>
Key cornerIn(int n) {
  return {n / (Side * Side), n / Side % Side, n % Side};
}

BOZZETTO_KERNEL MassUnits sumKernel(const float* value, const float* shape, std::size_t count,
                                    float height) {
  MassUnits sum = 0;
  for (std::size_t n = 0; n < count; ++n)
    sum += massUnits(lesser(value[n] + height * shape[n], 1.0f));
  return sum;
}

BOZZETTO_SIMD_DISPATCH(MassUnits, raisedSum, sumKernel,
                       (const float* value, const float* shape, std::size_t count, float height),
                       (value, shape, count, height))

// The bulge with height 1.
StampOptions ofHeightOne(StampOptions options) {
  if (options.height <= 0)
    options.slope = 0;
  else
    options.slope /= options.height;
  options.height = 1;
  return options;
}

// A print does not go beyond the sculpture's own wall (action_stamp).
float pressedTo(float value, float amount, float body) {
  return std::max(value - amount, positive(std::min(value, 1 - body)));
}

float pressing(const StampCurve& curve, double depth) {
  return depth < curve.surface() ? static_cast<float>(curve(depth)) : 0;
}

}  // namespace

template <int Side>
void ConservingStamp<Side>::reachOut(double widening) {
  if (widening == widening_) return;
  widening_ = widening;
  const StampOptions& o = dab_->options;
  const double rim = std::min(kWidest, widening * (o.rise + o.fall));
  depth_ = makeStampDepth(dab_->tool, {o.profile, dab_->iso, rim});
  frame_ = depth_->frame(dab_->pose);
  const KeyBox box = dabBox(influenceOf(*depth_, dab_->pose));
  using Geometry = BlockGeometry<Side>;
  blocks_ = {Geometry::blockOf(box.low), Geometry::blockOf(box.high)};
  depths_.clear();
  depths_.resize(tableSize());
}

// In tables of the blocks and their rim.
template <int Side>
std::size_t ConservingStamp<Side>::placeOf(Key block) const {
  const Key at = block - blocks_.low + Key{1, 1, 1};
  const auto wideJ = static_cast<std::size_t>(blocks_.high.j - blocks_.low.j + 3);
  const auto wideK = static_cast<std::size_t>(blocks_.high.k - blocks_.low.k + 3);
  return (static_cast<std::size_t>(at.i) * wideJ + static_cast<std::size_t>(at.j)) * wideK +
         static_cast<std::size_t>(at.k);
}

template <int Side>
auto ConservingStamp<Side>::depthsOf(Key block) -> const Depths& {
  auto& made = depths_[placeOf(block)];
  if (made == nullptr) {
    made = std::make_unique<Depths>();
    depth_->evaluate(frame_, BlockGeometry<Side>::firstCornerOf(block) - frame_.cell, Side,
                     made->data());
  }
  return *made;
}

template <int Side>
template <class Visit>
void ConservingStamp<Side>::forBlocks(Visit&& visit) {
  for (auto i = blocks_.low.i; i <= blocks_.high.i; ++i)
    for (auto j = blocks_.low.j; j <= blocks_.high.j; ++j)
      for (auto k = blocks_.low.k; k <= blocks_.high.k; ++k) {
        const Key first = BlockGeometry<Side>::firstCornerOf({i, j, k}) - frame_.cell;
        if (depth_->misses(frame_, first, first + Key{Side - 1, Side - 1, Side - 1})) continue;
        visit(Key{i, j, k});
      }
}

template <int Side>
void ConservingStamp<Side>::press() {
  reachOut(1);
  const DabPose influence = influenceOf(*depth_, dab_->pose);
  const KeyBox box = dabBox(influence);
  const LocalFrame local = localFrame(influence);
  visited_ = box.count();
  computed_ = countLocal(local, box.low - local.cell, box.high - local.cell);
  forBlocks([&](Key block) {
    if (edit_->read(block) != nullptr) pressBlock(block, depthsOf(block));
  });
}

// Sculptures do, by radius; nothing rises where their density still is.
template <int Side>
bool ConservingStamp<Side>::hasWall() const {
  return dab_->tool.sculpture != nullptr && dab_->options.profile == StampProfile::radius;
}

template <int Side>
void ConservingStamp<Side>::pressBlock(Key block, const Depths& depth) {
  const StampCurve curve(dab_->options, dab_->iso);
  alignas(64) float body[Block::kCount];
  if (hasWall())
    depth_->evaluateBody(frame_, BlockGeometry<Side>::firstCornerOf(block) - frame_.cell, Side,
                         body);
  const Block* old = edit_->read(block);
  for (int n = 0; n < Block::kCount; ++n) {
    const float value = old->value[std::size_t(n)];
    if (!(value > 0)) continue;
    const Attributes own = old->attributes[std::size_t(n)];
    const float amount = pull(static_cast<float>(dab_->strength), 1.0f, own);
    const double d = static_cast<double>(depth[std::size_t(n)]);
    const float made = hasWall() ? pressedTo(value, amount * body[n], body[n])
                                 : positive(value + amount * pressing(curve, d));
    if (made == value) continue;
    pressed_ += massUnits(value) - massUnits(made);
    write(block, n, made, own);
    old = open_;
  }
}

// Lists the corners that may rise.
template <int Side>
void ConservingStamp<Side>::look(double widening) {
  reachOut(widening);
  risers_.clear();
  value_.clear();
  shape_.clear();
  table_.assign(tableSize(), nullptr);
  const Key low = blocks_.low - Key{1, 1, 1}, high = blocks_.high + Key{1, 1, 1};
  for (auto i = low.i; i <= high.i; ++i)
    for (auto j = low.j; j <= high.j; ++j)
      edit_->visit({{i, j, low.k}, high.k - low.k + 1}, [&](KeyRun piece, const Block* block) {
        std::fill_n(table_.begin() + static_cast<std::ptrdiff_t>(placeOf(piece.key)), piece.length,
                    block);
      });
  const StampCurve curve(ofHeightOne(dab_->options), dab_->iso);
  forBlocks([&](Key block) { lookAt(block, curve); });
  held_ = raisedSum(value_.data(), shape_.data(), value_.size(), 0);
}

template <int Side>
Neighbourhood<Side> ConservingStamp<Side>::around(Key block) const {
  Neighbourhood<Side> near;
  std::size_t n = 0;
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      for (int k = -1; k <= 1; ++k) near[n++] = table_[placeOf(block + Key{i, j, k})];
  return near;
}

template <int Side>
void ConservingStamp<Side>::lookAt(Key block, const StampCurve& curve) {
  const Neighbourhood<Side> near = around(block);
  const bool clay = std::any_of(near.begin(), near.end(), [](auto* each) { return each; });
  const Block* own = near[13];
  if (!clay || (own != nullptr && own->low >= 1)) return;
  const Depths& d = depthsOf(block);
  const double surface = 1 - dab_->iso;
  const double rimBegins = surface + (hasWall() ? kWall / referenceRadius(dab_->tool) : 0);
  const auto beyond = static_cast<float>(surface + widening_ * (curve.end() - surface));
  const bool rim = std::any_of(d.begin(), d.end(), [&](float each) {
    return static_cast<double>(each) >= surface && each < beyond;
  });
  if (!rim) return;
  LowpassBuffer<Side> buffer;
  lowpass<Side>(near, buffer);
  for (std::size_t n = 0; n < d.size(); ++n) {
    const float value = own == nullptr ? 0 : own->value[n];
    const double depth = static_cast<double>(d[n]);
    if (depth < rimBegins || d[n] >= beyond || value >= 1 || !(buffer.result.value[n] > 0))
      continue;
    const Attributes held = own == nullptr ? 0 : own->attributes[n];
    const float weight = riseWeight(buffer.result.value[n] / static_cast<float>(dab_->iso)) *
                         pull(static_cast<float>(dab_->strength), 1.0f, held);
    const double bulge = curve(surface + (depth - surface) / widening_);
    const float shape = weight * static_cast<float>(std::max(0.0, bulge));
    if (!(shape > 0)) continue;
    const int corner = static_cast<int>(n);
    const Attributes colour = value > 0 ? held : colourAt(buffer.result, corner);
    const Key at = BlockGeometry<Side>::firstCornerOf(block) + cornerIn<Side>(corner);
    risers_.push_back({at, block, corner, colour});
    value_.push_back(value);
    shape_.push_back(shape);
  }
}

template <int Side>
MassUnits ConservingStamp<Side>::gain(double height) const {
  return raisedSum(value_.data(), shape_.data(), value_.size(), static_cast<float>(height)) - held_;
}

// The height whose gain is the mass, or just under it.
template <int Side>
double ConservingStamp<Side>::heightFor(MassUnits mass) const {
  double low = 0, high = 1;
  while (high < kHighest && gain(high) <= mass) {
    low = high;
    high *= 4;
  }
  while (high - low > 1e-8 * high) {
    const double middle = 0.5 * (low + high);
    (gain(middle) <= mass ? low : high) = middle;
  }
  return low;
}

// Raises all, then gives what rounding left over to some corners with room. Returns what it raised.
template <int Side>
MassUnits ConservingStamp<Side>::raise(double height, MassUnits mass) {
  const auto high = static_cast<float>(height);
  const MassUnits rest = mass - gain(height);
  for (std::size_t n = 0; n < risers_.size(); ++n) {
    const float made = lesser(value_[n] + high * shape_[n], 1.0f);
    const Riser& riser = risers_[n];
    if (made != value_[n]) write(riser.block, riser.corner, made, riser.attributes);
  }
  return mass - raiseRest(height, rest);
}

// To the first few in the order of their keys: the same whatever the block side. Returns what finds
// no room.
template <int Side>
MassUnits ConservingStamp<Side>::raiseRest(double height, MassUnits rest) {
  constexpr std::size_t most = 256;
  const auto high = static_cast<float>(height);
  const auto raised = [&](std::size_t n) { return lesser(value_[n] + high * shape_[n], 1.0f); };
  std::vector<std::size_t> order;
  for (std::size_t n = 0; n < risers_.size(); ++n)
    if (raised(n) < 1) order.push_back(n);
  const auto last = order.begin() + static_cast<std::ptrdiff_t>(std::min(most, order.size()));
  std::partial_sort(order.begin(), last, order.end(),
                    [&](std::size_t a, std::size_t b) { return risers_[a].at < risers_[b].at; });
  for (auto each = order.begin(); each != last && rest > 0; ++each) {
    const float made = raised(*each);
    const auto more = static_cast<float>(static_cast<double>(rest) * kMassUnit);
    const float filled = lesser(made + more, 1.0f);
    const MassUnits taken = massUnits(filled) - massUnits(made);
    if (taken <= 0 || taken > rest) continue;
    rest -= taken;
    const Riser& riser = risers_[*each];
    write(riser.block, riser.corner, filled, riser.attributes);
  }
  return rest;
}

template <int Side>
void ConservingStamp<Side>::write(Key block, int corner, float value, Attributes attributes) {
  if (touched_.empty() || touched_.back() != block) {
    open_ = &edit_->write(block);
    touched_.push_back(block);
  }
  const auto n = static_cast<std::size_t>(corner);
  open_->value[n] = value;
  open_->low = std::min(open_->low, value);
  open_->attributes[n] = value > 0 ? attributes : 0;
  ++dirty_;
}

template <int Side>
void ConservingStamp<Side>::apply(DabReport& report) {
  const double wide = dab_->options.rise + dab_->options.fall;
  const double widest = std::max(1.0, kWidest / wide);
  press();
  MassUnits rest = pressed_;
  const MassUnits rounding = pressed_ >> kRoundingBits;
  double widening = 1;
  for (int layer = 0; rest > rounding && layer < kMostLayers; ++layer) {
    look(widening);
    while (room() < rest && widening < widest) {
      widening = std::min(1.5 * widening, widest);
      look(widening);
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
