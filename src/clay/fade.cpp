#include "clay/fade.hpp"

#include <algorithm>

namespace bozzetto::clay {

void fadeTowardsRim(Region& region, double cells) {
  const KeyBox inner = region.inner();
  region.fade = Cells<float>(static_cast<std::size_t>(region.box().count()));
  const auto scale = static_cast<float>(1 / std::max(1.0, cells));
  const auto depth = [&](Key key, Axis axis) {
    return std::min(key[axis] - inner.low[axis], inner.high[axis] - key[axis]);
  };
  for (Key key = inner.low; key.i <= inner.high.i; ++key.i)
    for (key.j = inner.low.j; key.j <= inner.high.j; ++key.j) {
      key.k = inner.low.k;
      const std::int32_t across = std::min(depth(key, Axis::x), depth(key, Axis::y));
      float* row = &region.fade[region.index(key)];
      for (; key.k <= inner.high.k; ++key.k) {
        const auto nearest = static_cast<float>(std::min(across, depth(key, Axis::z)));
        *row++ = std::min(1.0f, (nearest + 0.5f) * scale);
      }
    }
}

}  // namespace bozzetto::clay
