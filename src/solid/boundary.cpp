#include "bozzetto/solid/boundary.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

namespace bozzetto {
namespace {

// Whether the loop walks from a to b (1) or from b to a (−1).
int walk(std::span<const Id> loop, Id a, Id b) {
  for (std::size_t n = 0; n < loop.size(); ++n)
    if (loop[n] == a && loop[(n + 1) % loop.size()] == b) return 1;
  return -1;
}

double fanVolume(const Lattice& lattice, std::span<const Id> face, const glm::dvec3& origin) {
  const glm::dvec3 middle = meanOf(lattice, face) - origin;
  double sum = 0;
  for (std::size_t n = 0; n < face.size(); ++n) {
    const glm::dvec3 a = lattice.points[face[n]] - origin;
    const glm::dvec3 b = lattice.points[face[(n + 1) % face.size()]] - origin;
    sum += glm::dot(middle, glm::cross(a, b));
  }
  return sum / 6;
}

// Gives every face of every cell a sign: +1 when its loop is counter-clockwise from outside the
// cell. Neighbours in a cell walk their common edge in opposite directions; the two cells of a face
// see it from opposite sides; each connected part has positive volume.
class Orienter {
 public:
  Orienter(const Lattice& lattice, const Topology& topology)
      : lattice_(lattice), topology_(topology), sign_(lattice.faces.size(), 0) {}

  // Signs of boundary faces, seen from outside the solid; 0 inside.
  std::vector<int> run() {
    std::vector<std::uint8_t> seen(lattice_.cells.size(), 0);
    for (Id cell = 0; cell < lattice_.cells.size(); ++cell)
      if (seen[cell] == 0) orientPart(cell, seen);
    return sign_;
  }

 private:
  struct Start {
    Id cell, face;
    int sign;
  };

  void orientPart(Id first, std::vector<std::uint8_t>& seen) {
    std::vector<Start> open{{first, lattice_.cells[first][0], 1}};
    std::vector<Id> boundary;
    seen[first] = 1;
    for (std::size_t done = 0; done < open.size(); ++done) {
      for (const auto& [face, sign] : signsIn(open[done])) {
        const auto cells = topology_.faceCells[face];
        if (cells.size() == 1) {
          sign_[face] = sign;
          boundary.push_back(face);
          continue;
        }
        const Id other = cells[0] == open[done].cell ? cells[1] : cells[0];
        if (seen[other] == 0) open.push_back({other, face, -sign});
        seen[other] = 1;
      }
    }
    makePositive(boundary);
  }

  std::map<Id, int> signsIn(Start start) const {
    std::map<Id, int> signs{{start.face, start.sign}};
    std::vector<Id> open{start.face};
    for (std::size_t done = 0; done < open.size(); ++done) {
      for (const Id edge : topology_.faceEdges[open[done]]) {
        const auto [a, b] = topology_.edges[edge];
        const int own = signs[open[done]] * walk(lattice_.faces[open[done]], a, b);
        for (const Id face : lattice_.cells[start.cell]) {
          if (signs.contains(face)) continue;
          if (std::ranges::find(topology_.faceEdges[face], edge) == topology_.faceEdges[face].end())
            continue;
          signs[face] = -own * walk(lattice_.faces[face], a, b);
          open.push_back(face);
        }
      }
    }
    return signs;
  }

  void makePositive(const std::vector<Id>& boundary) {
    if (boundary.empty()) return;
    const glm::dvec3 origin = lattice_.points[lattice_.faces[boundary[0]][0]];
    double sum = 0;
    for (const Id face : boundary)
      sum += sign_[face] * fanVolume(lattice_, lattice_.faces[face], origin);
    if (sum >= 0) return;
    for (const Id face : boundary) sign_[face] = -sign_[face];
  }

  const Lattice& lattice_;
  const Topology& topology_;
  std::vector<int> sign_;
};

// Bilinear place in a quad.
glm::dvec3 inQuad(const Lattice& lattice, std::span<const Id> q, double u, double v) {
  const auto& p = lattice.points;
  return (1 - v) * ((1 - u) * p[q[0]] + u * p[q[1]]) + v * ((1 - u) * p[q[3]] + u * p[q[2]]);
}

void addFan(TriangleMesh& mesh, std::span<const std::uint32_t> loop, const glm::dvec3& middle) {
  const auto centre = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.push_back(middle);
  for (std::size_t n = 0; n < loop.size(); ++n)
    mesh.triangles.push_back({centre, loop[n], loop[(n + 1) % loop.size()]});
}

// Points along edges are shared by the two faces of the edge.
class Cutter {
 public:
  Cutter(const Lattice& surface, int cuts, TriangleMesh& mesh)
      : surface_(surface), cuts_(cuts), mesh_(mesh) {}

