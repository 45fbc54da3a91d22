#include "io/grid_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "bozzetto/mesh/open_edges.hpp"
#include "bozzetto/mesh/orient.hpp"
#include "bozzetto/mesh/weld.hpp"

namespace bozzetto {
namespace {

constexpr int kSide = CornerBlock<8>::kSide;
// Block numbers are packed into 21 bits an axis; three rims of one block stay free.
constexpr std::int32_t kMostBlocks = (1 << 20);
constexpr double kMostSurface = 1 << 28;

[[noreturn]] void fail(const std::string& found, const std::string& expected) {
  throw Error("import: found " + found + ", expected " + expected);
}

// The corner of the workspace at or below a world coordinate, less a cell for the slope.
std::int32_t cornerBelow(double world, double spacing, int rim) {
  const double cells = std::floor(world / spacing) + rim;
  if (!(std::abs(cells) <= kWorkspaceRim)) {
    fail("a coordinate " + std::to_string(world) + " beyond the workspace",
         "at most 2^30 cells of " + std::to_string(spacing) + " from the origin");
  }
  return static_cast<std::int32_t>(cells);
}

void placeBlocks(GridMesh& grid, const MeshBounds& bounds, double spacing) {
  for (const Axis axis : kAxes) {
    const int a = index(axis);
    const auto low = cornerBelow(bounds.min[a], spacing, -1);
    const auto high = cornerBelow(bounds.max[a], spacing, 2);
    grid.firstBlock[axis] = BlockGeometry<kSide>::blockOf({low, low, low}).i;
    grid.blocks[axis] =
        BlockGeometry<kSide>::blockOf({high, high, high}).i - grid.firstBlock[axis] + 1;
    if (grid.blocks[axis] > kMostBlocks) {
      fail("a mesh of " + std::to_string(grid.blocks[axis]) + " blocks along an axis",
           "at most " + std::to_string(kMostBlocks));
    }
  }
}

}  // namespace

GridMesh makeGridMesh(const TriangleMesh& mesh, double spacing, ImportReport& report) {
  validate(mesh, "import");
  GridMesh grid;
  grid.mesh = mesh;
  weldVertices(grid.mesh);
  if (grid.mesh.triangles.empty()) fail("no triangle with an area", "a mesh with volume");
  report.turned = orientOutward(grid.mesh);

  // What it is in world units.
  const auto checked = checkMesh(grid.mesh);
  report.bounds = checked.bounds;
  report.parts = checked.components;
  grid.openEdges = unbalancedEdges(grid.mesh);
  report.openEdges = grid.openEdges.size();
  const double surface = checked.area / (spacing * spacing);
  if (!(surface <= kMostSurface)) {
    fail("a surface of " + std::to_string(surface) + " cells", "at most 2^28: take fewer cells");
  }

  // What it is in cells.
  placeBlocks(grid, checked.bounds, spacing);
  const Key first = BlockGeometry<kSide>::firstCornerOf(grid.firstBlock);
  const glm::dvec3 origin(first.i, first.j, first.k);
  for (auto& p : grid.mesh.positions) p = p / spacing - origin;
  grid.triangles.reserve(grid.mesh.triangles.size());
  const auto& positions = grid.mesh.positions;
  for (const auto& t : grid.mesh.triangles) {
    grid.triangles.emplace_back(positions[t[0]], positions[t[1]], positions[t[2]]);
  }
  return grid;
}

}  // namespace bozzetto
