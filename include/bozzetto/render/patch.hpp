// What the renderer draws: small pieces of surface, one per block of the field.
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "bozzetto/base/colour.hpp"
#include "bozzetto/grid/key.hpp"

namespace bozzetto {

/// How light reaches a vertex; see OcclusionVolume.
struct VertexLight {
  glm::vec3 bent{0, 0, 0};  ///< mean unoccluded direction, length 1; 0 = the normal
  float open = 1;           ///< 1 in the open … 0 walled in
  float cavity = 0;         ///< −1 sharp ridge … 0 flat … 1 deep crease
};

/// The clay as it is, its half-resolution stand-in for moving frames, or cloths thrown over it,
/// which are drawn instead of both while there are any.
enum class Fineness : std::uint8_t { fine, coarse, heights };

/// Views into the caller's arrays. Positions count cells from `origin`; triangles are
/// counter-clockwise seen from outside. `light` is empty or has one entry per vertex, `hold` too.
struct PatchVertices {
  Key origin;  ///< with `fineness` names the patch
  std::span<const glm::vec3> positions;
  std::span<const glm::vec3> normals;
  std::span<const Colour> colours;
  std::span<const std::uint16_t> indices;
  std::span<const VertexLight> light;
  std::span<const std::uint8_t> hold = {};
  std::span<const std::int8_t> stiffness = {};  ///< painted: −127 soft … 127 stiff; or empty
  Fineness fineness = Fineness::fine;
};

}  // namespace bozzetto
