// Tools that change which cells there are (§6.3).
#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>

#include "bozzetto/base/error.hpp"
#include "bozzetto/solid/boundary.hpp"
#include "bozzetto/solid/tools.hpp"
#include "solid/transfer.hpp"

namespace bozzetto {
namespace {

void requireBelow(std::size_t n, std::size_t count, const char* tool) {
  if (n < count) return;
  throw Error(std::string(tool) + ": found element " + std::to_string(n) + ", expected less than " +
              std::to_string(count));
}

// Old points keep their numbers; new ones come after.
std::vector<Id> numbersFor(const Solid& old, const Lattice& lattice) {
  std::vector<Id> numbers(lattice.points.size(), kNoId);
  std::iota(numbers.begin(), numbers.begin() + std::ptrdiff_t(old.control.points.size()), 0u);
  return numbers;
}

Lists without(const Lists& lists, Id gone) {
  Lists result;
  for (Id n = 0; n < lists.size(); ++n)
    if (n != gone) result.add(lists[n]);
  return result;
}

// The loop of a boundary face, counter-clockwise from outside.
std::vector<Id> outwardLoop(const Lattice& lattice, Id face) {
  const Lattice surface = surfaceOf(lattice);
  std::vector<Id> wanted(lattice.faces[face].begin(), lattice.faces[face].end());
  std::ranges::sort(wanted);
  for (Id n = 0; n < surface.faces.size(); ++n) {
    std::vector<Id> loop(surface.faces[n].begin(), surface.faces[n].end());
    std::vector<Id> sorted = loop;
    std::ranges::sort(sorted);
    if (sorted == wanted) return loop;
  }
  throw Error("solid: found a face inside, expected one on the surface");
}

glm::dvec3 areaNormal(const Lattice& lattice, const std::vector<Id>& loop) {
  const glm::dvec3 middle = meanOf(lattice, loop);
  glm::dvec3 sum(0);
  for (std::size_t n = 0; n < loop.size(); ++n)
    sum += glm::cross(lattice.points[loop[n]] - middle,
                      lattice.points[loop[(n + 1) % loop.size()]] - middle) *
           0.5;
  return sum;
}

// Adds the faces of a cell between two loops that run the same way round, point n to point n, and
// the cell. Loops may share points: sides without extent are left out.
class Bridge {
 public:
  explicit Bridge(Lattice& lattice) : lattice_(lattice) {
    for (Id face = 0; face < lattice.faces.size(); ++face)
      known_[keyOf(lattice.faces[face])] = face;
  }

  void add(Id faceA, Id faceB, const std::vector<Id>& a, const std::vector<Id>& b) {
    std::vector<Id> cell{faceA, faceB};
    for (std::size_t n = 0; n < a.size(); ++n) {
      const std::size_t m = (n + 1) % a.size();
      std::vector<Id> side{a[n], a[m]};
      if (b[m] != a[m]) side.push_back(b[m]);
      if (b[n] != a[n]) side.push_back(b[n]);
      if (side.size() >= 3) cell.push_back(faceOf(side));
    }
    lattice_.cells.add(cell);
  }

 private:
  static std::vector<Id> keyOf(std::span<const Id> loop) {
    std::vector<Id> key(loop.begin(), loop.end());
    std::ranges::sort(key);
    return key;
  }

  Id faceOf(const std::vector<Id>& loop) {
    const auto [place, added] =
        known_.try_emplace(keyOf(loop), static_cast<Id>(lattice_.faces.size()));
    if (added) lattice_.faces.add(loop);
    return place->second;
  }

  Lattice& lattice_;
  std::map<std::vector<Id>, Id> known_;
};

// Turned so that the points of `b`, walked backwards, lie nearest to those of `a`.
std::vector<Id> facing(const Lattice& lattice, const std::vector<Id>& a, std::vector<Id> b) {
  std::ranges::reverse(b);
  std::vector<Id> best = b;
  double least = -1;
  for (std::size_t turn = 0; turn < b.size(); ++turn) {
    double sum = 0;
    for (std::size_t n = 0; n < a.size(); ++n)
      sum += glm::distance(lattice.points[a[n]], lattice.points[b[n]]);
    if (least < 0 || sum < least) least = sum, best = b;
    std::rotate(b.begin(), b.begin() + 1, b.end());
  }
  return best;
}

// Splits one cell as subdivision would (§6.3, figure 10); every point stays where it is.
class LocalSplit {
 public:
  LocalSplit(const Lattice& old, Id cell) : old_(old), topology_(old), cell_(cell) {}

