#include "tool/density_grid.hpp"

#include <algorithm>

namespace bozzetto {

void readDensities(const Clay& clay, Key low, const std::array<int, 3>& wide,
                   std::vector<float>& density) {
  const auto readRow = [&](const float* value, Key at) {
    if (at.i < 0 || at.j < 0 || at.i >= wide[0] || at.j >= wide[1]) return;
    const std::int32_t begin = std::max(0, -at.k), end = std::min(8, wide[2] - at.k);
    if (begin >= end) return;
    const std::ptrdiff_t first = (std::ptrdiff_t{at.i} * wide[1] + at.j) * wide[2] + at.k;
    std::copy(value + begin, value + end, density.begin() + (first + begin));
  };
  for (const auto& [key, run] : clay.tree)
    for (std::int32_t n = 0; n < run.length; ++n) {
      const Key first = BlockGeometry<8>::firstCornerOf(key + Key{0, 0, n}) - low;
      for (int row = 0; row < 64; ++row)
        readRow(&run.block->value[std::size_t(row * 8)], first + Key{row / 8, row % 8, 0});
    }
}

}  // namespace bozzetto
