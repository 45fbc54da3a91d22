// Joins vertices that lie at equal positions: files such as STL have no shared vertices.
#pragma once
#include "bozzetto/mesh/triangle_mesh.hpp"

namespace bozzetto {

/// Vertices at equal positions become one (the first; its colour stays), in order of first use by
/// position; -0 equals 0. Triangles keep their order; those left with a repeated vertex are
/// dropped. Normals are dropped: they differ across a seam. O(n).
void weldVertices(TriangleMesh& mesh);

}  // namespace bozzetto