  Lattice run() {
    result_.points = old_.points;
    result_.sharpPoints = old_.sharpPoints;
    for (const Id edge : topology_.cellEdges[cell_]) edgePoint_[edge] = add(topology_.edges[edge]);
    for (const Id face : old_.cells[cell_]) facePoint_[face] = add(old_.faces[face]);
    cellPoint_ = add(topology_.cellPoints[cell_]);
    for (Id face = 0; face < old_.faces.size(); ++face) splitFace(face);
    for (Id cell = 0; cell < old_.cells.size(); ++cell)
      cell == cell_ ? splitCell() : keepCell(cell);
    splitTags();
    return std::move(result_);
  }

 private:
  Id add(std::span<const Id> points) {
    result_.points.push_back(meanOf(old_, points));
    return static_cast<Id>(result_.points.size() - 1);
  }

  // The old loop with the new points of its edges; of the cell's own faces, a quad a corner.
  void splitFace(Id face) {
    const auto loop = old_.faces[face];
    const auto sides = topology_.faceEdges[face];
    auto& parts = partsOf_[face];
    const auto first = static_cast<Id>(result_.faces.size());
    if (facePoint_.contains(face)) {
      for (std::size_t n = 0; n < loop.size(); ++n) {
        const Id before = edgePoint_.at(sides[(n + loop.size() - 1) % loop.size()]);
        result_.faces.add({loop[n], edgePoint_.at(sides[n]), facePoint_[face], before});
        parts.push_back(first + static_cast<Id>(n));
        cornerFaces_[loop[n]].push_back(first + static_cast<Id>(n));
      }
      return;
    }
    std::vector<Id> longer;
    for (std::size_t n = 0; n < loop.size(); ++n) {
      longer.push_back(loop[n]);
      if (const auto split = edgePoint_.find(sides[n]); split != edgePoint_.end())
        longer.push_back(split->second);
    }
    result_.faces.add(longer);
    parts.push_back(first);
  }

  void keepCell(Id cell) {
    std::vector<Id> faces;
    for (const Id face : old_.cells[cell])
      faces.insert(faces.end(), partsOf_[face].begin(), partsOf_[face].end());
    result_.cells.add(faces);
  }

  void splitCell() {
    for (const Id edge : topology_.cellEdges[cell_]) {
      std::vector<Id> beside;
      for (const Id face : old_.cells[cell_]) {
        const auto sides = topology_.faceEdges[face];
        if (std::ranges::find(sides, edge) != sides.end()) beside.push_back(facePoint_[face]);
      }
      const auto quad = static_cast<Id>(result_.faces.size());
      result_.faces.add({edgePoint_[edge], beside[0], cellPoint_, beside[1]});
      for (const Id end : topology_.edges[edge]) cornerFaces_[end].push_back(quad);
    }
    for (const Id point : topology_.cellPoints[cell_]) result_.cells.add(cornerFaces_[point]);
  }

  void splitTags() {
    for (const PointPair& pair : old_.sharpEdges) {
      const auto split = edgePoint_.find(topology_.edgeBetween(pair[0], pair[1]));
      if (split == edgePoint_.end()) {
        result_.sharpEdges.push_back(pair);
        continue;
      }
      for (const Id end : pair) result_.sharpEdges.push_back(pointPair(end, split->second));
    }
    std::ranges::sort(result_.sharpEdges);
  }

