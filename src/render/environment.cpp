#include "render/environment.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <span>

#include "bozzetto/base/parallel.hpp"

namespace bozzetto {
namespace {

using glm::vec2;
using glm::vec3;

// The n-th of `count` directions spread evenly over the ball.
constexpr float kGoldenAngle = 2.3999632f;
vec3 fibonacci(int n, int count) {
  const float y = 1 - 2 * (float(n) + .5f) / float(count), r = std::sqrt(1 - y * y);
  const float angle = float(n) * kGoldenAngle;
  return {r * std::cos(angle), y, r * std::sin(angle)};
}

std::array<float, 9> harmonicsAt(vec3 d) {
  return {
      1, d.y, d.z, d.x, d.x * d.y, d.y * d.z, 3 * d.z * d.z - 1, d.x * d.z, d.x * d.x - d.y * d.y};
}

// Surroundings seen in a mirror of GGX roughness that faces `r` and is looked at along it.
vec3 blurred(const Surroundings& surroundings, vec3 r, float roughness, int samples) {
  const vec3 helper = std::abs(r.y) < .9f ? vec3(0, 1, 0) : vec3(1, 0, 0);
  const vec3 side = glm::normalize(glm::cross(helper, r)), up = glm::cross(r, side);
  const float a2 = std::pow(roughness, 4.f);
  vec3 sum(0);
  float weight = 0;
  for (int n = 0; n < samples; ++n) {
    const float e = (float(n) + .5f) / float(samples), angle = float(n) * kGoldenAngle;
    const float c = std::sqrt((1 - e) / (1 + (a2 - 1) * e)), s = std::sqrt(1 - c * c);
    const vec3 half = r * c + side * (s * std::cos(angle)) + up * (s * std::sin(angle));
    const vec3 light = half * (2 * glm::dot(r, half)) - r;
    const float facing = glm::dot(r, light);
    if (facing <= 0) continue;
    sum += surroundings.at(light) * facing;
    weight += facing;
  }
  return sum / weight;
}

vec3 sphereMapDirection(vec2 uv) {
  vec2 p = (uv - .5f) / .985f;
  p *= std::min(1.f, .4999f / std::max(glm::length(p), 1e-6f));
  const float r2 = glm::dot(p, p);
  return glm::normalize(vec3(p * (4 * std::sqrt(1 - 4 * r2)), 1 - 8 * r2));
}

}  // namespace

std::array<vec3, 9> ambientHarmonics(const Surroundings& surroundings) {
  constexpr int kDirections = 6000;
  constexpr float kNorm[9] = {.282095f,  .488603f, .488603f,  .488603f, 1.092548f,
                              1.092548f, .315392f, 1.092548f, .546274f};
  constexpr float kCosine[9] = {1, 2 / 3.f, 2 / 3.f, 2 / 3.f, .25f, .25f, .25f, .25f, .25f};
  std::array<vec3, 9> sum{};
  for (int n = 0; n < kDirections; ++n) {
    const vec3 d = fibonacci(n, kDirections);
    const auto y = harmonicsAt(d);
    const vec3 c =
        surroundings.at(d, Boxes::noLights) * (4 * std::numbers::pi_v<float> / kDirections);
    for (int k = 0; k < 9; ++k) sum[k] += c * (y[k] * kNorm[k] * kNorm[k] * kCosine[k]);
  }
  return sum;
}

SphereMap reflectionMap(const Surroundings& surroundings, MapQuality quality) {
  const int samples = quality == MapQuality::good ? 96 : 16;
  SphereMap map;
  for (int level = 0; level < SphereMap::kLevels; ++level) {
    const int side = SphereMap::kSide >> level;
    map.level[level].resize(std::size_t(side * side));
    parallelFor(std::size_t(side), 4, [&](std::size_t begin, std::size_t end) {
      for (int y = int(begin); y < int(end); ++y) {
        for (int x = 0; x < side; ++x) {
          const vec3 r = sphereMapDirection((vec2(x, y) + .5f) / float(side));
          map.level[level][std::size_t(y * side + x)] =
              level == 0 ? surroundings.at(r) : blurred(surroundings, r, float(level) / 5, samples);
        }
      }
    });
  }
  return map;
}

}  // namespace bozzetto
