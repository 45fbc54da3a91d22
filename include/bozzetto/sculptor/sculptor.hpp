// The one door: whoever wants to change clay hands an operation to a Sculptor. The same operations
// give the same field, bit for bit, on any number of threads and with blocks of any side.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "bozzetto/base/progress.hpp"
#include "bozzetto/field/field.hpp"
#include "bozzetto/history/undo_stack.hpp"
#include "bozzetto/sculptor/operation.hpp"
#include "bozzetto/surface/surface.hpp"

namespace bozzetto {

/// What one operation did and cost. Counts are the paper's (Ferley §3.2), summed over dabs.
struct OperationReport {
  std::string op;
  double msField = 0, msSurface = 0, msHistory = 0;
  std::int64_t dabs = 0;
  std::int64_t visited = 0, computed = 0, dirty = 0;
  std::int64_t treated = 0;              ///< cubes re-examined; 0 without surface upkeep
  double massBefore = 0, massAfter = 0;  ///< world units, from exact sums
  double massDropped = 0;                ///< let go by smoothing thin support
  std::size_t changedBlocks = 0;
};

/// Whether the surface follows the field. `afterEachDab` is what a window shows and what the
/// paper counts; without it nothing is meshed.
enum class SurfaceUpkeep { none, afterEachDab };

template <int Side>
class BasicSculptor {
 public:
  using Block = CornerBlock<Side>;
  /// What a step of history knows beside its delta.
  struct StepNote {
    std::string label;
    FieldScale before, after;
  };
  using History = UndoStack<Block, StepNote>;

  explicit BasicSculptor(Field<Side> field = {}, SurfaceUpkeep upkeep = SurfaceUpkeep::none);

  /// Does one operation. Throws Error and changes nothing when it cannot be done; notices (a
  /// widened tool, what a resample will need) go to `progress` first.
  OperationReport apply(const Operation& operation, Progress& progress = Progress::none());

  const Field<Side>& field() const { return field_; }
  const History& history() const { return history_; }
  /// The tool of the next stroke; as long as nobody chose one, a ball of 8 cells.
  ToolShape tool() const;
  const ActionOptions& action() const { return action_; }
  /// The surface as of the last operation. Needs upkeep.
  const Surface<Side>& surface() const { return surface_; }

 private:
  void run(const SceneOperation& operation, OperationReport& report, Progress& progress);
  void run(const FillOperation& operation, OperationReport& report, Progress& progress);
  void run(const ToolOperation& operation, OperationReport& report, Progress& progress);
  void run(const ActionOperation& operation, OperationReport& report, Progress& progress);
  void run(const StrokeOperation& operation, OperationReport& report, Progress& progress);
  void run(const UndoOperation& operation, OperationReport& report, Progress& progress);
  void run(const RedoOperation& operation, OperationReport& report, Progress& progress);
  void run(const ResampleOperation& operation, OperationReport& report, Progress& progress);

  void keep(Edit<Block>& edit, FieldScale scale, OperationReport& report);
  void showAll();
  void refresh(std::span<const KeyRun> changed, OperationReport& report);
  using Move = const typename History::Step& (History::*)(KeyTree<Block>&);
  void revisit(Move move, Direction direction, OperationReport& report);
  void account(const Delta<Block>& delta, Direction direction);
  double mass() const;

  Field<Side> field_;
  Surface<Side> surface_;
  typename Field<Side>::Tree shown_;  // what the surface shows: shares blocks with the field
  History history_;
  SurfaceUpkeep upkeep_;
  std::optional<ToolShape> tool_;
  ActionOptions action_;
  MassSum massUnits_ = 0;
};

extern template class BasicSculptor<1>;
extern template class BasicSculptor<8>;

using Sculptor = BasicSculptor<8>;

}  // namespace bozzetto