  void cut(std::span<const Id> q) {
    const int side = cuts_ + 1;
    std::vector<std::uint32_t> grid(static_cast<std::size_t>(side * side));
    for (int v = 0; v < side; ++v)
      for (int u = 0; u < side; ++u) grid[static_cast<std::size_t>(v * side + u)] = place(q, u, v);
    for (int v = 0; v < cuts_; ++v) {
      for (int u = 0; u < cuts_; ++u) {
        const auto at = static_cast<std::size_t>(v * side + u),
                   row = static_cast<std::size_t>(side);
        const std::uint32_t loop[]{grid[at], grid[at + 1], grid[at + row + 1], grid[at + row]};
        addFan(mesh_, loop, inQuad(surface_, q, (u + 0.5) / cuts_, (v + 0.5) / cuts_));
      }
    }
  }

 private:
  std::uint32_t place(std::span<const Id> q, int u, int v) {
    const bool uEnd = u == 0 || u == cuts_, vEnd = v == 0 || v == cuts_;
    if (uEnd && vEnd) return q[v == 0 ? (u == 0 ? 0u : 1u) : (u == 0 ? 3u : 2u)];
    if (uEnd) return onEdge(q[u == 0 ? 0u : 1u], q[u == 0 ? 3u : 2u], v);
    if (vEnd) return onEdge(q[v == 0 ? 0u : 3u], q[v == 0 ? 1u : 2u], u);
    mesh_.positions.push_back(inQuad(surface_, q, double(u) / cuts_, double(v) / cuts_));
    return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
  }

  std::uint32_t onEdge(Id a, Id b, int n) {
    if (a > b) return onEdge(b, a, cuts_ - n);
    const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
    const auto [known, added] = edgePoints_.try_emplace({a, b, static_cast<Id>(n)}, next);
    const double t = double(n) / cuts_;
    if (added) mesh_.positions.push_back((1 - t) * surface_.points[a] + t * surface_.points[b]);
    return known->second;
  }

  const Lattice& surface_;
  int cuts_;
  TriangleMesh& mesh_;
  std::map<std::array<Id, 3>, std::uint32_t> edgePoints_;
};

}  // namespace

Lattice surfaceOf(const Lattice& lattice) {
  const Topology topology(lattice);
  const std::vector<int> signs = Orienter(lattice, topology).run();
  Lattice surface;
  surface.points = lattice.points;
  surface.sharpPoints = lattice.sharpPoints;
  for (const PointPair& pair : lattice.sharpEdges) {
    const Id edge = topology.edgeBetween(pair[0], pair[1]);
    if (edge != kNoId && topology.boundaryEdge[edge] != 0) surface.sharpEdges.push_back(pair);
  }
  std::vector<Id> loop;
  for (Id face = 0; face < lattice.faces.size(); ++face) {
    if (signs[face] == 0) continue;
    loop.assign(lattice.faces[face].begin(), lattice.faces[face].end());
    if (signs[face] < 0) std::ranges::reverse(loop);
    surface.faces.add(loop);
  }
  return surface;
}

double enclosedVolume(const Lattice& surface) {
  if (surface.faces.size() == 0) return 0;
  const glm::dvec3 origin = surface.points[surface.faces[0][0]];
  double sum = 0;
  for (Id face = 0; face < surface.faces.size(); ++face)
    sum += fanVolume(surface, surface.faces[face], origin);
  return sum;
}

double volume(const Lattice& lattice) { return enclosedVolume(surfaceOf(lattice)); }

TriangleMesh triangulated(const Lattice& surface, int cuts) {
  TriangleMesh mesh;
  mesh.positions = surface.points;
  Cutter cutter(surface, cuts, mesh);
  for (Id face = 0; face < surface.faces.size(); ++face) {
    const auto loop = surface.faces[face];
    if (loop.size() == 4 && cuts > 1) {
      cutter.cut(loop);
    } else {
      addFan(mesh, loop, meanOf(surface, loop));
    }
  }
  return mesh;
}

}  // namespace bozzetto
