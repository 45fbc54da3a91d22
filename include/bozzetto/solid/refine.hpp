// Subdivision: MacCracken & Joy's rules inside, Catmull & Clark's on the boundary, so that every
// refined point is a weighted mean of control points, d = A p (McDonnell & Qin, Eq. 1).
#pragma once
#include <span>
#include <vector>

#include "bozzetto/solid/lattice.hpp"

namespace bozzetto {

/// A sparse matrix by rows. Rows of subdivision sum to 1.
struct WeightRows {
  std::vector<Id> start{0};
  std::vector<Id> columns;
  std::vector<double> weights;
  std::size_t columnCount = 0;

  std::size_t rowCount() const { return start.size() - 1; }
  /// Σ weights · points, row by row. O(entries).
  void apply(std::span<const glm::dvec3> points, std::span<glm::dvec3> result) const;
  WeightRows transposed() const;
  /// First `inner`, then this: the matrix product this · inner.
  WeightRows after(const WeightRows& inner) const;
};

struct Refined {
  Lattice lattice;
  /// Points come as: one a control point, one an edge, one a face, one a cell, in their order.
  WeightRows rows;
};

/// One refinement. Faces of the result are quads, a cell for each corner of each old cell. Tags go
/// to both halves of a sharp edge and stay on sharp points.
Refined refineOnce(const Lattice& lattice);

/// `levels` ≥ 0 refinements and the matrix from control points to refined ones. Throws Error when
/// more than 2²² cells would come of it.
Refined refine(const Lattice& lattice, int levels);

/// How many cells `levels` refinements give. O(n) a level is not needed: cells times corners.
double refinedCellCount(const Lattice& lattice, int levels);

}  // namespace bozzetto
