#include "tool/conserving_stamp.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "bozzetto/base/parallel.hpp"
#include "bozzetto/grid/key_box.hpp"
#include "tool/block_work.hpp"
#include "tool/handled_body.hpp"
#include "tool/local_count.hpp"
#include "tool/lowpass.hpp"
#include "tool/mass_units.hpp"
#include "tool/rise_kernels.hpp"
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

bool isAboveZero(float x) { return x > 0; }

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
ConservingStamp<Side>::ConservingStamp(Edit<Block>& edit, const Dab& dab)
    : edit_(&edit), dab_(&dab), curve_(ofHeightOne(dab.options), dab.iso) {}

template <int Side>
void ConservingStamp<Side>::reachOut(double widening) {
  if (widening == widening_) return;
  widening_ = widening;
  const StampOptions& o = dab_->options;
  const double rim = std::min(kWidest, widening * (o.rise + o.fall));
  // What is wider than asked for has no potential to lie in.
  const StampProfile profile = widening > 1 ? StampProfile::radius : o.profile;
  depth_ = makeStampDepth(dab_->tool, {profile, dab_->iso, rim, o.rise + o.fall, dab_->facing});
  frame_ = depth_->frame(dab_->pose);
  const KeyBox box = dabBox(influenceOf(*depth_, dab_->pose));
  using Geometry = BlockGeometry<Side>;
  blocks_ = {Geometry::blockOf(box.low), Geometry::blockOf(box.high)};
  places_.assign(tableSize(), nullptr);
  madeCount_ = 0;
  gatherTable();
  listBlocks();
}

template <int Side>
void ConservingStamp<Side>::gatherTable() {
  table_.assign(tableSize(), nullptr);
  const Key low = blocks_.low - Key{1, 1, 1}, high = blocks_.high + Key{1, 1, 1};
  for (auto i = low.i; i <= high.i; ++i)
    for (auto j = low.j; j <= high.j; ++j)
      edit_->visit({{i, j, low.k}, high.k - low.k + 1}, [&](KeyRun piece, const Block* block) {
        std::fill_n(table_.begin() + static_cast<std::ptrdiff_t>(indexOf(piece.key)), piece.length,
                    block);
      });
}

// Later ones join as they are written.
template <int Side>
void ConservingStamp<Side>::listBlocks() {
  listed_.clear();
  isListed_.assign(tableSize(), 0);
  forKeys(blocks_, [&](Key block) {
    const Faces<Side> near = facesOf(block);
    if (near[0] != nullptr && near[0]->low >= 1) return;
    if (std::ranges::any_of(near, [](auto* each) { return each != nullptr; })) join(block);
  });
}

