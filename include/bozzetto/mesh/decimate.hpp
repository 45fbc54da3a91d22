// Fewer triangles for the same shape, for export.
#pragma once
#include "bozzetto/mesh/triangle_mesh.hpp"

namespace bozzetto {

/// The mesh with about `ratio` (0 < ratio ≤ 1) of its triangles: edge collapses by quadric error
/// (meshoptimizer), vertices a subset of the old ones with their normals and colours. A closed mesh
/// stays closed. Throws Error for another ratio. O(n log n).
TriangleMesh decimate(const TriangleMesh& mesh, double ratio);

}  // namespace bozzetto
