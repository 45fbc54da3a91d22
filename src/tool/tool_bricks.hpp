// Where a tool is all clay or all air, so that what reads it there need not read it.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "bozzetto/grid/key.hpp"

namespace bozzetto {

/// What some corners of a tool are, all together: full is 1 everywhere. Kinds of parts make that of
/// the whole by `and`.
enum class ToolKind : std::uint8_t { varied, empty, full };

/// Bricks of 2³ corners, each with its distance to the nearest one that is not like it: one look
/// tells what all corners near a place are. Places count from the low end of the box; beyond it
/// is air.
class ToolBricks {
 public:
  ToolBricks() = default;
  /// Of a box's cells, by their lowest corners, k fastest; it has even sides and a rim of air.
  /// O(corners).
  ToolBricks(const std::array<int, 3>& wide, const std::vector<ToolKind>& cells);

  /// How far the bricks reach that hold the corners `half` away from a place on any axis.
  static int bricksFor(int half) { return (half + 1) / 2; }
  /// What the corners so many bricks round a place are; may miss that they are alike.
  ToolKind around(Key place, int bricks) const {
    const std::uint8_t near = near_[nearest(place)];
    if ((near & kFarthest) <= bricks) return ToolKind::varied;
    return (near & kFull) != 0 ? ToolKind::full : ToolKind::empty;
  }
  /// What the corners low … high are; the same.
  ToolKind kindOf(Key low, Key high) const;

 private:
  static constexpr int kFarthest = 7, kFull = 8;  // rows and blocks ask for 3 and 5 at most

  // The entry of the brick at a place, or of the one next to it.
  std::size_t nearest(Key place) const {
    const auto on = [&](std::int32_t at, std::size_t axis) {
      return static_cast<std::size_t>(std::clamp((at >> 1) + 1, 1, wide_[axis] - 2));
    };
    return (on(place.i, 0) * static_cast<std::size_t>(wide_[1]) + on(place.j, 1)) *
               static_cast<std::size_t>(wide_[2]) +
           on(place.k, 2);
  }
  std::array<int, 3> wide_{};       // in bricks, with a rim of one that nobody asks for
  std::vector<std::uint8_t> near_;  // distance, 0 where corners differ; kFull of clay
};

}  // namespace bozzetto