template <int Side>
void ConservingStamp<Side>::join(Key block) {
  if (!blocks_.contains(block) || isListed_[indexOf(block)] != 0 || !reaches(block)) return;
  isListed_[indexOf(block)] = 1;
  listed_.push_back(block);
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
bool ConservingStamp<Side>::reaches(Key block) const {
  const Key first = firstOf(block);
  return !depth_->misses(frame_, first, first + Key{Side - 1, Side - 1, Side - 1});
}

template <int Side>
auto ConservingStamp<Side>::newPlace() -> Place& {
  const std::lock_guard lock(making_);
  if (madeCount_ == made_.size()) made_.emplace_back();
  return made_[madeCount_++];
}

// From several threads, each with its own blocks.
template <int Side>
auto ConservingStamp<Side>::placeOf(Key block) -> const Place& {
  const Place*& known = places_[indexOf(block)];
  if (known == nullptr) {
    Place& made = newPlace();
    known = &made;
    alignas(64) float depth[Block::kCount], body[Block::kCount];
    if (hasWall()) {
      depth_->evaluateWithBody(frame_, firstOf(block), Side, depth, body);
      withHandle(block, body);
    } else {
      depth_->evaluate(frame_, firstOf(block), Side, depth);
    }
    bend(block, depth, body, made);
  }
  return *known;
}

template <int Side>
auto ConservingStamp<Side>::sweptOf(Key block) const -> const SweptBlock<Side>& {
  if (dab_->swept == nullptr) return unswept<Side>();
  const auto found = dab_->swept->find(block);
  return found == dab_->swept->end() ? unswept<Side>() : found->second;
}

template <int Side>
void ConservingStamp<Side>::withHandle(Key block, float* body) const {
  if (!hasHandle()) return;
  const Block* const before = sweptOf(block).before(table_[indexOf(block)]);
  addHandle<Side>(*depth_, frame_, firstOf(block), before, body);
}

// How fast corners rise, and how far: not into the tool, nor where it has been.
template <int Side>
void ConservingStamp<Side>::bend(Key block, const float* depth, const float* body,
                                 Place& place) const {
  curve_.bulge(depth, Block::kCount, widening_, place.curve.data());
  place.rises = std::ranges::any_of(place.curve, isAboveZero);
  if (!place.rises) return;
  const float* swept = sweptOf(block).shares();
  const bool wall = hasWall();
  for (std::size_t n = 0; n < place.curve.size(); ++n) {
    place.most[n] = wall ? 1 - std::max(swept[n], body[n]) : 1;
    if (!wall) place.curve[n] *= 1 - swept[n];
  }
}

// What the tool itself may meet.
template <int Side>
template <class Visit>
void ConservingStamp<Side>::forBody(Visit&& visit) {
  forKeys(bodyBlocks_, [&](Key block) {
    const Key first = firstOf(block), last = first + Key{Side - 1, Side - 1, Side - 1};
    if (hasHandle() || !depth_->bodyMisses(frame_, first, last)) visit(block);
  });
}

template <int Side>
void ConservingStamp<Side>::press() {
  reachOut(1);
  bodyBlocks_ = blocks_;
  const DabPose influence = influenceOf(*depth_, dab_->pose);
  const KeyBox box = dabBox(influence);
  const LocalFrame local = localFrame(influence);
  visited_ = box.count();
  computed_ = countLocal(local, box.low - local.cell, box.high - local.cell);
  forBody([&](Key block) {
    if (table_[indexOf(block)] != nullptr) pressBlock(block);
  });
}

// Sculptures do, by radius.
template <int Side>
bool ConservingStamp<Side>::hasWall() const {
  return dab_->tool.sculpture != nullptr && dab_->options.profile == StampProfile::radius;
}

template <int Side>
void ConservingStamp<Side>::pressBlock(Key block) {
  const StampCurve curve(dab_->options, dab_->iso);
  const bool wall = hasWall();
  alignas(64) float place[Block::kCount];  // body or depth
  if (wall) {
    depth_->evaluateBody(frame_, firstOf(block), Side, place);
    withHandle(block, place);
  } else {
    depth_->evaluate(frame_, firstOf(block), Side, place);
  }
  const Block* old = table_[indexOf(block)];
  for (int n = 0; n < Block::kCount; ++n) {
    const auto at = static_cast<std::size_t>(n);
    const float value = old->value[at];
    if (!(value > 0)) continue;
    const Attributes own = old->attributes[at];
    const float amount = pull(static_cast<float>(dab_->strength), 1.0f, own);
    const float made =
        wall ? pressedTo(value, amount * place[at], place[at])
             : positive(value + amount * pressing(curve, static_cast<double>(place[at])));
    if (made == value) continue;
    pressed_ += massUnits(value) - massUnits(made);
    write(block, at, made);
    old = open_;
  }
}

// Where the tool was, for the next dab.
template <int Side>
void ConservingStamp<Side>::sweep() {
  if (dab_->swept == nullptr) return;
  forBody([&](Key block) {
    alignas(64) float body[Block::kCount];
    depth_->evaluateBody(frame_, firstOf(block), Side, body);
    withHandle(block, body);
    (*dab_->swept)[block].add(body);
  });
}

// Lists the corners that may rise: threads share the blocks out, and what they find is in the order
// of the blocks.
template <int Side>
void ConservingStamp<Side>::look(double widening) {
  constexpr std::size_t grain = Side == 1 ? 2048 : 32;
  reachOut(widening);
  risers_.resize(0);
  std::map<std::size_t, Risers> later;  // than those of the first range
  std::mutex adding;
  parallelFor(listed_.size(), grain, [&](std::size_t begin, std::size_t end) {
    Risers found;
    Risers& risers = begin == 0 ? risers_ : found;
    for (std::size_t n = begin; n < end; ++n) lookAt(n, risers);
    const std::lock_guard lock(adding);
    if (begin != 0) later.emplace(begin, std::move(found));
  });
  for (const auto& [begin, found] : later) risers_.append(found);
  held_ = 0;
  held_ = gain(0);
  layer_ = gain(kFarthestClimb);
}

template <int Side>
Faces<Side> ConservingStamp<Side>::facesOf(Key block) const {
  const std::size_t at = indexOf(block), k = 1;
  const std::size_t j = indexOf(block + Key{0, 1, 0}) - at, i = indexOf(block + Key{1, 0, 0}) - at;
  return {table_[at],     table_[at - i], table_[at + i], table_[at - j],
          table_[at + j], table_[at - k], table_[at + k]};
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

// The tool is asked where it lies only where there is clay to climb.
template <int Side>
void ConservingStamp<Side>::lookAt(std::size_t listed, Risers& risers) {
  const Key block = listed_[listed];
  const std::size_t at = indexOf(block);
  const Block* own = table_[at];
  if (own != nullptr && own->low >= 1) return;
  if (places_[at] != nullptr && !places_[at]->rises) return;
  alignas(64) float climb[Block::kCount];
  if (!climbOf<Side>(facesOf(block), climb)) return;
  const Place& place = placeOf(block);
  if (place.rises) addRisers(listed, place, climb, risers);
}

template <int Side>
void ConservingStamp<Side>::addRisers(std::size_t listed, const Place& place, const float* steep,
                                      Risers& risers) const {
  const Block* present = table_[indexOf(listed_[listed])];
  const Block& own = present == nullptr ? emptyBlock<Side>() : *present;
  alignas(64) std::array<float, Block::kCount> climb;
  std::copy_n(steep, climb.size(), climb.data());
  ratesOf({own.value.data(), place.most.data(), place.curve.data(), own.attributes.data(),
           static_cast<float>(dab_->strength)},
          Block::kCount, climb.data());
  const auto all = risers.size();
  const auto more = all + static_cast<std::size_t>(std::ranges::count_if(climb, isAboveZero));
  risers.resize(more);
  for (std::size_t n = 0, to = all; to < more; ++n) {
    if (!(climb[n] > 0)) continue;
    risers.place[to] = listed * Block::kCount + n;
    risers.value[to] = own.value[n];
    risers.climb[to] = climb[n];
    risers.most[to++] = place.most[n];
  }
}

// Corners that had no clay take the colour of the clay round them.
template <int Side>
void ConservingStamp<Side>::colour() {
  LowpassBuffer<Side> near;
  colours_.clear();
  std::size_t known = listed_.size();
  for (std::size_t n = 0; n < risers_.size(); ++n) {
    if (risers_.value[n] > 0) continue;
    const std::size_t listed = risers_.place[n] / Block::kCount;
    if (listed != known) lowpass<Side>(around(listed_[listed]), near);
    known = listed;
    colours_.push_back(colourAt(near.result, cornerOf(n)));
  }
}

// By a layer that rises so far, in cells.
template <int Side>
MassUnits ConservingStamp<Side>::gain(float way) const {
  return risenSum(risers_.climbers(), way) - held_;
}

// How many times higher than asked for the whole would lift the crest.
template <int Side>
double ConservingStamp<Side>::tooHigh(MassUnits mass) const {
  const double asked = dab_->options.height;
  const double layers = asked * static_cast<double>(kClimbPerDensity / kFarthestClimb);
  const double bulge = static_cast<double>(layer_) * layers;
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
  if (layer_ <= mass) return kFarthestClimb;
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
  const MassUnits rest = mass - (way < kFarthestClimb ? gain(way) : layer_);
  auto colour = colours_.begin();
  for (std::size_t n = 0; n < risers_.size(); ++n) {
    const float made = risen(risers_.value[n], risers_.climb[n], risers_.most[n], way);
    const Attributes fresh = risers_.value[n] > 0 ? 0 : *colour++;
    if (made == risers_.value[n]) continue;
    const auto corner = static_cast<std::size_t>(cornerOf(n));
    write(blockOf(n), corner, made);
    if (!(risers_.value[n] > 0)) open_->attributes[corner] = fresh;
  }
  return mass - (way < kFarthestClimb ? raiseRest(way, rest) : rest);
}

// To the first few in the order of their keys: the same whatever the block side. Returns what finds
// no room.
template <int Side>
MassUnits ConservingStamp<Side>::raiseRest(float way, MassUnits rest) {
  constexpr std::size_t most = 256;
  const auto raised = [&](std::size_t n) {
    return risen(risers_.value[n], risers_.climb[n], risers_.most[n], way);
  };
  struct Next {
    Key at;
    std::size_t riser;
  };
  const auto earlier = [](const Next& a, const Next& b) { return a.at < b.at; };
  std::vector<Next> order;  // some that come first, of those so far
  Key last{INT32_MAX, INT32_MAX, INT32_MAX};
  const auto shorten = [&] {
    const auto end = order.begin() + most;
    std::nth_element(order.begin(), end - 1, order.end(), earlier);
    order.erase(end, order.end());
    last = order.back().at;
  };
  for (std::size_t n = 0; n < risers_.size(); ++n) {
    const Key first = BlockGeometry<Side>::firstCornerOf(blockOf(n));
    if (last < first) continue;
    const Key key = first + cornerIn<Side>(cornerOf(n));
    if (last < key || !(raised(n) > 0 && raised(n) < risers_.most[n])) continue;
    order.push_back({key, n});
    if (order.size() == 4 * most) shorten();
  }
  if (order.size() > most) shorten();
  std::ranges::sort(order, earlier);
  for (auto each = order.begin(); each != order.end() && rest > 0; ++each) {
    const float made = raised(each->riser);
    const auto more = static_cast<float>(static_cast<double>(rest) * kMassUnit);
    const float filled = lesser(made + more, risers_.most[each->riser]);
    const MassUnits taken = massUnits(filled) - massUnits(made);
    if (taken <= 0 || taken > rest) continue;
    rest -= taken;
    write(blockOf(each->riser), static_cast<std::size_t>(cornerOf(each->riser)), filled);
  }
  return rest;
}

template <int Side>
void ConservingStamp<Side>::write(Key block, std::size_t corner, float value) {
  if (touched_.empty() || touched_.back() != block) open(block);
  open_->value[corner] = value;
  open_->low = std::min(open_->low, value);
  if (!(value > 0)) open_->attributes[corner] = 0;
  ++dirty_;
}

// What was empty lets clay climb into its neighbours.
template <int Side>
void ConservingStamp<Side>::open(Key block) {
  if (hasHandle()) (*dab_->swept)[block].note(table_[indexOf(block)]);
  open_ = &edit_->write(block);
  touched_.push_back(block);
  const bool had = std::exchange(table_[indexOf(block)], open_) != nullptr;
  join(block);
  if (had) return;
  for (const Axis axis : kAxes) {
    Key step;
    step[axis] = 1;
    join(block - step);
    join(block + step);
  }
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
    colour();
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
