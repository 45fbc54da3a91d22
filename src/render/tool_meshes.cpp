// Meshes of the simple tools, made by formula.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "bozzetto/render/overlays.hpp"

namespace bozzetto {
namespace {

using glm::vec3;

int sidesOf(Rounding rounding) { return rounding == Rounding::smooth ? 48 : 12; }
// Rings of a quarter turn.
int stepsOf(Rounding rounding) { return rounding == Rounding::smooth ? 14 : 3; }

// A surface of revolution about y: rings from the top down, each with its own normals.
struct Ring {
  float radius, height;
  float outwards, upwards;  // normal
};

std::shared_ptr<const ToolMesh> turned(const std::vector<Ring>& rings, Rounding rounding) {
  const int sides = sidesOf(rounding);
  auto mesh = std::make_shared<ToolMesh>();
  for (const Ring& ring : rings) {
    for (int n = 0; n <= sides; ++n) {
      const float angle = 2 * std::numbers::pi_v<float> * float(n % sides) / float(sides);
      const float s = std::sin(angle), c = std::cos(angle);
      mesh->positions.emplace_back(ring.radius * s, ring.height, ring.radius * c);
      mesh->normals.push_back(
          glm::normalize(vec3(ring.outwards * s, ring.upwards, ring.outwards * c)));
    }
  }
  const auto row = std::uint32_t(sides) + 1;
  for (std::uint32_t r = 0; r + 1 < rings.size(); ++r) {
    for (std::uint32_t n = 0; n + 1 < row; ++n) {
      const std::uint32_t a = r * row + n, b = a + row;
      for (const std::uint32_t v : {a, b, a + 1, a + 1, b, b + 1}) mesh->indices.push_back(v);
    }
  }
  return mesh;
}

// Half a ball's rings from one height of its axis to the other, moved by `shift`.
void addArc(std::vector<Ring>& rings, glm::vec2 angles, vec3 radii, float shift, int steps) {
  for (int n = 0; n <= steps; ++n) {
    const float angle = glm::mix(angles.x, angles.y, float(n) / float(steps));
    const float s = std::max(std::sin(angle), 0.f), c = std::cos(angle);
    rings.push_back({radii.x * s, radii.y * c + shift, s / radii.x, c / radii.y});
  }
}

std::shared_ptr<const ToolMesh> ball(Rounding rounding) {
  std::vector<Ring> rings;
  constexpr float half = std::numbers::pi_v<float> / 2;
  addArc(rings, {0, half}, vec3(1), 0, stepsOf(rounding));
  addArc(rings, {half, 2 * half}, vec3(1), 0, stepsOf(rounding));
  return turned(rings, rounding);
}

std::shared_ptr<const ToolMesh> cylinder(Rounding rounding) {
  return turned(
      {{0, 1, 0, 1}, {1, 1, 0, 1}, {1, 1, 1, 0}, {1, -1, 1, 0}, {1, -1, 0, -1}, {0, -1, 0, -1}},
      rounding);
}

std::shared_ptr<const ToolMesh> box() {
  auto mesh = std::make_shared<ToolMesh>();
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      const auto first = std::uint32_t(mesh->positions.size());
      for (int n = 0; n < 4; ++n) {
        vec3 p;
        p[axis] = float(side);
        p[(axis + 1) % 3] = n == 1 || n == 2 ? 1 : -1;
        p[(axis + 2) % 3] = n >= 2 ? 1 : -1;
        mesh->positions.push_back(p);
        mesh->normals.emplace_back(0);
        mesh->normals.back()[axis] = float(side);
      }
      for (const std::uint32_t n : {0u, 1u, 2u, 0u, 2u, 3u}) {
        mesh->indices.push_back(first + (side > 0 || n == 0 ? n : 4 - n));
      }
    }
  }
  return mesh;
}

}  // namespace

std::shared_ptr<const ToolMesh> unitMesh(UnitShape shape, Rounding rounding) {
  using enum Rounding;
  static const std::shared_ptr<const ToolMesh> meshes[][2] = {
      {ball(smooth), ball(wires)}, {box(), box()}, {cylinder(smooth), cylinder(wires)}};
  return meshes[std::size_t(shape)][std::size_t(rounding)];
}

// Half balls on a cylinder, the ends √(x·z) high, as the tool is.
std::shared_ptr<const ToolMesh> capsuleMesh(const vec3& radii, Rounding rounding) {
  const float end = std::min(std::sqrt(radii.x * radii.z), radii.y), straight = radii.y - end;
  constexpr float half = std::numbers::pi_v<float> / 2;
  std::vector<Ring> rings;
  addArc(rings, {0, half}, {radii.x, end, 0}, straight, stepsOf(rounding));
  addArc(rings, {half, 2 * half}, {radii.x, end, 0}, -straight, stepsOf(rounding));
  auto mesh = std::make_shared<ToolMesh>(*turned(rings, rounding));
  for (vec3& p : mesh->positions) p.z *= radii.z / radii.x;
  for (vec3& n : mesh->normals) n = glm::normalize(n * vec3(1, 1, radii.x / radii.z));
  return mesh;
}

}  // namespace bozzetto
