// Rows of places in a plain grid of numbers.
#pragma once
#include <array>
#include <cstdint>

namespace bozzetto {

/// Places start + n·step in units of so many cells, from an offset in cells from the grid's low.
struct GridRow {
  std::array<std::int32_t, 3> start, step;
  float perUnit;
  std::array<float, 3> offset;
  float scale;
};

/// The numbers there × scale, up to 8, trilinear; beyond the grid the nearest. k is fastest.
void readRow(const float* grid, const std::array<int, 3>& wide, const GridRow& places, int count,
             float* result);

}  // namespace bozzetto
