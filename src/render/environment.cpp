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

// A lit panel at distance 1 in a direction, with rounded corners and a soft rim.
struct SoftBox {
  vec3 direction;
  vec2 half;
  float softness;
  vec3 colour;
  bool isFill;

  vec3 at(vec3 d) const;
};

const SoftBox kBoxes[] = {
    {{-.58f, .60f, .55f}, {.40f, .30f}, .10f, {9.5f, 8.9f, 8.0f}, false},   // key
    {{.88f, .02f, .46f}, {.26f, .70f}, .10f, {1.5f, 1.75f, 2.1f}, true},    // fill
    {{-.86f, .16f, -.50f}, {.13f, .85f}, .06f, {5.0f, 5.6f, 6.4f}, false},  // cool rim, left
    {{.80f, .30f, -.52f}, {.20f, .85f}, .06f, {7.0f, 6.3f, 5.4f}, false},   // warm rim, right
    {{.05f, .98f, .02f}, {.62f, .42f}, .15f, {2.3f, 2.35f, 2.5f}, true},    // top
};

vec3 SoftBox::at(vec3 d) const {
  const vec3 front = glm::normalize(direction);
  const float depth = glm::dot(d, front);
  if (depth < .05f) return vec3(0);
  const vec3 up = std::abs(front.y) > .9f ? vec3(0, 0, -1) : vec3(0, 1, 0);
  const vec3 right = glm::normalize(glm::cross(up, front)), top = glm::cross(front, right);
  const vec2 p = vec2(glm::dot(d, right), glm::dot(d, top)) / depth;
  const float corner = .4f * std::min(half.x, half.y);
  const float outside = glm::length(glm::max(glm::abs(p) - half + corner, vec2(0))) - corner;
  const float inside = 1 - glm::smoothstep(-softness, .4f * softness, outside);
  return colour * inside * (.75f + .25f * std::clamp(p.y / half.y, -1.f, 1.f));
}

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

// Environment seen in a mirror of GGX roughness that faces `r` and is looked at along it.
vec3 blurred(vec3 r, float roughness) {
  constexpr int kSamples = 96;
  const vec3 helper = std::abs(r.y) < .9f ? vec3(0, 1, 0) : vec3(1, 0, 0);
  const vec3 side = glm::normalize(glm::cross(helper, r)), up = glm::cross(r, side);
  const float a2 = std::pow(roughness, 4.f);
  vec3 sum(0);
  float weight = 0;
  for (int n = 0; n < kSamples; ++n) {
    const float e = (float(n) + .5f) / kSamples, angle = float(n) * kGoldenAngle;
    const float c = std::sqrt((1 - e) / (1 + (a2 - 1) * e)), s = std::sqrt(1 - c * c);
    const vec3 half = r * c + side * (s * std::cos(angle)) + up * (s * std::sin(angle));
    const vec3 light = half * (2 * glm::dot(r, half)) - r;
    const float facing = glm::dot(r, light);
    if (facing <= 0) continue;
    sum += environment(light) * facing;
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

vec3 environment(vec3 d, Boxes boxes) {
  vec3 c = glm::mix(vec3(.055f, .052f, .055f), vec3(.135f, .145f, .17f),
                    glm::smoothstep(-.35f, .25f, d.y));
  c = glm::mix(c, vec3(.23f, .26f, .32f), glm::smoothstep(.05f, .95f, d.y));
  c += vec3(.15f, .095f, .06f) * (1 - glm::smoothstep(-1.f, -.25f, d.y));
  for (const SoftBox& box : kBoxes) {
    if (boxes == Boxes::all || box.isFill) c += box.at(d);
  }
  return c;
}

std::array<vec3, 9> ambientHarmonics() {
  constexpr int kDirections = 6000;
  constexpr float kNorm[9] = {.282095f,  .488603f, .488603f,  .488603f, 1.092548f,
                              1.092548f, .315392f, 1.092548f, .546274f};
  constexpr float kCosine[9] = {1, 2 / 3.f, 2 / 3.f, 2 / 3.f, .25f, .25f, .25f, .25f, .25f};
  std::array<vec3, 9> sum{};
  for (int n = 0; n < kDirections; ++n) {
    const vec3 d = fibonacci(n, kDirections);
    const auto y = harmonicsAt(d);
    const vec3 c = environment(d, Boxes::fillOnly) * (4 * std::numbers::pi_v<float> / kDirections);
    for (int k = 0; k < 9; ++k) sum[k] += c * (y[k] * kNorm[k] * kNorm[k] * kCosine[k]);
  }
  return sum;
}

SphereMap reflectionMap() {
  SphereMap map;
  for (int level = 0; level < SphereMap::kLevels; ++level) {
    const int side = SphereMap::kSide >> level;
    map.level[level].resize(std::size_t(side * side));
    parallelFor(std::size_t(side), 4, [&](std::size_t begin, std::size_t end) {
      for (int y = int(begin); y < int(end); ++y) {
        for (int x = 0; x < side; ++x) {
          const vec3 r = sphereMapDirection((vec2(x, y) + .5f) / float(side));
          map.level[level][std::size_t(y * side + x)] =
              level == 0 ? environment(r) : blurred(r, float(level) / 5);
        }
      }
    });
  }
  return map;
}

}  // namespace bozzetto
