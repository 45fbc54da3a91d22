// A triangle mesh becomes clay: closed or open, self-intersecting, in several parts, wound any way.
#pragma once
#include <cstddef>
#include <cstdint>

#include "bozzetto/base/progress.hpp"
#include "bozzetto/field/field.hpp"
#include "bozzetto/mesh/check.hpp"

namespace bozzetto {

struct ImportOptions {
  double cells = 128;  ///< along the longest side of the mesh; used when spacing is 0
  double spacing = 0;  ///< world units per cell
  Colour colour{};     ///< of clay that the mesh gives no colour: all of it, or the inside
};

struct ImportReport {
  double spacing = 0;         ///< world units per cell
  MeshBounds bounds;          ///< of the mesh, world units
  std::int64_t corners = 0;   ///< with clay
  std::size_t openEdges = 0;  ///< without exactly one opposite after welding; 0 = closed
  std::size_t parts = 0;      ///< connected by shared vertices
  std::size_t turned = 0;     ///< triangles that were wound against the rest
  double fitMax = 0;          ///< farthest mesh vertex from the clay's surface, in cells, up to 1
  double fitMean = 0;
};

/// World units per cell that the options ask for. Throws Error for a mesh without extent and for
/// numbers that are not above 0.
double importSpacing(const TriangleMesh& mesh, const ImportOptions& options);

/// Puts the mesh into the clay of `edit`: values are the greater of old and ½ - signed distance in
/// cells / 2, clamped to 0…1 (corner (i,j,k) lies at spacing · (i,j,k)), with the mesh's colour,
/// interpolated, where they raise the clay. Inside is where the generalised winding number exceeds
/// ½; holes are closed by its ½ level. Throws Error for meshes without volume at this spacing, with
/// corners beyond the workspace, longer than 2²³ cells, or with a surface of more than 2²⁸ cells;
/// Cancelled when asked to stop. The result does not depend on the thread count. Cost ∝ surface in
/// cells (and volume in blocks where the mesh is open).
ImportReport voxelise(const TriangleMesh& mesh, const ImportOptions& options,
                      Edit<CornerBlock<8>>& edit, Progress& progress = Progress::none());

}  // namespace bozzetto
