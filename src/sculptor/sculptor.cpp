#include "bozzetto/sculptor/sculptor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "bozzetto/field/resample.hpp"

namespace bozzetto {
namespace {

// Adds the milliseconds of its life to a number.
class Timer {
 public:
  explicit Timer(double& total) : total_(&total) {}
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;
  ~Timer() {
    const auto passed = std::chrono::steady_clock::now() - start_;
    *total_ += std::chrono::duration<double, std::milli>(passed).count();
  }

 private:
  double* total_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

void addCounts(const DabReport& dab, OperationReport& report) {
  report.visited += dab.visited;
  report.computed += dab.computed;
  report.dirty += dab.dirty;
  report.massDropped += static_cast<double>(dab.dropped) * kMassUnit;
}

double cellVolume(const FieldScale& scale) { return scale.spacing * scale.spacing * scale.spacing; }

// A dab and its mirror images list their blocks one after the other.
std::vector<KeyRun> sortedOnce(std::vector<KeyRun> runs) {
  std::ranges::sort(runs, {}, &KeyRun::key);
  const auto sameKey = [](const KeyRun& a, const KeyRun& b) { return a.key == b.key; };
  runs.erase(std::unique(runs.begin(), runs.end(), sameKey), runs.end());
  return runs;
}

// Puts other clay in the place of all there is.
template <int Side>
void replaceAll(Edit<CornerBlock<Side>>& edit, const KeyTree<CornerBlock<Side>>& old,
                const KeyTree<CornerBlock<Side>>& clay) {
  for (const auto& [key, run] : old) edit.replace({key, run.length}, nullptr);
  for (const auto& [key, run] : clay) edit.replace({key, run.length}, run.block);
}

}  // namespace

template <int Side>
BasicSculptor<Side>::BasicSculptor(Field<Side> field, SurfaceUpkeep upkeep)
    : field_(std::move(field)), upkeep_(upkeep), massUnits_(massUnits(field_)) {
  showAll();
}

template <int Side>
OperationReport BasicSculptor<Side>::apply(const Operation& operation, Progress& progress) {
  OperationReport report;
  report.op = nameOf(operation);
  report.massBefore = mass();
  std::visit([&](const auto& each) { run(each, report, progress); }, operation);
  report.massDropped *= cellVolume(field_.scale);
  report.massAfter = mass();
  return report;
}

template <int Side>
ToolShape BasicSculptor<Side>::tool() const {
  ToolShape ball;
  ball.radii *= field_.scale.spacing;
  return tool_.value_or(ball);
}

template <int Side>
double BasicSculptor<Side>::mass() const {
  return static_cast<double>(massUnits_) * kMassUnit * cellVolume(field_.scale);
}

template <int Side>
void BasicSculptor<Side>::run(const SceneOperation& operation, OperationReport&, Progress&) {
  FieldScale scale = field_.scale;
  if (operation.spacing) scale.spacing = *operation.spacing;
  if (operation.iso) scale.iso = static_cast<float>(*operation.iso);
  const bool begun = !field_.tree.empty() || !history_.steps().empty();
  if (begun && !(scale == field_.scale)) {
    throw Error(fmt::format(
        "scene: the clay has spacing {} and iso {}; spacing {} and iso {} need an empty document "
        "(use resample)",
        field_.scale.spacing, field_.scale.iso, scale.spacing, scale.iso));
  }
  field_.scale = scale;
}

template <int Side>
void BasicSculptor<Side>::run(const FillOperation& operation, OperationReport& report,
                              Progress& progress) {
  Edit<Block> edit(field_.tree);
  {
    const Timer timer(report.msField);
    addCounts(fill<Side>(edit, field_.scale, operation.primitive, progress), report);
  }
  keep(edit, field_.scale, report);
}

template <int Side>
void BasicSculptor<Side>::run(const ToolOperation& operation, OperationReport&,
                              Progress& progress) {
  const FittedTool fitted = fitTool(operation.shape, field_.scale.spacing);
  if (!fitted.notice.empty()) progress.note(fitted.notice);
  tool_ = operation.shape;  // as asked for: a finer grid may take it as it is
}

template <int Side>
void BasicSculptor<Side>::run(const ActionOperation& operation, OperationReport&, Progress&) {
  requireValid(operation.action);
  action_ = operation.action;
}

template <int Side>
void BasicSculptor<Side>::run(const StrokeOperation& operation, OperationReport& report,
                              Progress& progress) {
  Edit<Block> edit(field_.tree);
  StrokeRunner<Side> runner(edit, field_.scale, tool(), action_, operation.stroke);
  report.dabs = runner.dabCount();
  try {
    for (std::int64_t n = 0; n < report.dabs; ++n) {
      progress.step("stroke", static_cast<double>(n) / static_cast<double>(report.dabs));
      DabReport dab;
      {
        const Timer timer(report.msField);
        dab = runner.dab(n);
      }
      addCounts(dab, report);
      refresh(sortedOnce(std::move(dab.changed)), report);
    }
  } catch (...) {
    edit.rollback();
    showAll();
    throw;
  }
  keep(edit, field_.scale, report);
}

template <int Side>
void BasicSculptor<Side>::run(const UndoOperation& operation, OperationReport& report, Progress&) {
  for (int n = 0; n < operation.count && history_.canUndo(); ++n) {
    revisit(&History::undo, Direction::backward, report);
  }
}

template <int Side>
void BasicSculptor<Side>::run(const RedoOperation& operation, OperationReport& report, Progress&) {
  for (int n = 0; n < operation.count && history_.canRedo(); ++n) {
    revisit(&History::redo, Direction::forward, report);
  }
}

template <int Side>
void BasicSculptor<Side>::run(const ResampleOperation& operation, OperationReport& report,
                              Progress& progress) {
  const auto prediction = predictResample(withSide<8>(field_), operation.spacing);
  progress.note(fmt::format("resampling to spacing {}: about {} corners, {} MB", operation.spacing,
                            prediction.corners, prediction.bytes / 1'000'000));
  Edit<Block> edit(field_.tree);
  FieldScale scale;
  {
    const Timer timer(report.msField);
    const Clay clay = resample(withSide<8>(field_), operation.spacing, {}, progress);
    replaceAll<Side>(edit, Field<Side>(field_).tree, withSide<Side>(clay).tree);
    scale = clay.scale;
  }
  keep(edit, scale, report);
}

// Ends the edit: one step of history, whatever it changed.
template <int Side>
void BasicSculptor<Side>::keep(Edit<Block>& edit, FieldScale scale, OperationReport& report) {
  const FieldScale before = field_.scale;
  Delta<Block> delta;
  std::vector<KeyRun> changed;
  {
    const Timer timer(report.msHistory);
    delta = edit.commit();
    report.changedBlocks = delta.changes.size();
    account(delta, Direction::forward);
    changed = delta.keys();
    history_.push(std::move(delta), {report.op, before, scale});
  }
  field_.scale = scale;
  refresh(changed, report);
}

template <int Side>
void BasicSculptor<Side>::showAll() {
  if (upkeep_ == SurfaceUpkeep::none) return;
  surface_.rebuild(field_);
  shown_ = field_.tree;
}

// Brings the surface from what it showed to what the field is now, inside these runs.
template <int Side>
void BasicSculptor<Side>::refresh(std::span<const KeyRun> changed, OperationReport& report) {
  if (upkeep_ == SurfaceUpkeep::none) return;
  const Delta<Block> delta = difference(shown_, field_.tree, changed);
  {
    const Timer timer(report.msSurface);
    surface_.refresh(field_, delta);
  }
  report.treated += treatedCubes(delta);
  delta.apply(shown_, Direction::forward);
}

// One step back or forth.
template <int Side>
void BasicSculptor<Side>::revisit(Move move, Direction direction, OperationReport& report) {
  const typename History::Step* step = nullptr;
  {
    const Timer timer(report.msHistory);
    step = &(history_.*move)(field_.tree);
  }
  field_.scale = direction == Direction::forward ? step->note.after : step->note.before;
  account(step->delta, direction);
  report.changedBlocks += step->delta.changes.size();
  refresh(step->delta.keys(), report);
}

// Keeps the ledger: exact, whatever the order of changes.
template <int Side>
void BasicSculptor<Side>::account(const Delta<Block>& delta, Direction direction) {
  MassSum gained = 0;
  for (const auto& change : delta.changes) {
    const MassSum after = change.after ? change.after->mass : 0;
    const MassSum before = change.before ? change.before->mass : 0;
    gained += (after - before) * change.length;
  }
  massUnits_ += direction == Direction::forward ? gained : -gained;
}

template class BasicSculptor<1>;
template class BasicSculptor<8>;

}  // namespace bozzetto
