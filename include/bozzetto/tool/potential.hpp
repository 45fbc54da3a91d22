// The potential of a tool, evaluated block by block (Ferley §3.2, §4.1): with actions that take
// any potential, N potentials and M actions need no N × M kernels.
#pragma once
#include <array>
#include <glm/mat3x3.hpp>
#include <memory>

#include "bozzetto/grid/key.hpp"
#include "bozzetto/tool/shape.hpp"

namespace bozzetto {

/// Where a dab stands. Positions are in cells from `origin`, the cell of the stroke's first point,
/// so that a stroke far from the world's origin is computed with the same numbers as one near it.
struct DabPose {
  Key origin;
  glm::dvec3 position{0};     ///< of the tool's centre, cells from origin
  glm::dmat3 orientation{1};  ///< columns: the tool's axes in the world; may be a reflection
  glm::dvec3 radii{8, 8, 8};  ///< cells
};

/// Tool space along the grid: corner cell + (i,j,k) has the local position
/// ((first + i·step[0]) + j·step[1]) + k·step[2], evaluated in float in this order by every
/// kernel. |local| ≤ 1 on each axis is the tool's local box. `cell` is the dab's own, nearest to
/// its position: nearest, not lower, so that mirrored dabs give mirrored bits.
struct LocalFrame {
  Key cell;
  std::array<float, 3> first;
  std::array<std::array<float, 3>, 3> step;  ///< [grid axis][tool axis]
};

LocalFrame localFrame(const DabPose& pose);

class Potential {
 public:
  virtual ~Potential() = default;

  /// True only when every corner of the box has potential 0; `low` and `high` count from the
  /// frame's cell. May miss a miss, never a hit.
  virtual bool misses(const LocalFrame& frame, Key low, Key high) const = 0;

  /// Potential in 0…1 of the side³ corners from `first` (counted from the frame's cell), in
  /// lexicographic order.
  virtual void evaluate(const LocalFrame& frame, Key first, int side, float* potential) const = 0;
};

/// The potential of a primitive with these radii; only their ratios matter.
std::unique_ptr<Potential> makePotential(const ToolShape& shape);

}  // namespace bozzetto
