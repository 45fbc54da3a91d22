// Finding what a hand or a pointer means: points, edges, faces and cells of a lattice, inside too.
#pragma once
#include <vector>

#include "bozzetto/solid/lattice.hpp"

namespace bozzetto {

enum class Element : std::uint8_t { point, edge, face, cell };
enum class PickFrom : std::uint8_t { everywhere, boundary };

/// The point, or the edge, face or cell whose middle is nearest to a place. kNoId when there is
/// none. Edges are those of `topology`. O(n).
Id nearest(const Lattice& lattice, const Topology& topology, Element element,
           const glm::dvec3& place, PickFrom from = PickFrom::everywhere);

/// Middle of an element.
glm::dvec3 middleOf(const Lattice& lattice, const Topology& topology, Element element, Id n);

struct PickRay {
  glm::dvec3 origin, direction;
  double reach = 0.01;  ///< how far beside a point or edge counts, per unit of depth
};

struct Picked {
  Id element;
  double depth;  ///< along the direction
};

/// All elements of the kind along a ray, nearest first: what lies behind can be had too. O(n).
std::vector<Picked> pickAlong(const Lattice& lattice, const Topology& topology, Element element,
                              const PickRay& ray);

}  // namespace bozzetto
