#include "bozzetto/solid/refine.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bozzetto/base/error.hpp"
#include "solid/masks.hpp"

namespace bozzetto {
namespace {

constexpr double kMostCells = 1 << 22;

// New faces and cells (solid.md §1, 5): a quad for each corner of each face, one for each edge of
// each cell, a cell for each corner of each cell.
class Splitter {
 public:
  Splitter(const Lattice& lattice, const Topology& topology, Lattice& result)
      : lattice_(lattice), topology_(topology), result_(result) {
    edgePoint_ = static_cast<Id>(lattice.points.size());
    facePoint_ = edgePoint_ + static_cast<Id>(topology.edges.size());
    cellPoint_ = facePoint_ + static_cast<Id>(lattice.faces.size());
  }

  void run() {
    for (Id face = 0; face < lattice_.faces.size(); ++face) splitFace(face);
    quadOfEdge_.assign(topology_.edges.size(), kNoId);
    for (Id cell = 0; cell < lattice_.cells.size(); ++cell) splitCell(cell);
    handTagsDown();
  }

 private:
  void splitFace(Id face) {
    const auto loop = lattice_.faces[face];
    const auto sides = topology_.faceEdges[face];
    for (std::size_t n = 0; n < loop.size(); ++n) {
      const Id before = sides[(n + loop.size() - 1) % loop.size()];
      result_.faces.add({loop[n], edgePoint_ + sides[n], facePoint_ + face, edgePoint_ + before});
    }
  }

  // The quad of corner n of a face is the face's first new quad + n.
  Id cornerQuad(Id face, std::size_t n) const {
    return static_cast<Id>(lattice_.faces.startOf(face) + n);
  }

  void splitCell(Id cell) {
    for (const Id edge : topology_.cellEdges[cell]) {
      std::array<Id, 2> beside{kNoId, kNoId};
      for (const Id face : lattice_.cells[cell]) {
        const auto sides = topology_.faceEdges[face];
        if (std::ranges::find(sides, edge) == sides.end()) continue;
        beside[beside[0] == kNoId ? 0 : 1] = face;
      }
      quadOfEdge_[edge] = static_cast<Id>(result_.faces.size());
      result_.faces.add(
          {edgePoint_ + edge, facePoint_ + beside[0], cellPoint_ + cell, facePoint_ + beside[1]});
    }
    for (const Id point : topology_.cellPoints[cell]) addCornerCell(cell, point);
    for (const Id edge : topology_.cellEdges[cell]) quadOfEdge_[edge] = kNoId;
  }

  void addCornerCell(Id cell, Id point) {
    corner_.clear();
    for (const Id face : lattice_.cells[cell]) {
      const auto loop = lattice_.faces[face];
      const auto place = std::ranges::find(loop, point);
      if (place != loop.end())
        corner_.push_back(cornerQuad(face, static_cast<std::size_t>(place - loop.begin())));
    }
    for (const Id edge : topology_.pointEdges[point])
      if (quadOfEdge_[edge] != kNoId) corner_.push_back(quadOfEdge_[edge]);
    result_.cells.add(corner_);
  }

  void handTagsDown() {
    result_.sharpPoints = lattice_.sharpPoints;
    for (const PointPair& edge : lattice_.sharpEdges) {
      const Id known = topology_.edgeBetween(edge[0], edge[1]);
      if (known == kNoId) continue;
      const Id middle = edgePoint_ + known;
      result_.sharpEdges.push_back({edge[0], middle});
      result_.sharpEdges.push_back({edge[1], middle});
    }
    std::ranges::sort(result_.sharpEdges);
  }

  const Lattice& lattice_;
  const Topology& topology_;
  Lattice& result_;
  Id edgePoint_, facePoint_, cellPoint_;
  std::vector<Id> quadOfEdge_, corner_;
};

WeightRows identityRows(std::size_t count) {
  WeightRows rows;
  rows.columnCount = count;
  for (Id n = 0; n < count; ++n) {
    rows.columns.push_back(n);
    rows.weights.push_back(1);
    rows.start.push_back(n + 1);
  }
  return rows;
}

}  // namespace

Refined refineOnce(const Lattice& lattice) {
  const Topology topology(lattice);
  Refined result;
  result.rows = Masks(lattice, topology).rows();
  result.lattice.points.resize(result.rows.rowCount());
  result.rows.apply(lattice.points, result.lattice.points);
  Splitter(lattice, topology, result.lattice).run();
  return result;
}

double refinedCellCount(const Lattice& lattice, int levels) {
  if (levels <= 0) return static_cast<double>(lattice.cells.size());
  const Topology topology(lattice);
  return static_cast<double>(topology.cellPoints.itemCount()) * std::pow(8.0, levels - 1);
}

Refined refine(const Lattice& lattice, int levels) {
  if (levels < 0 || levels > 8 || refinedCellCount(lattice, levels) > kMostCells) {
    throw Error("solid: found " + std::to_string(levels) + " levels of " +
                std::to_string(lattice.cells.size()) + " cells, expected at most 2^22 cells");
  }
  Refined result{lattice, identityRows(lattice.points.size())};
  for (int level = 0; level < levels; ++level) {
    Refined next = refineOnce(result.lattice);
    if (level > 0) next.rows = next.rows.after(result.rows);
    result = std::move(next);
  }
  return result;
}

}  // namespace bozzetto
