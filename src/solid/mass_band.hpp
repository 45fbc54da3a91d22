// Giving clay back the mass it had: the band of its surface is raised or lowered by one amount
// everywhere (solid.md §3).
#pragma once
#include <vector>

#include "bozzetto/field/field.hpp"

namespace bozzetto {

/// Raises every corner of these blocks by c·4b(1−b), b the densities blurred once, with one c so
/// that their sum becomes `target` (in full cells), to 1e-9 of it where there is room. Again with
/// new b while |c| would exceed ½. Returns the sum of all c.
double matchMass(Edit<CornerBlock<8>>& edit, const std::vector<Key>& blocks, double target);

/// Σ value over these blocks.
double massOf(const KeyTree<CornerBlock<8>>& tree, const std::vector<Key>& blocks);

}  // namespace bozzetto
