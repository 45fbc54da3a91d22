// Meshes with known answers.
#pragma once
#include <cmath>
#include <numbers>

#include "bozzetto/mesh/triangle_mesh.hpp"

namespace bozzetto::shapes {

/// Unit cube from (0,0,0) to (1,1,1), 12 triangles, outward.
inline TriangleMesh cube() {
  TriangleMesh mesh;
  for (int n = 0; n < 8; ++n) mesh.positions.push_back({n & 1, n >> 1 & 1, n >> 2 & 1});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// A torus round y: `rings` round the axis times `sides` round the tube.
inline TriangleMesh torus(std::uint32_t rings, std::uint32_t sides, double ring = 2,
                          double tube = 1) {
  TriangleMesh mesh;
  for (std::uint32_t r = 0; r < rings; ++r) {
    for (std::uint32_t s = 0; s < sides; ++s) {
      const double u = 2 * std::numbers::pi * r / rings, v = 2 * std::numbers::pi * s / sides;
      const double radius = ring + tube * std::cos(v);
      mesh.positions.push_back({radius * std::cos(u), tube * std::sin(v), radius * std::sin(u)});
      const auto at = [&](std::uint32_t a, std::uint32_t b) {
        return a % rings * sides + b % sides;
      };
      mesh.triangles.push_back({at(r, s), at(r, s + 1), at(r + 1, s)});
      mesh.triangles.push_back({at(r, s + 1), at(r + 1, s + 1), at(r + 1, s)});
    }
  }
  return mesh;
}

/// A ball by latitude and longitude, poles on y.
inline TriangleMesh ball(double radius, std::uint32_t stacks = 32, std::uint32_t slices = 64,
                         glm::dvec3 centre = {0, 0, 0}) {
  TriangleMesh mesh;
  mesh.positions.push_back(centre + glm::dvec3(0, radius, 0));
  for (std::uint32_t a = 1; a < stacks; ++a) {
    for (std::uint32_t b = 0; b < slices; ++b) {
      const double u = std::numbers::pi * a / stacks, v = 2 * std::numbers::pi * b / slices;
      mesh.positions.push_back(centre + radius * glm::dvec3(std::sin(u) * std::cos(v), std::cos(u),
                                                            std::sin(u) * std::sin(v)));
    }
  }
  mesh.positions.push_back(centre - glm::dvec3(0, radius, 0));
  const auto south = static_cast<std::uint32_t>(mesh.positions.size() - 1);
  const auto at = [&](std::uint32_t a, std::uint32_t b) {
    return 1 + (a - 1) * slices + b % slices;
  };
  for (std::uint32_t b = 0; b < slices; ++b) {
    mesh.triangles.push_back({0, at(1, b + 1), at(1, b)});
    for (std::uint32_t a = 1; a + 1 < stacks; ++a) {
      mesh.triangles.push_back({at(a, b), at(a, b + 1), at(a + 1, b)});
      mesh.triangles.push_back({at(a, b + 1), at(a + 1, b + 1), at(a + 1, b)});
    }
    mesh.triangles.push_back({south, at(stacks - 1, b), at(stacks - 1, b + 1)});
  }
  return mesh;
}

/// Both meshes side by side in one.
inline TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
  const auto offset = static_cast<std::uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const auto& t : b.triangles) {
    a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
  return a;
}

inline TriangleMesh flipped(TriangleMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// Every triangle with vertices of its own, as in STL.
inline TriangleMesh soup(const TriangleMesh& mesh) {
  TriangleMesh out;
  for (const auto& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(out.positions.size());
    for (const auto v : t) out.positions.push_back(mesh.positions[v]);
    out.triangles.push_back({first, first + 1, first + 2});
  }
  return out;
}

}  // namespace bozzetto::shapes
