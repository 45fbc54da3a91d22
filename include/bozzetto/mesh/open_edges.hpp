// Where a mesh is open.
#pragma once
#include <vector>

#include "bozzetto/mesh/triangle_mesh.hpp"

namespace bozzetto {

/// The edges that triangles do not walk equally often in both directions, each as a triangle of no
/// area {a, b, b}. Empty for closed meshes. O(n).
std::vector<TriangleMesh::Triangle> unbalancedEdges(const TriangleMesh& mesh);

}  // namespace bozzetto
