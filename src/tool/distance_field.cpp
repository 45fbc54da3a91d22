#include "tool/distance_field.hpp"

#include <algorithm>
#include <cmath>

#include "tool/density_grid.hpp"
#include "tool/eikonal.hpp"

namespace bozzetto {

DistanceField::DistanceField(const Clay& clay, const KeyBox& bounds, float iso, int reach)
    : low_(bounds.low - Key{reach, reach, reach}) {
  std::size_t count = 1;
  for (const Axis axis : kAxes) {
    const auto a = static_cast<std::size_t>(bozzetto::index(axis));
    wide_[a] = bounds.high[axis] - bounds.low[axis] + 1 + 2 * reach;
    count *= static_cast<std::size_t>(wide_[a]);
  }
  density_.assign(count, 0);
  distance_.assign(count, kFarAway);
  fixed_.assign(count, 0);
  readDensities(clay, low_, wide_, density_);
  beginAtSurface(iso);
  sweepDistances(wide_, fixed_, 8, distance_);
  density_ = {};
  fixed_ = {};
}

// Corners inside have 0; those beside them the distance to the plane through the crossings on
// their edges.
void DistanceField::beginAtSurface(float iso) {
  const auto crossing = [&](float own, int i, int j, int k) {
    if (i < 0 || j < 0 || k < 0 || i >= wide_[0] || j >= wide_[1] || k >= wide_[2]) return kFarAway;
    const float other = density_[index(i, j, k)];
    return other >= iso ? (iso - own) / (other - own) : kFarAway;
  };
  for (int i = 0; i < wide_[0]; ++i)
    for (int j = 0; j < wide_[1]; ++j)
      for (int k = 0; k < wide_[2]; ++k) {
        const std::size_t at = index(i, j, k);
        const float own = density_[at];
        if (own >= iso) {
          distance_[at] = 0;
          fixed_[at] = 1;
          continue;
        }
        const float x = std::min(crossing(own, i - 1, j, k), crossing(own, i + 1, j, k));
        const float y = std::min(crossing(own, i, j - 1, k), crossing(own, i, j + 1, k));
        const float z = std::min(crossing(own, i, j, k - 1), crossing(own, i, j, k + 1));
        if (std::min({x, y, z}) >= kFarAway) continue;
        const auto inverse = [](float t) { return 1 / std::max(t * t, 1e-6f); };
        distance_[at] = 1 / std::sqrt(inverse(x) + inverse(y) + inverse(z));
        fixed_[at] = 1;
      }
}

void DistanceField::row(const GridRow& places, int count, float* distance) const {
  readRow(distance_.data(), wide_, places, count, distance);
}

}  // namespace bozzetto
