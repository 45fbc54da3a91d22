// stroke: a live one that gets all its points at once.
#include "bozzetto/clay/idle.hpp"
#include "bozzetto/sculptor/live_stroke.hpp"
#include "sculptor/dab_maker.hpp"
#include "sculptor/run.hpp"

namespace bozzetto {

template <int Side>
void run(const StrokeOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  LiveStroke<Side> stroke(bench, operation.stroke);
  const ActionKind kind = bench.hand.action.kind;
  if (movesClay(kind) && !bench.hand.recall) {
    const std::string idle = clay::idleIn(operation.stroke, clayRoleOf(kind), bench.clay.settings);
    if (!idle.empty()) telling.progress.note(idle);
  }
  const std::string notice = stroke.notice();
  if (!notice.empty()) telling.progress.note(notice);
  const auto count = static_cast<double>(stroke.plannedDabs());
  for (double n = 0; stroke.dab(); ++n) telling.progress.step("stroke", n / count);
  telling.report = stroke.finish();
}

BOZZETTO_RUNS(StrokeOperation);

}  // namespace bozzetto
