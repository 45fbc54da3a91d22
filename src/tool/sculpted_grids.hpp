// The grids of a sculpture that stamps read: distances to it, and the room of its handle.
#pragma once
#include "tool/freeform.hpp"

namespace bozzetto {

/// How far round a tool they reach, and where corners of the clay lie in them. They are as fine as
/// the tool is read, and yet of at most some 128 cells a side.
class SculptedGrids {
 public:
  /// `tool` in cells, `rim` in its reference radii.
  SculptedGrids(const ToolShape& tool, double rim);

  const SculptureLevel& level() const { return sculpture_->level(level_); }
  int reach() const { return reach_; }             ///< cells of the level
  double radius() const { return radius_; }        ///< of reference, in them
  glm::dvec3 contact() const { return contact_; }  ///< likewise, of no known length

  /// Reads a block of side³ corners row by row; `low` of the grid.
  template <class Grid>
  void read(const Grid& grid, const LocalFrame& frame, Key first, int side, float scale,
            float* result) const {
    GridRow row = rowsFrom(frame, grid.low());
    row.scale = scale;
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j, result += side) {
        begin(frame, first + Key{i, j, 0}, row);
        grid.row(row, side, result);
      }
  }

 private:
  GridRow rowsFrom(const LocalFrame& frame, Key low) const;
  static void begin(const LocalFrame& frame, Key corner, GridRow& row);

  std::shared_ptr<const Sculpture> sculpture_;
  int level_, reach_;
  double radius_, shrink_;
  glm::dvec3 base_, contact_;
};

}  // namespace bozzetto
