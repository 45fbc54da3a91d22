#include "solid/body.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <string>

#include "bozzetto/base/error.hpp"

namespace bozzetto {
namespace {

constexpr double kStraightAngle = 1e-3;  // from 0 or π: no gradient to speak of

void requireSize(std::size_t found, std::size_t expected, const char* what) {
  if (found == 0 || found == expected) return;
  throw Error(std::string("solid: found ") + std::to_string(found) + " " + what + ", expected " +
              std::to_string(expected));
}

template <class T>
T valueAt(const std::vector<T>& list, std::size_t n, T usual) {
  return list.empty() ? usual : list[n];
}

// Only what some cell that takes part has.
class Part {
 public:
  Part(const Lattice& refined, const Topology& topology, const SolidMatter& matter)
      : topology_(topology), trimmed_(matter.trimmed) {
    requireSize(trimmed_.size(), refined.cells.size(), "trimmed cells");
  }
  bool point(Id n) const { return any(topology_.pointCells[n]); }
  bool edge(Id n) const { return any(topology_.edgeCells[n]); }
  bool face(Id n) const { return any(topology_.faceCells[n]); }

 private:
  bool any(std::span<const Id> cells) const {
    return trimmed_.empty() ||
           std::ranges::any_of(cells, [&](Id cell) { return trimmed_[cell] == 0; });
  }

