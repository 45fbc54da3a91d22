#include "mesh/edge_table.hpp"

#include <algorithm>

namespace bozzetto {
namespace {

// start[v] … start[v+1]: the sides whose smaller vertex is v.
std::vector<std::uint32_t> countBySmaller(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> start(mesh.positions.size() + 1, 0);
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t n = 0; n < 3; ++n) {
      const auto from = triangle[n], to = triangle[(n + 1) % 3];
      if (from != to) ++start[std::min(from, to) + 1];
    }
  }
  for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
  return start;
}

std::vector<TriangleSide> dealSides(const TriangleMesh& mesh,
                                    const std::vector<std::uint32_t>& start) {
  std::vector<TriangleSide> sides(start.back());
  auto next = start;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& triangle = mesh.triangles[t];
    for (std::size_t n = 0; n < 3; ++n) {
      const auto from = triangle[n], to = triangle[(n + 1) % 3];
      if (from == to) continue;
      sides[next[std::min(from, to)]++] = {std::max(from, to),
                                           static_cast<std::uint32_t>(3 * t + n), from < to};
    }
  }
  return sides;
}

}  // namespace

void forEachEdge(const TriangleMesh& mesh,
                 FunctionRef<void(std::uint32_t, std::span<const TriangleSide>)> visit) {
  const auto start = countBySmaller(mesh);
  auto sides = dealSides(mesh, start);
  for (std::size_t v = 0; v + 1 < start.size(); ++v) {
    const auto first = sides.begin() + start[v], last = sides.begin() + start[v + 1];
    std::sort(first, last, [](const TriangleSide& a, const TriangleSide& b) {
      return a.other != b.other ? a.other < b.other : a.corner < b.corner;
    });
    for (auto from = first; from != last;) {
      const auto to = std::find_if(from, last, [&](auto& s) { return s.other != from->other; });
      visit(static_cast<std::uint32_t>(v), std::span<const TriangleSide>(from, to));
      from = to;
    }
  }
}

}  // namespace bozzetto
