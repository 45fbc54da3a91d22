// Per-vertex light: six cones through the pyramid (the hemisphere with cosine weights), and the
// mean curvature at three scales for free: a blurred occupancy is ½ on a flat face, more in
// creases, less on ridges.
#include "bozzetto/render/occlusion.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>

#include "bozzetto/base/parallel.hpp"
#include "render/density_window.hpp"

namespace bozzetto {
namespace {

using glm::vec3;

constexpr int kRegionShift = 5;    // vertices of 32³ cells share a window
constexpr float kUpWeight = .25f;  // of the cone along the normal; the ring shares the rest
constexpr int ringOf(LightDetail detail) { return detail == LightDetail::good ? 5 : 3; }
// Scale and exponent fitted against 96 rays (correlation .945): a plane is open.
constexpr float kPlaneSum = .91f, kExponent = .8f;

struct Hemisphere {
  vec3 up, side, front;
  explicit Hemisphere(vec3 n) : up(n) {
    const vec3 helper = std::abs(n.y) < .9f ? vec3(0, 1, 0) : vec3(1, 0, 0);
    side = glm::normalize(glm::cross(helper, n));
    front = glm::cross(n, side);
  }
  /// The k-th of `count` directions at 60° from the pole.
  vec3 leaning(int k, int count) const {
    const float angle = 2 * std::numbers::pi_v<float> * float(k) / float(count) + .5f;
    return up * .5f + (side * std::cos(angle) + front * std::sin(angle)) * .8660254f;
  }
};

// One vertex's light; `ring` cones beside the one along the normal.
struct Feeler {
  const DensityWindow& window;
  float reach;
  int ring;

  VertexLight at(vec3 p, vec3 normal) const;
};

VertexLight Feeler::at(vec3 p, vec3 normal) const {
  const Hemisphere hemisphere(normal);
  Cone cone{p + normal * 1.5f, normal, 1, reach};
  float open = kUpWeight * visibility(window, cone);
  vec3 bent = normal * open;
  const float ringWeight = (1 - kUpWeight) / float(ring);
  for (int k = 0; k < ring; ++k) {
    cone.direction = hemisphere.leaning(k, ring);
    const float t = ringWeight * visibility(window, cone);
    open += t;
    bent += cone.direction * t;
  }
  VertexLight light;
  light.open = std::pow(std::min(1.f, open / kPlaneSum), kExponent);
  const float length = glm::length(bent);
  light.bent = length > 1e-3f ? bent / length : normal;
  const auto beyondFlat = [&](int level) { return window.smoothSample(p, level) - .5f; };
  light.cavity = std::clamp(
      2.2f * (1.6f * beyondFlat(1) + 1.0f * beyondFlat(2) + .5f * beyondFlat(3)), -1.f, 1.f);
  return light;
}

Key regionOf(Key origin) {
  return {origin.i >> kRegionShift, origin.j >> kRegionShift, origin.k >> kRegionShift};
}

vec3 offset(Key from, Key to) {
  return {float(to.i - from.i), float(to.j - from.j), float(to.k - from.k)};
}

}  // namespace

std::vector<std::vector<VertexLight>> lightOf(const OcclusionVolume& volume,
                                              std::span<const PatchVertices> patches, double reach,
                                              LightDetail detail) {
  std::map<Key, std::vector<std::size_t>> regions;
  for (std::size_t n = 0; n < patches.size(); ++n)
    regions[regionOf(patches[n].origin)].push_back(n);
  std::vector<std::pair<Key, std::vector<std::size_t>>> jobs(regions.begin(), regions.end());

  std::vector<std::vector<VertexLight>> lights(patches.size());
  parallelFor(jobs.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t job = begin; job < end; ++job) {
      const Key low = jobs[job].first * (1 << kRegionShift);
      constexpr std::int32_t last = (1 << kRegionShift) - 1;
      const DensityWindow window(volume, {low, low + Key{last, last, last}});
      const Feeler feeler{window, float(reach), ringOf(detail)};
      for (const std::size_t n : jobs[job].second) {
        const PatchVertices& patch = patches[n];
        const vec3 corner = offset(low, patch.origin);
        lights[n].reserve(patch.positions.size());
        for (std::size_t v = 0; v < patch.positions.size(); ++v) {
          lights[n].push_back(feeler.at(corner + patch.positions[v], patch.normals[v]));
        }
      }
    }
  });
  return lights;
}

// Seven cones upwards per texel, through one window over the whole clay at the level whose texels
// are about as large as the map's.
FloorOcclusion floorOcclusion(const OcclusionVolume& volume, const Stage& stage,
                              const CellBounds& clay) {
  FloorOcclusion floor;
  if (clay.empty()) return floor;
  constexpr int side = FloorOcclusion::kSide;
  const double span = FloorOcclusion::kHalfUnits * stage.unit;
  const double texel = 2 * span / side;
  const int finest = std::clamp(int(std::log2(texel)), 0, OcclusionVolume::kLevels - 2);
  const Key low{std::int32_t(std::floor(clay.low.x)), std::int32_t(std::floor(clay.low.y)),
                std::int32_t(std::floor(clay.low.z))};
  const Key high{std::int32_t(std::ceil(clay.high.x)), std::int32_t(std::ceil(clay.high.y)),
                 std::int32_t(std::ceil(clay.high.z))};
  const DensityWindow window(volume, {low, high}, finest);
  const Hemisphere up(vec3(0, 1, 0));
  floor.texels.resize(std::size_t(side) * side);
  parallelFor(side, 4, [&](std::size_t begin, std::size_t end) {
    for (int z = int(begin); z < int(end); ++z) {
      for (int x = 0; x < side; ++x) {
        const glm::dvec3 at(stage.centre.x + (x + .5) * texel - span, stage.floor,
                            stage.centre.z + (z + .5) * texel - span);
        Cone cone{vec3(at - glm::dvec3(low.i, low.j, low.k)), up.up, float(1 << finest),
                  float(3 * stage.unit)};
        float open = .25f * visibility(window, cone);
        for (int k = 0; k < 6; ++k) {
          cone.direction = up.leaning(k, 6);
          open += .125f * visibility(window, cone);
        }
        floor.texels[std::size_t(z * side + x)] = std::uint8_t(std::clamp(open, 0.f, 1.f) * 255);
      }
    }
  });
  return floor;
}

}  // namespace bozzetto
