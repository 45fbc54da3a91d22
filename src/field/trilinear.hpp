// Trilinear interpolation over the eight corners of a cube, numbered as in grid/key.hpp. Written
// so that equal corners give their own value exactly.
#pragma once
#include <array>
#include <glm/vec3.hpp>

#include "bozzetto/grid/key.hpp"

namespace bozzetto {

constexpr Key cubeCorner(int n) { return {n >> 2, n >> 1 & 1, n & 1}; }

inline float mix(float a, float b, float t) { return a + (b - a) * t; }

inline float trilinear(const std::array<float, 8>& v, const glm::vec3& t) {
  const float j0 = mix(mix(v[0], v[1], t.z), mix(v[2], v[3], t.z), t.y);
  const float j1 = mix(mix(v[4], v[5], t.z), mix(v[6], v[7], t.z), t.y);
  return mix(j0, j1, t.x);
}

inline float trilinearWeight(int n, const glm::vec3& t) {
  return (n & 4 ? t.x : 1 - t.x) * (n & 2 ? t.y : 1 - t.y) * (n & 1 ? t.z : 1 - t.z);
}

}  // namespace bozzetto
