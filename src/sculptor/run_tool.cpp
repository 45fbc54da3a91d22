// tool and action: what the hand holds.
#include "sculptor/run.hpp"

namespace bozzetto {

template <int Side>
void run(const ToolOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  const FittedTool fitted = fitTool(operation.shape, bench.field().scale.spacing);
  if (!fitted.notice.empty()) telling.progress.note(fitted.notice);
  bench.hand.chosen = operation.shape;
}

template <int Side>
void run(const ActionOperation& operation, Workbench<Side>& bench, const Telling&) {
  requireValid(operation.action);
  if (operation.recall && !bench.history().tree().has(*operation.recall)) {
    throw Error("action: step " + std::to_string(*operation.recall) + ": not in the history");
  }
  bench.hand.action = operation.action;
  bench.hand.recall = operation.recall;
}

BOZZETTO_RUNS(ToolOperation);
BOZZETTO_RUNS(ActionOperation);

}  // namespace bozzetto
