// The densities of some clay as a plain grid.
#pragma once
#include <array>
#include <vector>

#include "bozzetto/field/field.hpp"

namespace bozzetto {

/// Of the corners from `low`, k fastest, into what is zero. O(blocks of the clay + corners).
void readDensities(const Clay& clay, Key low, const std::array<int, 3>& wide,
                   std::vector<float>& density);

}  // namespace bozzetto
