// All of a tool's densities in one box: what reads it reads no trees.
#pragma once
#include <array>
#include <vector>

#include "bozzetto/field/field.hpp"
#include "tool/tool_bricks.hpp"

namespace bozzetto {

/// The corners of a tool with a rim of air, k fastest; values above 1 count as 1. Who reads beyond
/// the box may read at its rim: rows along k are air there for `kRowRim` corners, else for `kRim`.
struct ToolBox {
  /// Empty where the tool is larger than so many corners (16 MiB).
  static constexpr std::int64_t kMostCorners = 1 << 22;
  static constexpr int kRim = 2, kRowRim = 16;
  ToolBox(const Clay& clay, const KeyBox& bounds);

  Key low;
  std::array<int, 3> wide{};
  std::vector<float> value;
  ToolBricks bricks;
  std::vector<ToolKind> kinds;  ///< of cells, by their lowest corners
};

}  // namespace bozzetto
