// The potential of a tool, evaluated block by block (Ferley §3.2, §4.1): with actions that take
// any potential, N potentials and M actions need no N × M kernels.
#pragma once
#include <array>
#include <glm/mat3x3.hpp>
#include <memory>

#include "bozzetto/field/corner_block.hpp"
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

/// Where a freeform tool's corners lie for the grid, in 2⁻¹⁶ of its cells: corner cell + (i,j,k) is
/// at first + i·step[0] + j·step[1] + k·step[2]. Integers: exact, whatever the order.
struct FixedFrame {
  std::array<std::int32_t, 3> first{};
  std::array<std::array<std::int32_t, 3>, 3> step{};  ///< [grid axis][tool axis]
};

/// Tool space along the grid: corner cell + (i,j,k) has the local position
/// ((first + i·step[0]) + j·step[1]) + k·step[2], evaluated in float in this order by every
/// kernel. |local| ≤ 1 on each axis is the tool's local box. `cell` is the dab's own, nearest to
/// its position: nearest, not lower, so that mirrored dabs give mirrored bits.
struct LocalFrame {
  Key cell;
  std::array<float, 3> first;
  std::array<std::array<float, 3>, 3> step;  ///< [grid axis][tool axis]
  FixedFrame fixed{};                        ///< of freeform tools
};

LocalFrame localFrame(const DabPose& pose);

class Potential {
 public:
  virtual ~Potential() = default;

  /// The dab's frame, with what this potential needs in it.
  virtual LocalFrame frame(const DabPose& pose) const { return localFrame(pose); }

  /// How far beyond the radii it acts, along the tool's axes, in cells.
  virtual glm::dvec3 reach() const { return glm::dvec3(0); }

  /// True only when every corner of the box has potential 0; `low` and `high` count from the
  /// frame's cell. May miss a miss, never a hit.
  virtual bool misses(const LocalFrame& frame, Key low, Key high) const = 0;

  /// Potential in 0…1 of the side³ corners from `first` (counted from the frame's cell), in
  /// lexicographic order.
  virtual void evaluate(const LocalFrame& frame, Key first, int side, float* potential) const = 0;

  /// Whether it has colours of its own; then those of the same corners, where the potential is
  /// above 0.
  virtual bool coloured() const { return false; }
  virtual void evaluateColours(const LocalFrame&, Key, int, Attributes*) const {}

  /// How much of the tool itself is there, 0…1, where the potential is made from it (stamps).
  virtual void evaluateBody(const LocalFrame& frame, Key first, int side, float* body) const {
    evaluate(frame, first, side, body);
  }
  /// Both at once.
  virtual void evaluateWithBody(const LocalFrame& frame, Key first, int side, float* potential,
                                float* body) const {
    evaluate(frame, first, side, potential);
    evaluateBody(frame, first, side, body);
  }
  /// True only when nothing of the tool itself is in the box.
  virtual bool bodyMisses(const LocalFrame& frame, Key low, Key high) const {
    return misses(frame, low, high);
  }
};

/// The pose with radii that hold all of the potential.
inline DabPose influenceOf(const Potential& potential, DabPose pose) {
  pose.radii += potential.reach();
  return pose;
}

/// The potential of a tool with these radii, in cells; of a primitive only their ratios matter.
std::unique_ptr<Potential> makePotential(const ToolShape& shape);

}  // namespace bozzetto
