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
constexpr int kRoundingBits = 30;  // of the mass pressed what may stay missing: 1e-9

template <int Side>
Key cornerIn(int n) {
  return {n / (Side * Side), n / Side % Side, n % Side};
}

BOZZETTO_KERNEL float risen(float value, float climb, float most, float way) {
  return lesser(value + way * climb, most);
}

struct Climbers {
  const float *value, *climb, *most;
  std::size_t count;
};

BOZZETTO_KERNEL MassUnits sumKernel(const Climbers& all, float way) {
  MassUnits sum = 0;
  for (std::size_t n = 0; n < all.count; ++n)
    sum += massUnits(risen(all.value[n], all.climb[n], all.most[n], way));
  return sum;
}

BOZZETTO_SIMD_DISPATCH(MassUnits, risenSum, sumKernel, (const Climbers& all, float way), (all, way))

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
  depth_ = makeStampDepth(dab_->tool, {o.profile, dab_->iso, rim, o.rise + o.fall});
  frame_ = depth_->frame(dab_->pose);
  const KeyBox box = dabBox(influenceOf(*depth_, dab_->pose));
  using Geometry = BlockGeometry<Side>;
  blocks_ = {Geometry::blockOf(box.low), Geometry::blockOf(box.high)};
  places_.clear();
  places_.resize(tableSize());
}

// In tables of the blocks and their rim.
template <int Side>
std::size_t ConservingStamp<Side>::indexOf(Key block) const {
  const Key at = block - blocks_.low + Key{1, 1, 1};
  const auto wideJ = static_cast<std::size_t>(blocks_.high.j - blocks_.low.j + 3);
  const auto wideK = static_cast<std::size_t>(blocks_.high.k - blocks_.low.k + 3);
  return (static_cast<std::size_t>(at.i) * wideJ + static_cast<std::size_t>(at.j)) * wideK +
         static_cast<std::size_t>(at.k);
}

// Counted from the dab's own cell.
template <int Side>
Key ConservingStamp<Side>::firstOf(Key block) const {
  return BlockGeometry<Side>::firstCornerOf(block) - frame_.cell;
}

template <int Side>
auto ConservingStamp<Side>::placeOf(Key block) -> const Place& {
  auto& made = places_[indexOf(block)];
  if (made == nullptr) {
    made = std::make_unique<Place>();
    depth_->evaluateWithBody(frame_, firstOf(block), Side, made->depth.data(), made->body.data());
    bend(block, *made);
  }
  return *made;
}

template <int Side>
auto ConservingStamp<Side>::sweptOf(Key block) const -> const SweptBlock<Side>& {
  if (dab_->swept == nullptr) return unswept<Side>();
  const auto found = dab_->swept->find(block);
  return found == dab_->swept->end() ? unswept<Side>() : found->second;
}

// How fast corners rise, and how far: not into the tool, nor where it has been.
template <int Side>
void ConservingStamp<Side>::bend(Key block, Place& place) const {
  const StampCurve curve(ofHeightOne(dab_->options), dab_->iso);
  const double surface = curve.surface();
  const double end = surface + widening_ * (curve.end() - surface);
  const float* swept = sweptOf(block).shares();
  for (std::size_t n = 0; n < place.depth.size(); ++n) {
    const double depth = static_cast<double>(place.depth[n]);
    const bool rim = depth >= surface && depth < end;
    const double bulge = rim ? curve(surface + (depth - surface) / widening_) : 0;
    const float most = hasWall() ? 1 : 1 - swept[n];
    place.curve[n] = most * static_cast<float>(std::clamp(bulge, 0.0, 1.0));
    place.most[n] = hasWall() ? 1 - std::max(swept[n], place.body[n]) : 1;
    place.rises = place.rises || place.curve[n] > 0;
  }
}

template <int Side>
template <class Visit>
void ConservingStamp<Side>::forBlocks(Visit&& visit) {
  for (auto i = blocks_.low.i; i <= blocks_.high.i; ++i)
    for (auto j = blocks_.low.j; j <= blocks_.high.j; ++j)
      for (auto k = blocks_.low.k; k <= blocks_.high.k; ++k) {
        const Key first = firstOf({i, j, k});
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
    if (edit_->read(block) != nullptr) pressBlock(block, placeOf(block));
  });
}

