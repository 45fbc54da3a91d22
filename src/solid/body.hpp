// What the solvers of a solid work on: its free control points, the matrix to its mass points, and
// the springs between those.
#pragma once
#include <vector>

#include "bozzetto/solid/physics.hpp"
#include "bozzetto/solid/refine.hpp"
#include "bozzetto/solid/solid.hpp"
#include "solid/springs.hpp"

namespace bozzetto {

using PlaceList = std::vector<glm::dvec3>;

/// Physical window, pins and trimming are one mechanism: d = A p over the free points, plus a
/// constant part from the fixed ones (§6.4).
struct Body {
  Refined refined;
  Topology topology;
  WeightRows toMass, toControl;            ///< A of free points, and its transpose
  std::vector<Id> free;                    ///< control points that move
  PlaceList fixedPart;                     ///< of mass points, from those that do not
  std::vector<double> mass;                ///< a mass point each; 0 where trimmed
  std::vector<Id> springEdges, quadFaces;  ///< which refined edge and face each spring is of
  Springs springs;

  explicit Body(const Solid& solid);

  PlaceList placesOf(const PlaceList& free) const;  ///< d
  void placesOf(const PlaceList& free, PlaceList& places) const;
};

/// Springs between the mass points of a refined lattice; rest shape as the matter says, or as the
/// lattice lies.
Springs springsOf(const Lattice& refined, const Topology& topology, const Solid& solid,
                  std::vector<Id>* edges = nullptr, std::vector<Id>* faces = nullptr);

/// Interior angles of all faces, corner by corner.
std::vector<double> anglesOf(const Lattice& lattice, Places places);
std::vector<double> lengthsOf(const Topology& topology, Places places);

}  // namespace bozzetto