  const Lattice& old_;
  Topology topology_;
  Id cell_, cellPoint_ = kNoId;
  Lattice result_;
  std::map<Id, Id> edgePoint_, facePoint_;
  std::map<Id, std::vector<Id>> partsOf_, cornerFaces_;
};

}  // namespace

Solid carved(const Solid& solid, Id cell) {
  requireBelow(cell, solid.control.cells.size(), "carve");
  if (solid.control.cells.size() == 1)
    throw Error("carve: found the last cell, expected one to stay");
  Lattice lattice = solid.control;
  lattice.cells = without(lattice.cells, cell);
  return withControl(solid, lattice, numbersFor(solid, lattice), "carve");
}

Solid extruded(const Solid& solid, Id face, double length) {
  requireBelow(face, solid.control.faces.size(), "extrude");
  Lattice lattice = solid.control;
  const Topology topology(lattice);
  if (topology.boundaryFace[face] == 0)
    throw Error("extrude: found a face inside, expected one on the surface");
  const std::vector<Id> loop = outwardLoop(lattice, face);
  const glm::dvec3 area = areaNormal(lattice, loop);
  if (!(glm::length(area) > 0))
    throw Error("extrude: found a face without area, expected one with");
  const glm::dvec3 normal = glm::normalize(area);
  // As far as the cell behind reaches back from the face.
  if (length <= 0) {
    const auto behind = topology.cellPoints[topology.faceCells[face][0]];
    length = 2 * glm::dot(meanOf(lattice, loop) - meanOf(lattice, behind), normal);
    if (!(length > 0)) length = std::sqrt(glm::length(area));
  }
  std::vector<Id> top;
  for (const Id point : loop) {
    top.push_back(static_cast<Id>(lattice.points.size()));
    lattice.points.push_back(lattice.points[point] + length * normal);
  }
  const auto lid = static_cast<Id>(lattice.faces.size());
  lattice.faces.add(top);
  Bridge(lattice).add(face, lid, loop, top);
  return withControl(solid, lattice, numbersFor(solid, lattice), "extrude");
}

Solid joined(const Solid& solid, Id faceA, Id faceB, std::string* warning) {
  requireBelow(faceA, solid.control.faces.size(), "join");
  requireBelow(faceB, solid.control.faces.size(), "join");
  Lattice lattice = solid.control;
  const Topology topology(lattice);
  if (faceA == faceB) throw Error("join: found one face, expected two");
  if (topology.boundaryFace[faceA] == 0 || topology.boundaryFace[faceB] == 0)
    throw Error("join: found a face inside, expected two on the surface");
  const auto a = outwardLoop(lattice, faceA), b = outwardLoop(lattice, faceB);
  if (a.size() != b.size())
    throw Error("join: found faces of " + std::to_string(a.size()) + " and " +
                std::to_string(b.size()) + " points, expected equally many");
  Bridge(lattice).add(faceA, faceB, a, facing(lattice, a, b));
  const auto shared = [&](Id n) { return std::ranges::find(b, n) != b.end(); };
  if (warning != nullptr && std::ranges::any_of(a, shared))
    *warning = "join: the faces share points; thin cells there turn inside out easily";
  return withControl(solid, lattice, numbersFor(solid, lattice), "join");
}

Solid subdivided(const Solid& solid, Id cell) {
  requireBelow(cell, solid.control.cells.size(), "subdivide");
  const Lattice lattice = LocalSplit(solid.control, cell).run();
  return withControl(solid, lattice, numbersFor(solid, lattice), "subdivide");
}

Solid sharpened(const Solid& solid, Element element, Id n, Sharp sharp) {
  Solid result = solid;
  Lattice& lattice = result.control;
  const Topology topology(lattice);
  const auto put = [&](auto& list, const auto& item) {
    std::erase(list, item);
    if (sharp == Sharp::yes) list.push_back(item);
    std::ranges::sort(list);
  };
  if (element == Element::point) {
    requireBelow(n, lattice.points.size(), "sharp");
    put(lattice.sharpPoints, n);
  } else if (element == Element::edge) {
    requireBelow(n, topology.edges.size(), "sharp");
    put(lattice.sharpEdges, topology.edges[n]);
  } else if (element == Element::face) {
    requireBelow(n, lattice.faces.size(), "sharp");
    for (const Id edge : topology.faceEdges[n]) put(lattice.sharpEdges, topology.edges[edge]);
  } else {
    throw Error("sharp: found a cell, expected a face, an edge or a point");
  }
  return result;
}

}  // namespace bozzetto
