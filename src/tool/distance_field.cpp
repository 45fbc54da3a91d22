#include "tool/distance_field.hpp"

#include <algorithm>
#include <cmath>

namespace bozzetto {
namespace {

constexpr float kFar = 1e9f;

}  // namespace

DistanceField::DistanceField(const Clay& clay, const KeyBox& bounds, float iso, int reach)
    : low_(bounds.low - Key{reach, reach, reach}) {
  std::size_t count = 1;
  for (const Axis axis : kAxes) {
    const auto a = static_cast<std::size_t>(bozzetto::index(axis));
    wide_[a] = bounds.high[axis] - bounds.low[axis] + 1 + 2 * reach;
    count *= static_cast<std::size_t>(wide_[a]);
  }
  density_.assign(count, 0);
  distance_.assign(count, kFar);
  fixed_.assign(count, false);
  readDensity(clay);
  beginAtSurface(iso);
  sweep();
  density_ = {};
  fixed_ = {};
}

void DistanceField::readDensity(const Clay& clay) {
  for (const auto& [key, run] : clay.tree)
    for (std::int32_t n = 0; n < run.length; ++n) {
      const Key first = BlockGeometry<8>::firstCornerOf(key + Key{0, 0, n}) - low_;
      for (int c = 0; c < 512; ++c) {
        const Key at = first + Key{c >> 6, c >> 3 & 7, c & 7};
        const bool inside = at.i >= 0 && at.j >= 0 && at.k >= 0 && at.i < wide_[0] &&
                            at.j < wide_[1] && at.k < wide_[2];
        if (inside) density_[index(at.i, at.j, at.k)] = run.block->value[std::size_t(c)];
      }
    }
}

// Corners inside have 0; those beside them the distance to the plane through the crossings on
// their edges.
void DistanceField::beginAtSurface(float iso) {
  const auto crossing = [&](float own, int i, int j, int k) {
    if (i < 0 || j < 0 || k < 0 || i >= wide_[0] || j >= wide_[1] || k >= wide_[2]) return kFar;
    const float other = density_[index(i, j, k)];
    return other >= iso ? (iso - own) / (other - own) : kFar;
  };
  for (int i = 0; i < wide_[0]; ++i)
    for (int j = 0; j < wide_[1]; ++j)
      for (int k = 0; k < wide_[2]; ++k) {
        const std::size_t at = index(i, j, k);
        const float own = density_[at];
        if (own >= iso) {
          distance_[at] = 0;
          fixed_[at] = true;
          continue;
        }
        const float x = std::min(crossing(own, i - 1, j, k), crossing(own, i + 1, j, k));
        const float y = std::min(crossing(own, i, j - 1, k), crossing(own, i, j + 1, k));
        const float z = std::min(crossing(own, i, j, k - 1), crossing(own, i, j, k + 1));
        if (std::min({x, y, z}) >= kFar) continue;
        const auto inverse = [](float t) { return 1 / std::max(t * t, 1e-6f); };
        distance_[at] = 1 / std::sqrt(inverse(x) + inverse(y) + inverse(z));
        fixed_[at] = true;
      }
}

float DistanceField::nearest(int i, int j, int k, int axis) const {
  int low[3] = {i, j, k}, high[3] = {i, j, k};
  --low[axis];
  ++high[axis];
  const float a = low[axis] >= 0 ? distance_[index(low[0], low[1], low[2])] : kFar;
  const float b =
      high[axis] < wide_[std::size_t(axis)] ? distance_[index(high[0], high[1], high[2])] : kFar;
  return std::min(a, b);
}

// |∇d| = 1 upwind (Zhao 2005, "A fast sweeping method for Eikonal equations").
void DistanceField::relax(int i, int j, int k) {
  const std::size_t at = index(i, j, k);
  if (fixed_[at]) return;
  float n[3] = {nearest(i, j, k, 0), nearest(i, j, k, 1), nearest(i, j, k, 2)};
  std::sort(n, n + 3);
  float d = n[0] + 1;
  if (d > n[1]) {
    const float difference = n[1] - n[0];
    d = 0.5f * (n[0] + n[1] + std::sqrt(std::max(2 - difference * difference, 0.0f)));
    if (d > n[2]) {
      const float sum = n[0] + n[1] + n[2];
      const float squares = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
      d = (sum + std::sqrt(std::max(sum * sum - 3 * (squares - 1), 0.0f))) / 3;
    }
  }
  distance_[at] = std::min(distance_[at], d);
}

void DistanceField::sweep() {
  for (int order = 0; order < 8; ++order) {
    const auto along = [&](int axis, int n) {
      return (order >> axis & 1) != 0 ? wide_[std::size_t(axis)] - 1 - n : n;
    };
    for (int i = 0; i < wide_[0]; ++i)
      for (int j = 0; j < wide_[1]; ++j)
        for (int k = 0; k < wide_[2]; ++k) relax(along(0, i), along(1, j), along(2, k));
  }
}

float DistanceField::at(float x, float y, float z) const {
  const float place[3] = {x, y, z};
  int corner[3];
  float t[3];
  for (int a = 0; a < 3; ++a) {
    const float most = static_cast<float>(wide_[std::size_t(a)] - 1) - 0.001f;
    const float inside = std::clamp(place[a], 0.0f, most);
    corner[a] = static_cast<int>(inside);
    t[a] = inside - static_cast<float>(corner[a]);
  }
  float sum = 0;
  for (int c = 0; c < 8; ++c) {
    const int i = c >> 2, j = c >> 1 & 1, k = c & 1;
    const float weight = (i ? t[0] : 1 - t[0]) * (j ? t[1] : 1 - t[1]) * (k ? t[2] : 1 - t[2]);
    sum += weight * distance_[index(corner[0] + i, corner[1] + j, corner[2] + k)];
  }
  return sum;
}

}  // namespace bozzetto
