// Indexed triangles in world units: what comes in from files and what goes out to them. Knows
// nothing of voxels.
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "bozzetto/base/colour.hpp"

namespace bozzetto {

/// Counter-clockwise triangles seen from outside. `normals` and `colours` are empty or have one
/// entry per position. Positions are double: the workspace is large.
struct TriangleMesh {
  using Triangle = std::array<std::uint32_t, 3>;

  std::vector<glm::dvec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<Colour> colours;
  std::vector<Triangle> triangles;
};

}  // namespace bozzetto