  const Topology& topology_;
  const std::vector<std::uint8_t>& trimmed_;
};

std::vector<double> massesOf(const Refined& refined, const Topology& topology, const Solid& solid) {
  const Part part(refined.lattice, topology, solid.matter);
  requireSize(solid.matter.mass.size(), refined.lattice.points.size(), "masses");
  std::vector<double> mass(refined.lattice.points.size());
  for (Id n = 0; n < mass.size(); ++n)
    mass[n] = part.point(n) ? valueAt(solid.matter.mass, n, 1.0) : 0.0;
  return mass;
}

// Control points that are neither fixed nor without any mass of their own.
std::vector<Id> freePoints(const Solid& solid, const WeightRows& rows,
                           const std::vector<double>& mass) {
  requireSize(solid.matter.fixed.size(), solid.control.points.size(), "fixed points");
  std::vector<double> own(solid.control.points.size(), 0);
  for (std::size_t row = 0; row < rows.rowCount(); ++row)
    for (Id n = rows.start[row]; n < rows.start[row + 1]; ++n)
      own[rows.columns[n]] += rows.weights[n] * mass[row];
  std::vector<Id> free;
  for (Id n = 0; n < own.size(); ++n)
    if (own[n] > 1e-6 && valueAt<std::uint8_t>(solid.matter.fixed, n, 0) == 0) free.push_back(n);
  return free;
}

WeightRows freeColumns(const WeightRows& rows, const std::vector<Id>& free) {
  std::vector<Id> fresh(rows.columnCount, kNoId);
  for (Id n = 0; n < free.size(); ++n) fresh[free[n]] = n;
  WeightRows result;
  result.columnCount = free.size();
  for (std::size_t row = 0; row < rows.rowCount(); ++row) {
    for (Id n = rows.start[row]; n < rows.start[row + 1]; ++n) {
      if (fresh[rows.columns[n]] == kNoId) continue;
      result.columns.push_back(fresh[rows.columns[n]]);
      result.weights.push_back(rows.weights[n]);
    }
    result.start.push_back(static_cast<Id>(result.columns.size()));
  }
  return result;
}

QuadSprings quadOf(const Lattice& refined, Id face, const std::vector<double>& lengths,
                   const Topology& topology, const Solid& solid) {
  const auto loop = refined.faces[face];
  if (loop.size() != 4) throw Error("solid: found a face that is no quad, expected refined ones");
  const auto sides = topology.faceEdges[face];
  QuadSprings quad;
  for (std::size_t c = 0; c < 4; ++c) {
    const double hardness = valueAt(solid.matter.hardness, loop[c], 1.0);
    quad.points[c] = loop[c];
    quad.stiffness[c] =
        cornerStiffness(solid.settings.angular * solid.settings.stiffness * hardness,
                        lengths[sides[c]], lengths[sides[(c + 3) % 4]]);
  }
  return quad;
}

}  // namespace

std::vector<double> lengthsOf(const Topology& topology, Places places) {
  std::vector<double> lengths;
  lengths.reserve(topology.edges.size());
  for (const PointPair& edge : topology.edges)
    lengths.push_back(glm::distance(places[edge[0]], places[edge[1]]));
  return lengths;
}

std::vector<double> anglesOf(const Lattice& lattice, Places places) {
  std::vector<double> angles;
  angles.reserve(lattice.faces.itemCount());
  for (std::size_t face = 0; face < lattice.faces.size(); ++face) {
    const auto loop = lattice.faces[face];
    for (std::size_t n = 0; n < loop.size(); ++n) {
      const glm::dvec3 centre = places[loop[n]];
      const glm::dvec3 next = places[loop[(n + 1) % loop.size()]];
      const glm::dvec3 before = places[loop[(n + loop.size() - 1) % loop.size()]];
      angles.push_back(angleBetween(next - centre, before - centre).value);
    }
  }
  return angles;
}

Springs springsOf(const Lattice& refined, const Topology& topology, const Solid& solid,
                  std::vector<Id>* edges, std::vector<Id>* faces) {
  const SolidMatter& matter = solid.matter;
  requireSize(matter.hardness.size(), refined.points.size(), "hardnesses");
  requireSize(matter.lengths.size(), topology.edges.size(), "rest lengths");
  requireSize(matter.angles.size(), refined.faces.itemCount(), "rest angles");
  const auto lengths =
      matter.lengths.empty() ? lengthsOf(topology, refined.points) : matter.lengths;
  const auto angles = matter.angles.empty() ? anglesOf(refined, refined.points) : matter.angles;
  const Part part(refined, topology, matter);

  std::vector<NormalSpring> normal;
  for (Id n = 0; n < topology.edges.size(); ++n) {
    if (!part.edge(n)) continue;
    const auto [a, b] = topology.edges[n];
    const double hardness =
        0.5 * (valueAt(matter.hardness, a, 1.0) + valueAt(matter.hardness, b, 1.0));
    normal.push_back({a, b, solid.settings.stiffness * hardness, lengths[n]});
    if (edges != nullptr) edges->push_back(n);
  }
  std::vector<QuadSprings> quads;
  for (Id n = 0; n < refined.faces.size(); ++n) {
    if (!part.face(n)) continue;
    QuadSprings quad = quadOf(refined, n, lengths, topology, solid);
    for (std::size_t c = 0; c < 4; ++c) {
      quad.angle[c] = angles[refined.faces.startOf(n) + c];
      if (std::sin(quad.angle[c]) < kStraightAngle) quad.stiffness[c] = 0;
    }
    quads.push_back(quad);
    if (faces != nullptr) faces->push_back(n);
  }
  const bool paper = solid.settings.solver == Solver::paperExplicit ||
                     solid.settings.solver == Solver::paperImplicit;
  return {std::move(normal), std::move(quads), paper ? AngularLaw::angle : AngularLaw::cosine};
}

Body::Body(const Solid& solid)
    : refined(refine(solid.control, solid.settings.levels)),
      topology(refined.lattice),
      mass(massesOf(refined, topology, solid)),
      springs(springsOf(refined.lattice, topology, solid, &springEdges, &quadFaces)) {
  free = freePoints(solid, refined.rows, mass);
  toMass = freeColumns(refined.rows, free);
  toControl = toMass.transposed();
  PlaceList others = solid.control.points;
  for (const Id n : free) others[n] = glm::dvec3(0);
  fixedPart.resize(refined.rows.rowCount());
  refined.rows.apply(others, fixedPart);
}

void Body::placesOf(const PlaceList& points, PlaceList& places) const {
  places.resize(fixedPart.size());
  toMass.apply(points, places);
  for (std::size_t n = 0; n < places.size(); ++n) places[n] += fixedPart[n];
}

PlaceList Body::placesOf(const PlaceList& points) const {
  PlaceList places;
  placesOf(points, places);
  return places;
}

}  // namespace bozzetto
