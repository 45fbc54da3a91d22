#include "bozzetto/sculptor/workbench.hpp"

#include "sculptor/timer.hpp"

namespace bozzetto {

ToolShape Hand::tool(double spacing) const {
  ToolShape ball;
  ball.radii *= spacing;
  return chosen.value_or(ball);
}

template <int Side>
Workbench<Side>::Workbench(Field<Side> field, SurfaceUpkeep upkeep)
    : field_(std::move(field)), upkeep_(upkeep), massUnits_(massUnits(field_)) {
  showAll();
}

template <int Side>
double Workbench<Side>::mass() const {
  const double spacing = field_.scale.spacing;
  return static_cast<double>(massUnits_) * kMassUnit * (spacing * spacing * spacing);
}

template <int Side>
void Workbench<Side>::keep(Edit<Block>& edit, const FieldScale& scale, OperationReport& report) {
  const FieldScale before = field_.scale;
  Delta<Block> delta;
  std::vector<KeyRun> changed;
  {
    const Timer timer(report.msHistory);
    delta = edit.commit();
    report.changedBlocks = delta.changes.size();
    account(delta, Direction::forward);
    changed = delta.keys();
    history_.push(std::move(delta), {report.op, before, scale, solid_, nextSolid_});
    solid_ = nextSolid_;
  }
  field_.scale = scale;
  refresh(changed, report);
}

template <int Side>
void Workbench<Side>::showAll() {
  if (upkeep_ == SurfaceUpkeep::none) return;
  surface_.rebuild(field_);
  shown_ = field_.tree;
}

template <int Side>
void Workbench<Side>::refresh(std::span<const KeyRun> changed, OperationReport& report) {
  if (upkeep_ == SurfaceUpkeep::none) return;
  const Delta<Block> delta = difference(shown_, field_.tree, changed);
  {
    const Timer timer(report.msSurface);
    surface_.refresh(field_, delta);
  }
  report.treated += treatedCubes(delta);
  delta.apply(shown_, Direction::forward);
}

template <int Side>
bool Workbench<Side>::revisit(Direction direction, OperationReport& report) {
  const bool forward = direction == Direction::forward;
  if (forward ? !history_.canRedo() : !history_.canUndo()) return false;
  const typename History::Step* step = nullptr;
  {
    const Timer timer(report.msHistory);
    step = forward ? &history_.redo(field_.tree) : &history_.undo(field_.tree);
  }
  field_.scale = forward ? step->note.after : step->note.before;
  solid_ = nextSolid_ = forward ? step->note.solidAfter : step->note.solidBefore;
  account(step->delta, direction);
  report.changedBlocks += step->delta.changes.size();
  refresh(step->delta.keys(), report);
  return true;
}

// Keeps the ledger: exact, whatever the order of changes.
template <int Side>
void Workbench<Side>::account(const Delta<Block>& delta, Direction direction) {
  MassSum gained = 0;
  for (const auto& change : delta.changes) {
    const MassSum after = change.after ? change.after->mass : 0;
    const MassSum before = change.before ? change.before->mass : 0;
    gained += (after - before) * change.length;
  }
  massUnits_ += direction == Direction::forward ? gained : -gained;
}

template class Workbench<1>;
template class Workbench<8>;

}  // namespace bozzetto
