#include "io/mesh_fit.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "bozzetto/base/parallel.hpp"

namespace bozzetto {
namespace {

using Tree = KeyTree<CornerBlock<8>>;
using Geometry = BlockGeometry<8>;

double valueAt(const Tree& tree, Key corner) {
  const auto* block = tree.find(Geometry::blockOf(corner));
  return block == nullptr ? 0 : block->value[Geometry::indexOf(corner)];
}

double trilinear(const Tree& tree, Key first, const glm::dvec3& place) {
  const glm::dvec3 base = glm::floor(place), f = place - base;
  const Key key = first + Key{int(base.x), int(base.y), int(base.z)};
  double sum = 0;
  for (int n = 0; n < 8; ++n) {
    const int di = n >> 2, dj = n >> 1 & 1, dk = n & 1;
    const double weight = (di ? f.x : 1 - f.x) * (dj ? f.y : 1 - f.y) * (dk ? f.z : 1 - f.z);
    if (weight > 0) sum += weight * valueAt(tree, key + Key{di, dj, dk});
  }
  return sum;
}

std::int64_t cornersOf(const Tree& tree) {
  std::int64_t corners = 0;
  for (const auto& [key, run] : tree) {
    if (!run.block) continue;
    corners += run.length * std::count_if(run.block->value.begin(), run.block->value.end(),
                                          [](float value) { return value > 0; });
  }
  return corners;
}

}  // namespace

void measureFit(const GridMesh& grid, const Tree& tree, ImportReport& report) {
  const auto& positions = grid.mesh.positions;
  const Key first = Geometry::firstCornerOf(grid.firstBlock);
  std::vector<double> distance(positions.size());
  parallelFor(positions.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      distance[n] = std::abs(trilinear(tree, first, positions[n]) - 0.5) * 2;
    }
  });
  std::vector<std::uint8_t> used(positions.size(), 0);
  for (const auto& t : grid.mesh.triangles) {
    for (const auto v : t) used[v] = 1;
  }
  double sum = 0, count = 0;
  for (std::size_t n = 0; n < positions.size(); ++n) {
    if (used[n] == 0) continue;
    report.fitMax = std::max(report.fitMax, distance[n]);
    sum += distance[n];
    ++count;
  }
  report.fitMean = sum / count;
  report.corners = cornersOf(tree);
}

}  // namespace bozzetto
