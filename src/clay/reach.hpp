// Which clay a step has to look at.
#pragma once
#include "bozzetto/field/field.hpp"
#include "clay/region.hpp"

namespace bozzetto::clay {

/// Tiles of the working set: 2²⁴ cells of clay, 1.2 GB.
inline constexpr std::size_t kMostTiles = 32768;
/// Corners of its box, air included; memory is taken where clay is only.
inline constexpr std::int64_t kMostCorners = std::int64_t{1} << 29;

/// Tiles of air round the clay of a region.
inline constexpr std::int32_t kRoom = 2;

struct Reach {
  KeyBox box;         ///< corners, in whole tiles; empty when there is no clay
  bool whole = true;  ///< no clay goes on beyond the box
};

/// All tiles of clay that hang together with those in `seeds`. Gives up and returns a box round
/// the seeds, `whole` false, when there are too many.
template <int Side>
Reach connectedClay(const Edit<CornerBlock<Side>>& edit, const KeyBox& seeds);

/// Some tile of the box holds clay. O(tiles in the box).
template <int Side>
bool anyClay(const Edit<CornerBlock<Side>>& edit, const KeyBox& box);

/// All the clay there is.
template <int Side>
Reach allClay(const Edit<CornerBlock<Side>>& edit);

}  // namespace bozzetto::clay