// Sculptures do, by radius.
template <int Side>
bool ConservingStamp<Side>::hasWall() const {
  return dab_->tool.sculpture != nullptr && dab_->options.profile == StampProfile::radius;
}

template <int Side>
void ConservingStamp<Side>::pressBlock(Key block, const Place& place) {
  const StampCurve curve(dab_->options, dab_->iso);
  const Block* old = edit_->read(block);
  for (int n = 0; n < Block::kCount; ++n) {
    const auto at = static_cast<std::size_t>(n);
    const float value = old->value[at];
    if (!(value > 0)) continue;
    const Attributes own = old->attributes[at];
    const float amount = pull(static_cast<float>(dab_->strength), 1.0f, own);
    const double d = static_cast<double>(place.depth[at]);
    const float made = hasWall() ? pressedTo(value, amount * place.body[at], place.body[at])
                                 : positive(value + amount * pressing(curve, d));
    if (made == value) continue;
    pressed_ += massUnits(value) - massUnits(made);
    write(block, n, made, own);
    old = open_;
  }
}

// Where the tool was, for the next dab.
template <int Side>
void ConservingStamp<Side>::sweep() {
  if (dab_->swept == nullptr) return;
  forBlocks([&](Key block) {
    const Key first = firstOf(block);
    if (depth_->bodyMisses(frame_, first, first + Key{Side - 1, Side - 1, Side - 1})) return;
    alignas(64) float body[Block::kCount];
    depth_->evaluateBody(frame_, first, Side, body);
    (*dab_->swept)[block].add(body);
  });
}

// Lists the corners that may rise.
template <int Side>
void ConservingStamp<Side>::look(double widening) {
  reachOut(widening);
  risers_.clear();
  value_.clear();
  climb_.clear();
  most_.clear();
  table_.assign(tableSize(), nullptr);
  const Key low = blocks_.low - Key{1, 1, 1}, high = blocks_.high + Key{1, 1, 1};
  for (auto i = low.i; i <= high.i; ++i)
    for (auto j = low.j; j <= high.j; ++j)
      edit_->visit({{i, j, low.k}, high.k - low.k + 1}, [&](KeyRun piece, const Block* block) {
        std::fill_n(table_.begin() + static_cast<std::ptrdiff_t>(indexOf(piece.key)), piece.length,
                    block);
      });
  forBlocks([&](Key block) {
    const Block* own = table_[indexOf(block)];
    if (own != nullptr && own->low >= 1) return;
    const Neighbourhood<Side> near = around(block);
    if (std::none_of(near.begin(), near.end(), [](auto* each) { return each; })) return;
    const Place& place = placeOf(block);
    if (place.rises) lookAt(block, place);
  });
  held_ = 0;
  held_ = gain(0);
}

template <int Side>
Neighbourhood<Side> ConservingStamp<Side>::around(Key block) const {
  Neighbourhood<Side> near;
  std::size_t n = 0;
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      for (int k = -1; k <= 1; ++k) near[n++] = table_[indexOf(block + Key{i, j, k})];
  return near;
}

template <int Side>
void ConservingStamp<Side>::lookAt(Key block, const Place& place) {
  const Block* own = table_[indexOf(block)];
  LowpassBuffer<Side> buffer;
  lowpass<Side>(around(block), buffer);
  for (std::size_t n = 0; n < place.curve.size(); ++n) {
    const float slope = buffer.result.climb[n];
    if (!(slope > 0) || !(place.curve[n] > 0)) continue;
    const float value = own == nullptr ? 0 : own->value[n];
    const Attributes held = own == nullptr ? 0 : own->attributes[n];
    const float climb = pull(static_cast<float>(dab_->strength), place.curve[n], held) * slope;
    if (value >= place.most[n] || value + kFarthestClimb * climb < kThinnestClay) continue;
    const int corner = static_cast<int>(n);
    risers_.push_back({block, corner, value > 0 ? held : colourAt(buffer.result, corner)});
    value_.push_back(value);
    climb_.push_back(climb);
    most_.push_back(place.most[n]);
  }
}

