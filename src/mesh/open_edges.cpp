#include "bozzetto/mesh/open_edges.hpp"

#include <algorithm>

#include "mesh/edge_table.hpp"

namespace bozzetto {

std::vector<TriangleMesh::Triangle> unbalancedEdges(const TriangleMesh& mesh) {
  std::vector<TriangleMesh::Triangle> edges;
  forEachEdge(mesh, [&](std::uint32_t vertex, std::span<const TriangleSide> sides) {
    const auto rising = std::count_if(sides.begin(), sides.end(), [](auto& s) { return s.rising; });
    if (2 * static_cast<std::size_t>(rising) == sides.size()) return;
    edges.push_back({vertex, sides[0].other, sides[0].other});
  });
  return edges;
}

}  // namespace bozzetto
