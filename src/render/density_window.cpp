#include "render/density_window.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace bozzetto {
namespace {

// Texels of a level that cones read beyond the box: they leave a level for the next coarser one at
// 5.3 texels, plus one for interpolation and one for the cone's tip above the surface.
constexpr int kMargin = 8;
// The coarsest level serves all distances beyond; cones end at about six of its texels.
constexpr float kHalfAngleTangent = .577f;

int floorShift(std::int32_t value, int shift) { return value >> shift; }

}  // namespace

DensityWindow::DensityWindow(const OcclusionVolume& volume, const KeyBox& cells, int finest)
    : finest_(finest) {
  for (int n = finest; n < OcclusionVolume::kLevels; ++n) {
    const Key low{floorShift(cells.low.i, n) - kMargin, floorShift(cells.low.j, n) - kMargin,
                  floorShift(cells.low.k, n) - kMargin};
    const Key high{floorShift(cells.high.i, n) + kMargin, floorShift(cells.high.j, n) + kMargin,
                   floorShift(cells.high.k, n) + kMargin};
    Level& level = levels_[std::size_t(n)];
    level.count = {high.i - low.i + 1, high.j - low.j + 1, high.k - low.k + 1};
    const float size = float(1 << n), middle = (size - 1) / 2;
    for (const Axis axis : kAxes) {
      level.first[index(axis)] =
          float(std::int64_t{low[axis]} * (1 << n) - cells.low[axis]) + middle;
    }
    level.texelsPerCell = 1 / size;
    level.texels.resize(std::size_t(level.count.x) * level.count.y * level.count.z);
    volume.read(n, {low, high}, level.texels);
  }
}

float DensityWindow::Level::sample(glm::vec3 p) const {
  const glm::vec3 q = (p - first) * texelsPerCell;
  const glm::vec3 base = glm::floor(q);
  const glm::ivec3 at(base);
  if (at.x < 0 || at.y < 0 || at.z < 0) return 0;
  if (at.x + 1 >= count.x || at.y + 1 >= count.y || at.z + 1 >= count.z) return 0;
  const glm::vec3 f = q - base;
  const std::size_t sy = std::size_t(count.z), sx = sy * std::size_t(count.y);
  const float* t = texels.data() + std::size_t(at.x) * sx + std::size_t(at.y) * sy + at.z;
  const auto along = [&](const float* row) { return row[0] + (row[1] - row[0]) * f.z; };
  const auto across = [&](const float* face) {
    const float a = along(face), b = along(face + sy);
    return a + (b - a) * f.y;
  };
  const float a = across(t), b = across(t + sx);
  return a + (b - a) * f.x;
}

float DensityWindow::Level::smoothSample(glm::vec3 p) const {
  const glm::vec3 q = (p - first) * texelsPerCell;
  const glm::ivec3 low = glm::ivec3(glm::floor(q + .5f)) - 1;  // of the 3×3×3 texels round q
  for (int axis = 0; axis < 3; ++axis)
    if (low[axis] < 0 || low[axis] + 3 > count[axis]) return 0;
  const glm::vec3 f = q - glm::vec3(low + 1);
  const glm::vec3 weight[3] = {.5f * (.5f - f) * (.5f - f), .75f - f * f,
                               .5f * (.5f + f) * (.5f + f)};
  const std::size_t sy = std::size_t(count.z), sx = sy * std::size_t(count.y);
  const float* corner = texels.data() + std::size_t(low.x) * sx + std::size_t(low.y) * sy + low.z;
  float sum = 0;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      const float* row = corner + std::size_t(x) * sx + std::size_t(y) * sy;
      const float along = row[0] * weight[0].z + row[1] * weight[1].z + row[2] * weight[2].z;
      sum += along * weight[x].x * weight[y].y;
    }
  }
  return sum;
}

float DensityWindow::smoothSample(glm::vec3 p, int level) const {
  return levels_[std::size_t(level)].smoothSample(p);
}

float DensityWindow::sample(glm::vec3 p, float level) const {
  level = std::clamp(level, float(finest_), float(OcclusionVolume::kLevels) - 1.001f);
  const int n = int(level);
  const float f = level - float(n), fine = levels_[std::size_t(n)].sample(p);
  if (f < 1e-3f) return fine;
  return fine + (levels_[std::size_t(n) + 1].sample(p) - fine) * f;
}

// Samples of doubling size at doubling distances. The level's offset of -1.6 matters most: blurrier
// and a plane shades itself.
float visibility(const DensityWindow& window, const Cone& cone) {
  float through = 1, d = 2 * cone.cell;
  while (d < cone.reach && through > .02f) {
    const float r = std::max(d * kHalfAngleTangent, cone.cell / 2);
    const float level = std::log2(std::max(1.f, 2 * r)) - 1.6f;
    through *= 1 - window.sample(cone.tip + cone.direction * d, level);
    d += 1.9f * r;
  }
  return through;
}

}  // namespace bozzetto