// By a layer that rises so far, in cells.
template <int Side>
MassUnits ConservingStamp<Side>::gain(float way) const {
  return risenSum({value_.data(), climb_.data(), most_.data(), value_.size()}, way) - held_;
}

// How many times higher than asked for the whole would lift the crest.
template <int Side>
double ConservingStamp<Side>::tooHigh(MassUnits mass) const {
  const double asked = dab_->options.height;
  const double layers = asked * static_cast<double>(kClimbPerDensity / kFarthestClimb);
  const double bulge = static_cast<double>(gain(kFarthestClimb)) * layers;
  return static_cast<double>(mass) / std::max(bulge, 1.0);
}

// Rims grow with the square of their width at most: steps by halves that surely are too few or just
// enough.
template <int Side>
double ConservingStamp<Side>::widened(double widening, MassUnits mass) const {
  for (double times = tooHigh(mass); times > 1; times /= 1.5 * 1.5) widening *= 1.5;
  const double wide = dab_->options.rise + dab_->options.fall;
  return std::min(widening, std::max(1.0, kWidest / wide));
}

// The way whose gain is the mass, or just under it.
template <int Side>
float ConservingStamp<Side>::wayFor(MassUnits mass) const {
  if (gain(kFarthestClimb) <= mass) return kFarthestClimb;
  float low = 0, high = kFarthestClimb;
  for (int step = 0; step < 24; ++step) {
    const float middle = 0.5f * (low + high);
    (gain(middle) <= mass ? low : high) = middle;
  }
  return low;
}

// Raises all; the last layer gives what rounding left over to some corners with room. Returns what
// it raised.
template <int Side>
MassUnits ConservingStamp<Side>::raise(float way, MassUnits mass) {
  const MassUnits rest = mass - gain(way);
  for (std::size_t n = 0; n < risers_.size(); ++n) {
    const float made = risen(value_[n], climb_[n], most_[n], way);
    const Riser& riser = risers_[n];
    if (made != value_[n]) write(riser.block, riser.corner, made, riser.attributes);
  }
  return mass - (way < kFarthestClimb ? raiseRest(way, rest) : rest);
}

// To the first few in the order of their keys: the same whatever the block side. Returns what finds
// no room.
template <int Side>
MassUnits ConservingStamp<Side>::raiseRest(float way, MassUnits rest) {
  constexpr std::size_t most = 256;
  const auto raised = [&](std::size_t n) { return risen(value_[n], climb_[n], most_[n], way); };
  const auto at = [&](std::size_t n) {
    return BlockGeometry<Side>::firstCornerOf(risers_[n].block) + cornerIn<Side>(risers_[n].corner);
  };
  std::vector<std::size_t> order;
  for (std::size_t n = 0; n < risers_.size(); ++n)
    if (raised(n) > 0 && raised(n) < most_[n]) order.push_back(n);
  const auto last = order.begin() + static_cast<std::ptrdiff_t>(std::min(most, order.size()));
  std::partial_sort(order.begin(), last, order.end(),
                    [&](std::size_t a, std::size_t b) { return at(a) < at(b); });
  for (auto each = order.begin(); each != last && rest > 0; ++each) {
    const float made = raised(*each);
    const auto more = static_cast<float>(static_cast<double>(rest) * kMassUnit);
    const float filled = lesser(made + more, most_[*each]);
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
  press();
  MassUnits rest = pressed_;
  const MassUnits rounding = pressed_ >> kRoundingBits;
  double widening = 1;
  for (int layer = 0; rest > rounding && layer < kMostLayers; ++layer) {
    look(widening);
    for (double next = widened(widening, rest); next > widening; next = widened(widening, rest)) {
      widening = next;
      look(widening);
    }
    const MassUnits raised = raise(wayFor(rest), rest);
    rest -= raised;
    if (raised <= 0) break;
  }
  sweep();
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
