#include "bozzetto/solid/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>

namespace bozzetto {
namespace {

std::uint64_t codeOf(const PointPair& pair) { return std::uint64_t{pair[0]} << 32 | pair[1]; }

// The different items of several lists, rising.
class Union {
 public:
  void add(std::span<const Id> list) { items_.insert(items_.end(), list.begin(), list.end()); }
  std::span<const Id> take() {
    taken_.swap(items_);
    items_.clear();
    std::ranges::sort(taken_);
    taken_.erase(std::unique(taken_.begin(), taken_.end()), taken_.end());
    return taken_;
  }

 private:
  std::vector<Id> items_, taken_;
};

Lists unions(const Lists& groups, const Lists& members) {
  Lists result;
  Union all;
  for (std::size_t n = 0; n < groups.size(); ++n) {
    for (const Id member : groups[n]) all.add(members[member]);
    result.add(all.take());
  }
  return result;
}

Lists asLists(const std::vector<PointPair>& pairs) {
  Lists result;
  for (const PointPair& pair : pairs) result.add(pair);
  return result;
}

std::string numbered(const char* what, std::size_t n) { return what + std::to_string(n); }

std::optional<std::string> faultOfFace(std::span<const Id> face, std::size_t points) {
  if (face.size() < 3) return "has fewer than three points";
  for (const Id point : face)
    if (point >= points) return numbered("names point ", point);
  std::vector<Id> sorted(face.begin(), face.end());
  std::ranges::sort(sorted);
  if (std::ranges::adjacent_find(sorted) != sorted.end()) return "has a point twice";
  return std::nullopt;
}

std::optional<std::string> faultOfCell(const Lattice& lattice, std::span<const Id> cell) {
  if (cell.size() < 4) return "has fewer than four faces";
  std::vector<std::uint64_t> sides;
  for (const Id face : cell) {
    if (face >= lattice.faces.size()) return numbered("names face ", face);
    const auto loop = lattice.faces[face];
    for (std::size_t n = 0; n < loop.size(); ++n)
      sides.push_back(codeOf(pointPair(loop[n], loop[(n + 1) % loop.size()])));
  }
  std::ranges::sort(sides);
  for (std::size_t n = 0; n < sides.size(); n += 2) {
    const bool two = n + 1 < sides.size() && sides[n] == sides[n + 1];
    const bool more = two && n + 2 < sides.size() && sides[n + 2] == sides[n];
    if (!two || more) return "is not closed";
  }
  return std::nullopt;
}

std::optional<std::string> faultOfTags(const Lattice& lattice) {
  for (const Id point : lattice.sharpPoints)
    if (point >= lattice.points.size()) return numbered("sharp tag on point ", point);
  for (const PointPair& edge : lattice.sharpEdges)
    if (edge[0] >= edge[1] || edge[1] >= lattice.points.size()) return "sharp tag on no edge";
  if (!std::ranges::is_sorted(lattice.sharpPoints) || !std::ranges::is_sorted(lattice.sharpEdges))
    return "sharp tags out of order";
  return std::nullopt;
}

// Old numbers of those that are used, rising, and the other way round.
struct Kept {
  std::vector<Id> old, fresh;
  explicit Kept(const std::vector<std::uint8_t>& used) : fresh(used.size(), kNoId) {
    for (Id n = 0; n < used.size(); ++n) {
      if (used[n] == 0) continue;
      fresh[n] = static_cast<Id>(old.size());
      old.push_back(n);
    }
  }
};

}  // namespace

PointPair pointPair(Id a, Id b) { return {std::min(a, b), std::max(a, b)}; }

Topology::Topology(const Lattice& lattice) {
  const std::size_t points = lattice.points.size();
  std::unordered_map<std::uint64_t, Id> known;
  known.reserve(lattice.faces.itemCount());
  std::vector<Id> sides;
  for (std::size_t f = 0; f < lattice.faces.size(); ++f) {
    const auto loop = lattice.faces[f];
    sides.clear();
    for (std::size_t n = 0; n < loop.size(); ++n) {
      const PointPair pair = pointPair(loop[n], loop[(n + 1) % loop.size()]);
      const auto [place, added] = known.try_emplace(codeOf(pair), static_cast<Id>(edges.size()));
      if (added) edges.push_back(pair);
      sides.push_back(place->second);
    }
    faceEdges.add(sides);
  }
  faceCells = Lists::inverse(lattice.cells, lattice.faces.size());
  edgeFaces = Lists::inverse(faceEdges, edges.size());
  pointEdges = Lists::inverse(asLists(edges), points);
  pointFaces = Lists::inverse(lattice.faces, points);
  cellEdges = unions(lattice.cells, faceEdges);
  cellPoints = unions(lattice.cells, lattice.faces);
  edgeCells = Lists::inverse(cellEdges, edges.size());
  pointCells = Lists::inverse(cellPoints, points);

  boundaryFace.assign(lattice.faces.size(), 0);
  boundaryEdge.assign(edges.size(), 0);
  boundaryPoint.assign(points, 0);
  for (std::size_t f = 0; f < lattice.faces.size(); ++f) {
    if (faceCells[f].size() > 1) continue;
    boundaryFace[f] = 1;
    for (const Id edge : faceEdges[f]) boundaryEdge[edge] = 1;
    for (const Id point : lattice.faces[f]) boundaryPoint[point] = 1;
  }
}

Id Topology::edgeBetween(Id a, Id b) const {
  for (const Id edge : pointEdges[a])
    if (otherEnd(edge, a) == b) return edge;
  return kNoId;
}

std::optional<std::string> validate(const Lattice& lattice) {
  for (std::size_t n = 0; n < lattice.points.size(); ++n) {
    const glm::dvec3 p = lattice.points[n];
    if (!std::isfinite(p.x + p.y + p.z)) return numbered("place not finite: point ", n);
  }
  for (std::size_t n = 0; n < lattice.faces.size(); ++n) {
    if (const auto fault = faultOfFace(lattice.faces[n], lattice.points.size()))
      return numbered("face ", n) + " " + *fault;
  }
  std::vector<int> uses(lattice.faces.size(), 0);
  for (std::size_t n = 0; n < lattice.cells.size(); ++n) {
    if (const auto fault = faultOfCell(lattice, lattice.cells[n]))
      return numbered("cell ", n) + " " + *fault;
    for (const Id face : lattice.cells[n]) ++uses[face];
  }
  for (std::size_t n = 0; n < uses.size(); ++n)
    if (uses[n] < 1 || uses[n] > 2) return numbered("not one or two cells at face ", n);
  return faultOfTags(lattice);
}

Compacted compacted(const Lattice& lattice) {
  std::vector<std::uint8_t> usedFaces(lattice.faces.size(), 0);
  std::vector<std::uint8_t> usedPoints(lattice.points.size(), 0);
  for (const Id face : lattice.cells.items()) usedFaces[face] = 1;
  for (std::size_t f = 0; f < lattice.faces.size(); ++f)
    for (const Id point : lattice.faces[f]) usedPoints[point] |= usedFaces[f];
  const Kept faces(usedFaces), points(usedPoints);

  Compacted result;
  std::vector<Id> list;
  const auto addTo = [&list](Lists& lists, std::span<const Id> old, const Kept& kept) {
    list.clear();
    for (const Id n : old) list.push_back(kept.fresh[n]);
    lists.add(list);
  };
  for (const Id n : points.old) result.lattice.points.push_back(lattice.points[n]);
  for (const Id n : faces.old) addTo(result.lattice.faces, lattice.faces[n], points);
  for (std::size_t n = 0; n < lattice.cells.size(); ++n)
    addTo(result.lattice.cells, lattice.cells[n], faces);
  for (const Id n : lattice.sharpPoints)
    if (usedPoints[n] != 0) result.lattice.sharpPoints.push_back(points.fresh[n]);
  const Topology topology(result.lattice);
  for (const PointPair& e : lattice.sharpEdges) {
    if (usedPoints[e[0]] == 0 || usedPoints[e[1]] == 0) continue;
    const PointPair edge{points.fresh[e[0]], points.fresh[e[1]]};
    if (topology.edgeBetween(edge[0], edge[1]) != kNoId) result.lattice.sharpEdges.push_back(edge);
  }
  result.oldPoints = points.old;
  return result;
}

glm::dvec3 meanOf(const Lattice& lattice, std::span<const Id> points) {
  glm::dvec3 sum{0};
  for (const Id point : points) sum += lattice.points[point];
  return sum / static_cast<double>(points.size());
}

}  // namespace bozzetto
