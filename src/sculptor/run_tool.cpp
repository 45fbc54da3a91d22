// tool and action: what the hand holds.
#include "sculptor/run.hpp"

namespace bozzetto {
namespace {

template <int Side>
ShelfTool atHand(const Field<Side>& field) {
  ShelfTool tool;
  tool.clay = withSide<8>(field);
  return tool;
}

}  // namespace

template <int Side>
void run(const ToolOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  ToolShape shape = operation.shape;
  if (operation.source) {
    const ToolSource& source = *operation.source;
    shape.sculpture = source.isAtHand() ? sculptureOf(atHand(bench.field()), source)
                                        : bench.tools.sculpture(source, telling.progress);
  }
  const FittedTool fitted = fitTool(shape, bench.field().scale.spacing);
  if (!fitted.notice.empty()) telling.progress.note(fitted.notice);
  bench.hand.chosen = shape;
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
