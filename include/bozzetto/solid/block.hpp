// Control lattices to begin with: blocks of cubical cells.
#pragma once
#include <array>
#include <functional>
#include <vector>

#include "bozzetto/grid/key.hpp"
#include "bozzetto/solid/lattice.hpp"

namespace bozzetto {

struct BlockOptions {
  Key cells{1, 1, 1};        ///< along each axis, 1 … 256; at most 2¹⁸ together
  glm::dvec3 edge{1};        ///< of a cell, world units, > 0 on each axis
  glm::dvec3 centre{0};      ///< of the whole block, removed cells and all
  std::vector<Key> removed;  ///< cells (0,0,0) … cells − 1 left out
};

/// A lattice whose points have names: point (i, j, k) of the block lies i, j, k edges from its
/// lowest corner.
struct NamedLattice {
  Lattice lattice;
  std::vector<Key> names;  ///< one a point
};

/// Throws Error for counts, sizes and removed cells that are out of range and when nothing is left.
/// Cells are in lexicographic order of their names.
NamedLattice makeBlock(const BlockOptions& options);

}  // namespace bozzetto
