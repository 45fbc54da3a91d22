#include "tool/tool_bricks.hpp"

namespace bozzetto {

ToolBricks::ToolBricks(const std::array<int, 3>& wide, const std::vector<float>& value) {
  for (std::size_t axis = 0; axis < 3; ++axis) wide_[axis] = wide[axis] / 2 + 2;
  near_.assign(std::size_t(wide_[0]) * std::size_t(wide_[1]) * std::size_t(wide_[2]), kFarthest);
  find(wide, value);
  spread(1);
  spread(-1);
}

// Which bricks are alike in themselves.
void ToolBricks::find(const std::array<int, 3>& wide, const std::vector<float>& value) {
  const std::ptrdiff_t nextJ = wide[2], nextI = nextJ * wide[1];
  for (int i = 0; i < wide[0]; i += 2)
    for (int j = 0; j < wide[1]; j += 2)
      for (int k = 0; k < wide[2]; k += 2) {
        const float* at = value.data() + i * nextI + j * nextJ + k;
        float low = at[0], high = at[0];
        for (const std::ptrdiff_t row : {std::ptrdiff_t{0}, nextJ, nextI, nextI + nextJ}) {
          low = std::min({low, at[row], at[row + 1]});
          high = std::max({high, at[row], at[row + 1]});
        }
        const int near = low >= 1 ? kFull | kFarthest : high > 0 ? 0 : kFarthest;
        near_[nearest({i, j, k})] = static_cast<std::uint8_t>(near);
      }
}

// One of the two passes of a distance transform with steps to all 26 neighbours: in the order of
// the places, or backwards.
void ToolBricks::spread(int way) {
  const std::ptrdiff_t nextJ = wide_[2], nextI = nextJ * wide_[1];
  const std::ptrdiff_t rows[4] = {nextJ, nextI + nextJ, nextI, nextI - nextJ};
  const auto passed = [&](std::uint8_t own, std::ptrdiff_t at) {
    const std::uint8_t other = near_[static_cast<std::size_t>(at)];
    return ((own ^ other) & kFull) == 0 ? (other & kFarthest) + 1 : 1;
  };
  const auto place = [&](int n, std::size_t axis) { return way > 0 ? n : wide_[axis] - 1 - n; };
  for (int i = 1; i + 1 < wide_[0]; ++i)
    for (int j = 1; j + 1 < wide_[1]; ++j)
      for (int k = 1; k + 1 < wide_[2]; ++k) {
        const std::ptrdiff_t at = place(i, 0) * nextI + place(j, 1) * nextJ + place(k, 2);
        std::uint8_t& own = near_[static_cast<std::size_t>(at)];
        if (own == 0) continue;
        int least = std::min(own & kFarthest, passed(own, at - way));
        for (const std::ptrdiff_t row : rows)
          for (const std::ptrdiff_t step : {row - 1, row, row + 1})
            least = std::min(least, passed(own, at - way * step));
        own = static_cast<std::uint8_t>((own & kFull) | least);
      }
}

// By eighths: boxes are looser the larger they are.
ToolKind ToolBricks::kindOf(Key low, Key high) const {
  const Key middle{(low.i + high.i) >> 1, (low.j + high.j) >> 1, (low.k + high.k) >> 1};
  int widest = 0;
  for (const Axis axis : kAxes) widest = std::max(widest, high[axis] - middle[axis]);
  const int half = (widest + 1) / 2, bricks = bricksFor(half);
  ToolKind all = ToolKind::varied;
  for (int n = 0; n < 8; ++n) {
    Key at;
    int bit = n;
    for (const Axis axis : kAxes) {
      at[axis] = (bit & 1) != 0 ? high[axis] - half : low[axis] + half;
      bit >>= 1;
    }
    const ToolKind kind = around(at, bricks);
    if (kind == ToolKind::varied || (n > 0 && kind != all)) return ToolKind::varied;
    all = kind;
  }
  return all;
}

}  // namespace bozzetto
