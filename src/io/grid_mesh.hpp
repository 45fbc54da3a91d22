// The mesh as voxelise works on it: welded, outward, in cells from the first corner of its first
// block, so that numbers stay small wherever the mesh is.
#pragma once
#include <cstdint>
#include <vector>

#include "bozzetto/io/voxelise.hpp"
#include "io/triangle_distance.hpp"

namespace bozzetto {

struct GridMesh {
  TriangleMesh mesh;  ///< positions in cells
  Key firstBlock;     ///< of the box of blocks that the mesh can touch
  Key blocks;         ///< how many blocks that box has along each axis
  std::vector<DistanceTriangle> triangles;
  std::vector<TriangleMesh::Triangle> openEdges;  ///< {vertex, vertex, vertex}: degenerate
};

/// Fills the mesh's part of the report. Throws what voxelise throws about the mesh.
GridMesh makeGridMesh(const TriangleMesh& mesh, double spacing, ImportReport& report);

}  // namespace bozzetto
