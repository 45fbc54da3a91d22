// tool and action: what the hand holds.
#include "sculptor/run.hpp"

namespace bozzetto {
namespace {

// Who is to push clay knows the ways out of it before the first dab.
void prepare(const Hand& hand) {
  if (hand.chosen && hand.chosen->sculpture && movesClay(hand.action.kind))
    hand.chosen->sculpture->distance();
}

}  // namespace

template <int Side>
std::shared_ptr<const Sculpture> sculptureFor(const ToolSource& source, Workbench<Side>& bench,
                                              Progress& progress) {
  if (!source.isAtHand()) return bench.tools.sculpture(source, progress);
  ShelfTool tool;
  tool.clay = withSide<8>(bench.field());
  return sculptureOf(tool, source);
}

template std::shared_ptr<const Sculpture> sculptureFor(const ToolSource&, Workbench<1>&, Progress&);
template std::shared_ptr<const Sculpture> sculptureFor(const ToolSource&, Workbench<8>&, Progress&);

template <int Side>
void run(const ToolOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  ToolShape shape = operation.shape;
  if (operation.source) shape.sculpture = sculptureFor(*operation.source, bench, telling.progress);
  const FittedTool fitted = fitTool(shape, bench.field().scale.spacing);
  if (!fitted.notice.empty()) telling.progress.note(fitted.notice);
  bench.hand.chosen = shape;
  prepare(bench.hand);
}

template <int Side>
void run(const ActionOperation& operation, Workbench<Side>& bench, const Telling&) {
  requireValid(operation.action);
  if (operation.recall && !bench.history().tree().has(*operation.recall)) {
    throw Error("action: step " + std::to_string(*operation.recall) + ": not in the history");
  }
  bench.hand.action = operation.action;
  bench.hand.recall = operation.recall;
  prepare(bench.hand);
}

BOZZETTO_RUNS(ToolOperation);
BOZZETTO_RUNS(ActionOperation);

}  // namespace bozzetto
