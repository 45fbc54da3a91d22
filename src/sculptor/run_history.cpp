// undo, redo, goto.
#include "sculptor/run.hpp"

namespace bozzetto {
namespace {

template <int Side>
void goTo(StepNumber state, Workbench<Side>& bench, const Telling& telling) {
  const std::string lost = bench.goTo(state, telling.report);
  if (!lost.empty()) telling.progress.note("the history ends here: " + lost);
}

}  // namespace

template <int Side>
void run(const UndoOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  const auto count = static_cast<std::size_t>(operation.count);
  goTo(bench.history().tree().undoTarget(count), bench, telling);
}

template <int Side>
void run(const RedoOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  const auto count = static_cast<std::size_t>(operation.count);
  goTo(bench.history().tree().redoTarget(count), bench, telling);
}

template <int Side>
void run(const GoToOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  goTo(operation.step, bench, telling);
}

BOZZETTO_RUNS(UndoOperation);
BOZZETTO_RUNS(RedoOperation);
BOZZETTO_RUNS(GoToOperation);

}  // namespace bozzetto
