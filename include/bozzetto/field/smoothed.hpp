// The field as it may be shown: moved clay has edges of one cell, and on slopes that hardly rise
// such edges make terraces (clay.md §0.3). Looking at a filtered copy leaves the clay sharp.
#pragma once
#include "bozzetto/field/field.hpp"

namespace bozzetto {

/// The field with every density the binomial mean, [1 2 1]/4 along each axis, of the 27 round it.
/// Corners that had no clay get the attributes of the densest of these. Keeps the mass; draws a
/// ball of radius R in by 1/2R cells. In parallel, O(blocks); shares blocks where nothing changes.
Clay smoothed(const Clay& field);

}  // namespace bozzetto
