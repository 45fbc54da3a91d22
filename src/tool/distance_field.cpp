#include "tool/distance_field.hpp"

#include <algorithm>
#include <cmath>

#include "tool/density_grid.hpp"
#include "tool/eikonal.hpp"
#include "tool/float_bits.hpp"

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

namespace {

BOZZETTO_KERNEL float between(float a, float b, float t) { return a * (1.0f - t) + b * t; }

BOZZETTO_KERNEL void rowKernel(const float* grid, const std::array<int, 3>& wide,
                               const DistanceRow& places, float* distance) {
  const std::int32_t stride[3] = {wide[1] * wide[2], wide[2], 1};
  std::int32_t at[8] = {};
  float t[3][8];
  for (std::size_t a = 0; a < 3; ++a) {
    const float most = static_cast<float>(wide[a] - 1) - 0.001f;
    for (std::int32_t n = 0; n < 8; ++n) {
      const auto units = static_cast<float>(places.start[a] + n * places.step[a]);
      const float place = units * places.perUnit + places.offset[a];
      const float inside = lesser(positive(place), most);
      const auto corner = static_cast<std::int32_t>(inside);
      t[a][n] = inside - static_cast<float>(corner);
      at[n] += corner * stride[a];
    }
  }
  for (int n = 0; n < 8; ++n) {
    const float* cell = grid + at[n];
    const std::int32_t i = stride[0], j = stride[1];
    const float near = between(between(cell[0], cell[1], t[2][n]),
                               between(cell[j], cell[j + 1], t[2][n]), t[1][n]);
    const float far = between(between(cell[i], cell[i + 1], t[2][n]),
                              between(cell[i + j], cell[i + j + 1], t[2][n]), t[1][n]);
    distance[n] = between(near, far, t[0][n]) * places.scale;
  }
}

BOZZETTO_SIMD_DISPATCH(void, rowOf, rowKernel,
                       (const float* grid, const std::array<int, 3>& wide,
                        const DistanceRow& places, float* distance),
                       (grid, wide, places, distance))

}  // namespace

void DistanceField::row(const DistanceRow& places, int count, float* distance) const {
  if (count == 8) return rowOf(distance_.data(), wide_, places, distance);
  float all[8];
  rowOf(distance_.data(), wide_, places, all);
  std::copy_n(all, count, distance);
}

}  // namespace bozzetto
