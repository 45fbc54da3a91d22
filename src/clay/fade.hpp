// Where a region cuts clay, what is beyond stands still. Clay that moves freely up to there would
// leave a step; so it moves less and less.
#pragma once
#include "clay/region.hpp"

namespace bozzetto::clay {

/// Fills the region's `fade`: 1 … 0 over so many cells towards sides that cut clay. O(cells of the
/// box).
void fadeTowardsRim(Region& region, double cells);

}  // namespace bozzetto::clay
