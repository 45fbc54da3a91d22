// Strokes that push and grip: the tool moves in steps of half a cell, and after each the clay has
// given way. One edit a stroke, like those of brushes.
#pragma once
#include <memory>

#include "bozzetto/clay/settings.hpp"
#include "bozzetto/clay/stiffness.hpp"
#include "bozzetto/tool/sculpture.hpp"
#include "bozzetto/tool/stroke.hpp"

namespace bozzetto::clay {

/// A tool that stands still: a table, a wall, a finger.
struct Support {
  Shape shape = Shape::box;
  glm::dvec3 centre{0};             ///< world units
  glm::dvec3 radii{8, 8, 8};        ///< world units; its surface; of sculptures: freeformRadii
  glm::dquat rotation{1, 0, 0, 0};  ///< w, x, y, z
  std::shared_ptr<const Sculpture> sculpture{};  ///< of freeform ones; `centre` is its box's

  /// Sculptures by their clay. O(1) for the same one, O(blocks) for copies.
  friend bool operator==(const Support& a, const Support& b);
};

/// Supports under two cells of `spacing` stop no clay: strokes meet them widened to two, but for
/// sculptures. One line that says so; empty for others.
std::string noticeOf(const Support& support, double spacing);

/// What a stroke meets beside the clay.
struct Setup {
  Settings settings;
  std::vector<Support> supports;
  Stiffness stiffness{};  ///< painted; it goes where the clay goes
};

/// Throws Error for radii and rotations that are none, and freeform ones without a sculpture.
void requireValid(const Support& support);
/// Throws Error for one that is not wholly in the workspace.
void requireInWorkspace(const Support& support, double spacing);

/// What the tool does: its role, and 0 … 1 how strongly a swelling one swells, or as what share of
/// its way a gripping one leads what it holds.
struct Doing {
  Role role = Role::push;
  double strength = 0.5;
};

/// A stroke step by step, so that a window can show each. The caller owns the edit and commits it.
/// The tool's surface lies at its radii, × the pressure where that drives size (0: no touch). Steps
/// work on a copy of the clay within reach: all of the connected piece; of fluid clay what is near.
template <int Side>
class ClayStroke {
 public:
  /// Checks everything first. Throws Error for bad points, rotations, tools, settings, for more
  /// than 10 million steps and for ways beyond the workspace.
  ClayStroke(Edit<CornerBlock<Side>>& edit, const FieldScale& scale, const ToolShape& tool,
             const Doing& doing, const Stroke& stroke, const Setup& setup);
  ~ClayStroke();

  /// Goes on through these points, without rotations, while the stroke is drawn: the steps are
  /// those of a stroke that had them from the start. Throws Error and leaves the stroke as it was.
  void extend(std::span<const StrokePoint> points);

  std::int64_t stepCount() const;
  std::int64_t sureSteps() const;     ///< those that `extend` cannot move
  const std::string& notice() const;  ///< of tool, supports; once finished, of the clay; or empty

  /// Makes the n-th step; they are made in order. O(clay within reach).
  StepReport step(std::int64_t n);

  /// After the last step: eats the last crumbs.
  void finish();

  /// Writes what has changed since the last call to the edit; returns the keys of changed blocks
  /// in order. Call it when the clay is to be seen, and at the end.
  std::vector<KeyRun> store();

  /// Painted stiffness as of the last store(): what was painted has moved with the clay.
  Stiffness stiffness();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

extern template class ClayStroke<1>;
extern template class ClayStroke<8>;

/// Runs the layers `steps` times without a tool over all the clay, less often where nothing changes
/// any more; returns the keys of changed blocks, and takes the setup's painted stiffness along.
/// Throws Error for more clay than the working set can hold, and more than 10 million steps.
template <int Side>
std::vector<KeyRun> relax(Edit<CornerBlock<Side>>& edit, const FieldScale& scale, Setup& setup,
                          int steps);

extern template std::vector<KeyRun> relax(Edit<CornerBlock<1>>&, const FieldScale&, Setup&, int);
extern template std::vector<KeyRun> relax(Edit<CornerBlock<8>>&, const FieldScale&, Setup&, int);

}  // namespace bozzetto::clay
