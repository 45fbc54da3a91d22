#include "bozzetto/field/sampler.hpp"

#include <algorithm>
#include <cmath>

#include "field/trilinear.hpp"

namespace bozzetto {

CellPoint cellPoint(Key origin, glm::dvec3 offset) {
  CellPoint place;
  for (const Axis axis : kAxes) {
    const int a = index(axis);
    const double at = std::clamp(origin[axis] + std::floor(offset[a]), -double{kWorkspaceRim},
                                 double{kWorkspaceRim});
    place.base[axis] = static_cast<std::int32_t>(at);
    // A fraction that rounds up to 1 is the next corner.
    place.fraction[a] = static_cast<float>(offset[a] - std::floor(offset[a]));
    if (place.fraction[a] >= 1.0f) {
      place.fraction[a] = 0.0f;
      ++place.base[axis];
    }
  }
  return place;
}

template <int Side>
float FieldSampler<Side>::corner(Key key) {
  const auto* block = blocks_.find(BlockGeometry<Side>::blockOf(key));
  return block == nullptr ? 0.0f : block->value[BlockGeometry<Side>::indexOf(key)];
}

template <int Side>
Attributes FieldSampler<Side>::attributes(Key key) {
  const auto* block = blocks_.find(BlockGeometry<Side>::blockOf(key));
  return block == nullptr ? 0 : block->attributes[BlockGeometry<Side>::indexOf(key)];
}

template <int Side>
float FieldSampler<Side>::value(const CellPoint& place) {
  std::array<float, 8> corners;
  for (int n = 0; n < 8; ++n) corners[n] = corner(place.base + cubeCorner(n));
  return trilinear(corners, place.fraction);
}

template <int Side>
glm::vec3 FieldSampler<Side>::gradient(const CellPoint& place) {
  glm::vec3 result;
  for (const Axis axis : kAxes) {
    Key step;
    step[axis] = 1;
    std::array<float, 8> slope;
    for (int n = 0; n < 8; ++n) {
      const Key at = place.base + cubeCorner(n);
      slope[n] = 0.5f * (corner(at + step) - corner(at - step));
    }
    result[index(axis)] = trilinear(slope, place.fraction);
  }
  return result;
}

template <int Side>
Colour FieldSampler<Side>::colour(const CellPoint& place) {
  float weight = 0;
  glm::vec3 sum(0);
  for (int n = 0; n < 8; ++n) {
    const Key at = place.base + cubeCorner(n);
    const Colour c = colourOf(attributes(at));
    const float w = trilinearWeight(n, place.fraction) * corner(at);
    sum += w * glm::vec3(c.r, c.g, c.b);
    weight += w;
  }
  if (weight <= 0) return {0, 0, 0};
  const auto channel = [&](int c) { return static_cast<std::uint8_t>(sum[c] / weight + 0.5f); };
  return {channel(0), channel(1), channel(2)};
}

template class FieldSampler<1>;
template class FieldSampler<8>;

}  // namespace bozzetto
