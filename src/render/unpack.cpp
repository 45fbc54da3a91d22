#include "bozzetto/render/unpack.hpp"

#include <algorithm>
#include <glm/common.hpp>

namespace bozzetto {

UnpackedPatch::UnpackedPatch(Key firstCorner, const SurfacePatch& patch)
    : UnpackedPatch(firstCorner, patch.content().vertices, patch.content().indices) {}

UnpackedPatch::UnpackedPatch(Key firstCorner, std::span<const PatchVertex> vertices,
                             std::span<const std::uint16_t> triangles)
    : origin(firstCorner), indices(triangles.begin(), triangles.end()) {
  const std::size_t count = vertices.size();
  positions.reserve(count);
  normals.reserve(count);
  colours.reserve(count);
  const bool held = std::any_of(vertices.begin(), vertices.end(),
                                [](const PatchVertex& vertex) { return vertex.colour[3] != 0; });
  for (const PatchVertex& vertex : vertices) {
    const auto& p = vertex.position;
    const auto n = octahedralNormal(vertex.normal);
    positions.emplace_back(p[0], p[1], p[2]);
    normals.emplace_back(n[0], n[1], n[2]);
    colours.push_back({vertex.colour[0], vertex.colour[1], vertex.colour[2]});
    if (held) hold.push_back(vertex.colour[3]);
  }
}

CellBounds UnpackedPatch::bounds() const {
  if (positions.empty()) return {};
  glm::vec3 low = positions[0], high = low;
  for (const glm::vec3& p : positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const glm::dvec3 corner(origin.i, origin.j, origin.k);
  return {corner + glm::dvec3(low), corner + glm::dvec3(high)};
}

}  // namespace bozzetto
