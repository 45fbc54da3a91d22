// Outward triangles from whatever order a file has them in.
#pragma once
#include <cstddef>

#include "bozzetto/mesh/triangle_mesh.hpp"

namespace bozzetto {

/// Swaps corners of triangles so that
/// - neighbours across an edge of two triangles agree, the majority of each part staying as it is;
/// - the mesh as a whole is outward (positive volume about its middle);
/// - a part that is inward by itself and encloses nothing but that mistake is outward too, while
///   inward parts inside others stay: they are cavities.
/// Open parts count by the volume they would enclose about their own middle. Returns how many
/// triangles were turned. O(n), O(n log n) where parts are inward.
std::size_t orientOutward(TriangleMesh& mesh);

}  // namespace bozzetto
