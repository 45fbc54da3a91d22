#include "tool/tool_bricks.hpp"

namespace bozzetto {

namespace {

// What an entry and both beside it are together. At the ends of rows that is air beside air.
void narrow(std::vector<std::uint8_t>& kinds, std::size_t stride, std::vector<std::uint8_t>& made) {
  const std::uint8_t* from = kinds.data();
  std::uint8_t* to = made.data();
  std::copy_n(from, stride, to);
  std::copy(kinds.end() - static_cast<std::ptrdiff_t>(stride), kinds.end(),
            made.end() - static_cast<std::ptrdiff_t>(stride));
  for (std::size_t n = stride; n + stride < kinds.size(); ++n)
    to[n] = static_cast<std::uint8_t>(from[n] & from[n - stride] & from[n + stride]);
  kinds.swap(made);
}

}  // namespace

ToolBricks::ToolBricks(const std::array<int, 3>& wide, const std::vector<ToolKind>& cells) {
  for (std::size_t axis = 0; axis < 3; ++axis) wide_[axis] = wide[axis] / 2 + 2;
  const auto wideJ = static_cast<std::size_t>(wide_[1]), wideK = static_cast<std::size_t>(wide_[2]);
  std::vector<std::uint8_t> kinds(static_cast<std::size_t>(wide_[0]) * wideJ * wideK,
                                  static_cast<std::uint8_t>(ToolKind::empty));
  for (int i = 0; i < wide[0]; i += 2)
    for (int j = 0; j < wide[1]; j += 2) {
      const ToolKind* row = cells.data() + (std::ptrdiff_t{i} * wide[1] + j) * wide[2];
      std::uint8_t* to = kinds.data() + nearest({i, j, 0});
      for (int k = 0; k < wide[2]; k += 2) to[k / 2] = static_cast<std::uint8_t>(row[k]);
    }
  constexpr auto full = static_cast<std::uint8_t>(ToolKind::full);
  near_.resize(kinds.size());
  for (std::size_t n = 0; n < kinds.size(); ++n) near_[n] = kinds[n] == full ? kFull : 0;
  // What is alike so far round a brick adds one to its distance.
  std::vector<std::uint8_t> made(kinds.size());
  for (int distance = 1; distance <= kFarthest; ++distance) {
    for (std::size_t n = 0; n < kinds.size(); ++n)
      near_[n] = static_cast<std::uint8_t>(near_[n] + (kinds[n] != 0 ? 1 : 0));
    for (const std::size_t stride : {std::size_t{1}, wideK, wideJ * wideK})
      narrow(kinds, stride, made);
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
