#include "tool/tool_box.hpp"

#include <algorithm>

#include "tool/density_grid.hpp"
#include "tool/float_bits.hpp"

namespace bozzetto {
namespace {

// Of cells, along one axis after the other; cells at the upper faces are air.
std::vector<ToolKind> kindsOf(const ToolBox& box) {
  const std::ptrdiff_t strideJ = box.wide[2], strideI = strideJ * box.wide[1];
  const std::size_t count = box.value.size();
  std::vector<ToolKind> kinds(count, ToolKind::empty);
  for (std::size_t n = 0; n < count; ++n) {
    const std::int32_t value = bits(box.value[n]);  // 0…1
    kinds[n] = static_cast<ToolKind>((value == 0 ? 1 : 0) | (value == bits(1.0f) ? 2 : 0));
  }
  for (const std::ptrdiff_t stride : {std::ptrdiff_t{1}, strideJ, strideI}) {
    const ToolKind* next = kinds.data() + stride;
    for (std::size_t n = 0; n + static_cast<std::size_t>(stride) < count; ++n)
      kinds[n] = ToolKind(std::uint8_t(kinds[n]) & std::uint8_t(next[n]));
  }
  return kinds;
}

}  // namespace

ToolBox::ToolBox(const Clay& clay, const KeyBox& bounds) {
  if (clay.tree.empty()) return;
  const Key rim{kRim, kRim, kRowRim};
  low = bounds.low - rim;
  const Key high = bounds.high + rim;
  const KeyBox box{low, high + Key{1, 1, 1}};
  if (box.count() > kMostCorners) return;
  for (const Axis axis : kAxes)
    wide[static_cast<std::size_t>(index(axis))] = (high[axis] - low[axis] + 2) & ~1;
  value.assign(std::size_t(wide[0]) * std::size_t(wide[1]) * std::size_t(wide[2]), 0);
  readDensities(clay, low, wide, value);
  for (float& each : value) each = lesser(each, 1.0f);
  kinds = kindsOf(*this);
  bricks = ToolBricks(wide, kinds);
}

}  // namespace bozzetto
