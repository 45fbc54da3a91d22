#include "bozzetto/mesh/check.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "bozzetto/base/error.hpp"
#include "mesh/disjoint_sets.hpp"
#include "mesh/edge_table.hpp"

namespace bozzetto {
namespace {

bool isFinite(const glm::dvec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

void checkLength(std::string_view name, std::string_view what, std::size_t found,
                 std::size_t expected) {
  if (found == 0 || found == expected) return;
  throw Error(std::string(name) + ": " + std::to_string(found) + " " + std::string(what) +
              ", none or one for each of " + std::to_string(expected) + " vertices expected");
}

bool isDegenerate(const TriangleMesh::Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

// Corners of one fan are joined across each edge with two triangles; a vertex whose corners stay
// in several sets is pinched.
class Fans {
 public:
  explicit Fans(const TriangleMesh& mesh)
      : mesh_(mesh), corners_(3 * mesh.triangles.size()), vertices_(mesh.positions.size()) {}

  void joinAcross(const TriangleSide& a, const TriangleSide& b) {
    for (const auto start : {a.corner, endOf(a.corner)}) {
      const auto other = vertexAt(b.corner) == vertexAt(start) ? b.corner : endOf(b.corner);
      corners_.join(start, other);
    }
  }

  void joinVertices(std::uint32_t a, std::uint32_t b) { vertices_.join(a, b); }

  // Fills in what needs every edge to have been seen.
  void finish(MeshReport& report) {
    std::vector<std::uint8_t> fans(mesh_.positions.size(), 0);
    for (std::uint32_t c = 0; c < 3 * mesh_.triangles.size(); ++c) {
      auto& count = fans[vertexAt(c)];
      if (corners_.find(c) == c && count < 2) ++count;
    }
    for (std::uint32_t v = 0; v < fans.size(); ++v) {
      if (fans[v] == 0) ++report.unusedVertices;
      if (fans[v] > 1) ++report.pinchedVertices;
      if (fans[v] > 0 && vertices_.find(v) == v) ++report.components;
      if (fans[v] > 0) report.bounds.add(mesh_.positions[v]);
    }
    report.vertices = fans.size() - report.unusedVertices;
  }

 private:
  static std::uint32_t endOf(std::uint32_t corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
  }
  std::uint32_t vertexAt(std::uint32_t corner) const {
    return mesh_.triangles[corner / 3][corner % 3];
  }

  const TriangleMesh& mesh_;
  DisjointSets corners_, vertices_;
};

void countEdge(std::span<const TriangleSide> sides, MeshReport& report) {
  const auto rising = std::count_if(sides.begin(), sides.end(), [](auto& s) { return s.rising; });
  const auto falling = static_cast<std::ptrdiff_t>(sides.size()) - rising;
  ++report.edges;
  if (sides.size() == 1) ++report.openEdges;
  if (sides.size() > 2) ++report.crowdedEdges;
  if (rising != falling) ++report.unbalancedEdges;
  if (rising > 1 || falling > 1) ++report.repeatedEdges;
}

}  // namespace

void MeshBounds::add(const glm::dvec3& point) {
  min = empty ? point : glm::min(min, point);
  max = empty ? point : glm::max(max, point);
  empty = false;
}

double MeshBounds::longestSide() const {
  const auto s = size();
  return std::max({s.x, s.y, s.z});
}

std::optional<long long> MeshReport::genus() const {
  if (!closed() || !oriented() || !manifold()) return std::nullopt;
  return static_cast<long long>(components) - eulerCharacteristic / 2;
}

void validate(const TriangleMesh& mesh, std::string_view name) {
  const std::size_t count = mesh.positions.size();
  checkLength(name, "normals", mesh.normals.size(), count);
  checkLength(name, "colours", mesh.colours.size(), count);
  for (std::size_t v = 0; v < count; ++v) {
    if (isFinite(mesh.positions[v])) continue;
    throw Error(std::string(name) + ": vertex " + std::to_string(v) +
                " is not finite, a number expected");
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const auto vertex : mesh.triangles[t]) {
      if (vertex < count) continue;
      throw Error(std::string(name) + ": triangle " + std::to_string(t) + " uses vertex " +
                  std::to_string(vertex) + ", less than " + std::to_string(count) + " expected");
    }
  }
}

MeshReport checkMesh(const TriangleMesh& mesh) {
  MeshReport report;
  report.triangles = mesh.triangles.size();
  report.degenerateTriangles = static_cast<std::size_t>(
      std::count_if(mesh.triangles.begin(), mesh.triangles.end(), isDegenerate));
  Fans fans(mesh);
  forEachEdge(mesh, [&](std::uint32_t vertex, std::span<const TriangleSide> sides) {
    countEdge(sides, report);
    fans.joinVertices(vertex, sides[0].other);
    if (sides.size() == 2) fans.joinAcross(sides[0], sides[1]);
  });
  fans.finish(report);
  report.eulerCharacteristic = static_cast<long long>(report.vertices) -
                               static_cast<long long>(report.edges) +
                               static_cast<long long>(report.triangles);
  report.volume = signedVolume(mesh);
  report.area = surfaceArea(mesh);
  return report;
}

double signedVolume(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return 0;
  // Relative to one vertex of the mesh: far from the origin the terms would cancel badly.
  const glm::dvec3 origin = mesh.positions[mesh.triangles[0][0]];
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    const auto a = mesh.positions[t[0]] - origin, b = mesh.positions[t[1]] - origin;
    sum += glm::dot(a, glm::cross(b, mesh.positions[t[2]] - origin));
  }
  return sum / 6;
}

double surfaceArea(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    const auto a = mesh.positions[t[0]];
    sum += glm::length(glm::cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a));
  }
  return sum / 2;
}

MeshBounds boundsOf(const TriangleMesh& mesh) {
  MeshBounds bounds;
  for (const auto& position : mesh.positions) bounds.add(position);
  return bounds;
}

}  // namespace bozzetto
