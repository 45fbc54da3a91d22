// Clay carried along by a lattice round it: pose the lattice, and the clay inside follows
// (solid.md §3).
#pragma once
#include <span>

#include "bozzetto/base/progress.hpp"
#include "bozzetto/field/field.hpp"
#include "bozzetto/solid/block.hpp"

namespace bozzetto {

/// A block of `cells` cells that just hold the box from `low` to `high` and one cell of padding on
/// every side, so that refinement, which shrinks, leaves none of it out. Points are named from
/// (0,0,0) to cells + 2. Throws Error for counts out of range and boxes without extent.
NamedLattice wrapBlock(const glm::dvec3& low, const glm::dvec3& high, Key cells);

/// The box of all clay, its surface and half a cell more. Throws Error when there is none.
template <int Side>
std::array<glm::dvec3, 2> clayBox(const Field<Side>& field);

enum class KeepMass { no, yes };

struct WrapOptions {
  int levels = 2;                     ///< of refinement of the map, 1 … 4
  KeepMass keepMass = KeepMass::yes;  ///< band of the surface moves until the mass is as before
};

struct WrapReport {
  double massBefore = 0, massAfter = 0;  ///< cells
  double offset = 0;                     ///< what the band was raised by, as a density
  std::int64_t dirty = 0;                ///< corners written
};

/// Every place inside the lattice at `rest` goes to its place inside the lattice at `posed`; clay
/// outside both stays. Values and colours are taken backwards: what was at the place a corner came
/// from. Throws Error for lattices that are not alike, levels out of range, places beyond the
/// workspace. O(corners near the clay's surface inside), in parallel, same result on any number of
/// threads. Where the posed lattice folds over itself the first cell decides.
template <int Side>
WrapReport applyWrap(Edit<CornerBlock<Side>>& edit, const FieldScale& scale, const Lattice& rest,
                     std::span<const glm::dvec3> posed, const WrapOptions& options,
                     Progress& progress = Progress::none());

extern template std::array<glm::dvec3, 2> clayBox(const Field<1>&);
extern template std::array<glm::dvec3, 2> clayBox(const Field<8>&);
extern template WrapReport applyWrap(Edit<CornerBlock<1>>&, const FieldScale&, const Lattice&,
                                     std::span<const glm::dvec3>, const WrapOptions&, Progress&);
extern template WrapReport applyWrap(Edit<CornerBlock<8>>&, const FieldScale&, const Lattice&,
                                     std::span<const glm::dvec3>, const WrapOptions&, Progress&);

}  // namespace bozzetto
