// The whole surface as one mesh: what is exported, measured and checked.
#pragma once
#include "bozzetto/mesh/triangle_mesh.hpp"
#include "bozzetto/surface/surface.hpp"

namespace bozzetto {

/// Vertices and triangles of all patches in key order, each vertex once, in world units with
/// normals and colours. Closed, 2-manifold, counter-clockwise from outside for every field. Throws
/// Error beyond 2³² vertices. O(n), in parallel.
template <int Side>
TriangleMesh weld(const Surface<Side>& surface, const FieldScale& scale);

}  // namespace bozzetto
