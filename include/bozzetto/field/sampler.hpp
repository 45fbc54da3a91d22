// The field between its corners: trilinear value, gradient and colour at any place.
#pragma once
#include <array>
#include <glm/vec3.hpp>

#include "bozzetto/field/block_cache.hpp"
#include "bozzetto/field/field.hpp"

namespace bozzetto {

/// A place in cells: a corner and a fraction in [0, 1) from there along each axis.
struct CellPoint {
  Key base;
  glm::vec3 fraction{0};
};

/// The place `offset` cells from `origin`. Places beyond the workspace come out at its rim.
CellPoint cellPoint(Key origin, glm::dvec3 offset);

/// Samples one field; keeps the blocks found last, so that coherent places cost some ten
/// nanoseconds. Good while the field does not change; one per thread.
template <int Side>
class FieldSampler {
 public:
  explicit FieldSampler(const Field<Side>& field) : blocks_(field.tree) {}

  /// Density at a corner, and its colour and hold; 0 where nothing is stored.
  float corner(Key key);
  Attributes attributes(Key key);

  /// Trilinear density: the corner's own value at integers.
  float value(const CellPoint& place);

  /// Change of density per cell: central differences at the eight corners, interpolated
  /// trilinearly, so that it is continuous. Points into the clay.
  glm::vec3 gradient(const CellPoint& place);

  /// Mean colour of the eight corners weighted by closeness and density; grey 0 where there is no
  /// clay.
  Colour colour(const CellPoint& place);

  /// To be called when the field has changed.
  void forget() { blocks_.forget(); }

 private:
  BlockCache<CornerBlock<Side>> blocks_;
};

extern template class FieldSampler<1>;
extern template class FieldSampler<8>;

}  // namespace bozzetto
