// The control lattice of a subdivision solid (McDonnell & Qin 2002, §3.2, §4): points, faces and
// cells of any polyhedral kind. Edges and all neighbourhoods are derived, and derived anew after a
// tool has changed them: the paper's radial edges, simplified.
#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bozzetto/solid/lists.hpp"

namespace bozzetto {

/// Two different points of a lattice, the smaller number first.
using PointPair = std::array<Id, 2>;
PointPair pointPair(Id a, Id b);

/// A value. Points nobody uses are allowed; `compacted` takes them out.
struct Lattice {
  std::vector<glm::dvec3> points;     ///< world units
  Lists faces;                        ///< points round each face, either way round
  Lists cells;                        ///< faces of each cell; a face has one or two cells
  std::vector<PointPair> sharpEdges;  ///< rising; of boundary edges they make creases
  std::vector<Id> sharpPoints;        ///< rising; of boundary points they make corners

  friend bool operator==(const Lattice&, const Lattice&) = default;
};

/// Everything that follows from faces and cells. Lists are rising unless said otherwise.
struct Topology {
  std::vector<PointPair> edges;  ///< in order of their first appearance in faces
  Lists faceEdges;               ///< edge n joins points n and n + 1 of the face
  Lists faceCells, edgeFaces, edgeCells, pointEdges, pointFaces, pointCells, cellEdges, cellPoints;
  std::vector<std::uint8_t> boundaryFace, boundaryEdge, boundaryPoint;  ///< 1 where so; a
  ///< face is on the boundary when it has fewer than two cells

  explicit Topology(const Lattice& lattice);

  /// The edge between two points, kNoId when there is none.
  Id edgeBetween(Id a, Id b) const;
  Id otherEnd(Id edge, Id point) const {
    return edges[edge][0] == point ? edges[edge][1] : edges[edge][0];
  }
};

/// The first broken promise, if any: numbers in range, places finite, faces of three or more
/// different points, cells closed (every edge of a cell between exactly two of its faces), faces
/// with one or two cells, none twice. O(n).
std::optional<std::string> validate(const Lattice& lattice);

/// The same lattice without points and faces that no cell uses. `oldPoints[n]` is what point n was.
struct Compacted {
  Lattice lattice;
  std::vector<Id> oldPoints;
};
Compacted compacted(const Lattice& lattice);

/// Mean of some points of the lattice.
glm::dvec3 meanOf(const Lattice& lattice, std::span<const Id> points);

}  // namespace bozzetto
