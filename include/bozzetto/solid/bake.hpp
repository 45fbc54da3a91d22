// From solid to clay: the smooth surface of a solid fills corners with density and colour
// (solid.md §3).
#pragma once
#include "bozzetto/base/progress.hpp"
#include "bozzetto/field/field.hpp"
#include "bozzetto/solid/lattice.hpp"

namespace bozzetto {

struct BakeOptions {
  int levels = 2;  ///< refinements of the surface before it is filled, 0 … 6
  Colour colour{};
};

struct BakeReport {
  double volume = 0;       ///< inside the refined surface, world units
  std::int64_t dirty = 0;  ///< corners that were raised
  std::size_t triangles = 0;
};

/// Raises every corner to clamp(½ − signed distance/(2·spacing)) and colours it where that raises
/// it; held corners less so. Inside is where the surface winds round, so parts that overlap make
/// one body. Throws Error, before anything changes, for levels out of range, surfaces of more than
/// 2²³ blocks, and places beyond the workspace. O(surface in cells), in parallel, same result on
/// any number of threads.
template <int Side>
BakeReport bake(Edit<CornerBlock<Side>>& edit, const FieldScale& scale, const Lattice& control,
                const BakeOptions& options, Progress& progress = Progress::none());

extern template BakeReport bake(Edit<CornerBlock<1>>&, const FieldScale&, const Lattice&,
                                const BakeOptions&, Progress&);
extern template BakeReport bake(Edit<CornerBlock<8>>&, const FieldScale&, const Lattice&,
                                const BakeOptions&, Progress&);

}  // namespace bozzetto
