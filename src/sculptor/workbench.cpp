#include "bozzetto/sculptor/workbench.hpp"

#include <algorithm>
#include <utility>

#include "sculptor/timer.hpp"

namespace bozzetto {
namespace {

// Sorts what was noted dab by dab and leaves each once.
void sortOnce(std::vector<Key>& noted) {
  std::ranges::sort(noted);
  const auto twins = std::ranges::unique(noted);
  noted.erase(twins.begin(), twins.end());
}

// Where undo changed a long run and a dab a block of it, the longer one counts.
std::vector<KeyRun> withoutOverlaps(std::vector<KeyRun> runs) {
  std::vector<KeyRun> clear;
  for (const KeyRun& run : runs) {
    if (!clear.empty()) {
      KeyRun& last = clear.back();
      const bool sameRow = last.key.i == run.key.i && last.key.j == run.key.j;
      const std::int32_t end = last.key.k + last.length;
      if (sameRow && run.key.k < end) {
        last.length = std::max(end, run.key.k + run.length) - last.key.k;
        continue;
      }
    }
    clear.push_back(run);
  }
  return clear;
}

}  // namespace

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
  {
    const Timer timer(report.msHistory);
    delta = edit.commit();
    report.changedBlocks = delta.changes.size();
    account(delta, Direction::forward);
  }
  field_.scale = scale;
  if (!std::exchange(followed_, false)) show(delta, report);
  const Timer timer(report.msHistory);
  history_.push(std::move(delta), {report.op, before, scale, solid_, nextSolid_});
  solid_ = nextSolid_;
}

template <int Side>
void Workbench<Side>::showAll() {
  followed_ = false;
  if (upkeep_ == SurfaceUpkeep::none) return;
  surface_.rebuild(field_);
  changes_ = {.all = true, .blocks = {}, .patches = {}};
}

template <int Side>
SurfaceChanges Workbench<Side>::takeChanges() {
  SurfaceChanges taken = std::exchange(changes_, {});
  std::ranges::sort(taken.blocks, {}, &KeyRun::key);
  taken.blocks = withoutOverlaps(std::move(taken.blocks));
  sortOnce(taken.patches);
  return taken;
}

template <int Side>
void Workbench<Side>::refresh(std::span<const ChangedRun> changed, OperationReport& report) {
  if (upkeep_ == SurfaceUpkeep::none) return;
  followed_ = true;
  {
    const Timer timer(report.msSurface);
    note(changed, surface_.refresh(field_, changed));
  }
  report.treated += treatedCubes<Side>(changed);
}

// Brings the surface over a whole delta, in either direction.
template <int Side>
void Workbench<Side>::show(const Delta<Block>& delta, OperationReport& report) {
  if (upkeep_ == SurfaceUpkeep::none) return;
  {
    const Timer timer(report.msSurface);
    const std::vector<KeyRun> keys = delta.keys();
    note(std::span<const KeyRun>(keys), surface_.refresh(field_, delta));
  }
  report.treated += treatedCubes<Side>(changedRuns<Side>(delta));
}

// Until somebody takes the changes, all of it may be new: then there is nothing to note.
template <int Side>
template <class Run>
void Workbench<Side>::note(std::span<const Run> changed, const RefreshReport& report) {
  if (changes_.all) return;
  changes_.blocks.insert(changes_.blocks.end(), changed.begin(), changed.end());
  changes_.patches.insert(changes_.patches.end(), report.changed.begin(), report.changed.end());
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
  show(step->delta, report);
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
