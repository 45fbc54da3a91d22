// The field as it may be shown: moved clay has edges of one cell, and on slopes that hardly rise
// such edges make terraces (clay.md §0.3). Looking at a filtered copy leaves the clay sharp.
#pragma once
#include <span>
#include <vector>

#include "bozzetto/field/field.hpp"

namespace bozzetto {

/// The field with every density the binomial mean, [1 2 1]/4 along each axis, of the 27 round it.
/// Corners that had no clay get the attributes of the densest of these. Keeps the mass; draws a
/// ball of radius R in by 1/2R cells. In parallel, O(blocks); shares blocks where nothing changes.
Clay smoothed(const Clay& field);

/// Brings `copy`, the smoothed copy of what the field was, up to what it is after corners in the
/// `changed` blocks (sorted, not overlapping) took their present values, also in the middle of an
/// edit. Gives the blocks of the copy that changed, sorted. In parallel, O(changed blocks).
std::vector<KeyRun> refreshSmoothed(Clay& copy, const Clay& field,
                                    std::span<const KeyRun> changed);

}  // namespace bozzetto
