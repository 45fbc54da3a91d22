// Cells that tools cover, by rows of eight: where clay may have no room.
#pragma once
#include "clay/fours.hpp"
#include "clay/region.hpp"

namespace bozzetto::clay {

/// A cell of these eight holds more than it has room for.
inline bool anyCrowded(const Region& region, std::size_t first) {
  FourMasks crowded{};
  for (const std::size_t n : {first, first + Region::kTile / 2})
    crowded |= fourAt(&region.value[n]) > allFour(1) - fourAt(&region.cover[n]);
  return any(crowded);
}

/// Calls back for the cells of tools that hold more than they have room for, in the order they were
/// painted; more than once where tools overlap.
template <class Callback>
void forCrowded(const Region& region, const Callback& callback) {
  for (const CoveredRow& row : region.covered) {
    if (!anyCrowded(region, row.first)) continue;
    for (std::uint32_t n = 0; n < Region::kTile; ++n) {
      const std::uint32_t cell = row.first + n;
      const bool isCovered = (row.cells >> n & 1) != 0;
      if (isCovered && region.value[cell] > 1 - region.cover[cell]) callback(cell);
    }
  }
}

}  // namespace bozzetto::clay
