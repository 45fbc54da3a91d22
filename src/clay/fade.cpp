#include "clay/fade.hpp"

#include <algorithm>

namespace bozzetto::clay {
namespace {

constexpr std::int32_t kFar = 1 << 20;

// Whether clay goes on beyond that side of the region.
bool cuts(const Region& region, Axis axis, bool low) {
  KeyBox face = region.inner();
  face.low[axis] = face.high[axis] = low ? face.low[axis] - 1 : face.high[axis] + 1;
  for (Key key = face.low; key.i <= face.high.i; ++key.i)
    for (key.j = face.low.j; key.j <= face.high.j; ++key.j) {
      const float* row = &region.value[region.index({key.i, key.j, face.low.k})];
      if (std::any_of(row, row + (face.high.k - face.low.k + 1), [](float v) { return v > kThin; }))
        return true;
    }
  return false;
}

// How deep a cell lies behind the sides of one axis that cut clay.
struct Sides {
  std::int32_t low, high;
  bool cutLow, cutHigh;

  std::int32_t depth(std::int32_t at) const {
    return std::min(cutLow ? at - low : kFar, cutHigh ? high - at : kFar);
  }
};

}  // namespace

void fadeTowardsRim(Region& region, double cells) {
  const KeyBox inner = region.inner();
  region.fade = Cells<float>(static_cast<std::size_t>(region.box().count()));
  const auto scale = static_cast<float>(1 / std::max(1.0, cells));
  const auto sidesOf = [&](Axis axis) {
    return Sides{inner.low[axis], inner.high[axis], cuts(region, axis, true),
                 cuts(region, axis, false)};
  };
  const Sides x = sidesOf(Axis::x), y = sidesOf(Axis::y), z = sidesOf(Axis::z);
  for (Key key = inner.low; key.i <= inner.high.i; ++key.i)
    for (key.j = inner.low.j; key.j <= inner.high.j; ++key.j) {
      key.k = inner.low.k;
      const std::int32_t across = std::min(x.depth(key.i), y.depth(key.j));
      float* row = &region.fade[region.index(key)];
      for (; key.k <= inner.high.k; ++key.k) {
        const auto nearest = static_cast<float>(std::min(across, z.depth(key.k)));
        *row++ = std::min(1.0f, (nearest + 0.5f) * scale);
      }
    }
}

}  // namespace bozzetto::clay
