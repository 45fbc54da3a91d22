// combine, cut and text: volumes with volumes.
#include "bozzetto/base/text.hpp"
#include "bozzetto/io/relief.hpp"
#include "sculptor/dab_counts.hpp"
#include "sculptor/run.hpp"
#include "sculptor/timer.hpp"

namespace bozzetto {
namespace {

template <int Side>
void combineWith(std::shared_ptr<const Sculpture> sculpture, const CombineOperation& operation,
                 Workbench<Side>& bench, const Telling& telling) {
  const FieldScale& scale = bench.field().scale;
  Edit<CornerBlock<Side>> edit(bench.tree());
  {
    const Timer timer(telling.report.msField);
    addCounts(combine<Side>(edit, scale, std::move(sculpture), operation.how, operation.pose),
              scale.spacing, telling.report);
  }
  bench.keep(edit, telling.report);
}

ShelfTool atHand(Clay clay) {
  ShelfTool tool;
  tool.clay = std::move(clay);
  return tool;
}

}  // namespace

template <int Side>
void run(const CombineOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  combineWith(bench.tools.sculpture(operation.with, telling.progress), operation, bench, telling);
}

template <int Side>
void run(const CutOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  ToolSource source;
  source.region = operation.region;
  const auto part = sculptureOf(atHand(withSide<8>(bench.field())), source);
  Edit<CornerBlock<Side>> edit(bench.tree());
  {
    const Timer timer(telling.report.msField);
    const FieldScale& scale = bench.field().scale;
    const auto& lasso = operation.region.lasso;
    addCounts(lasso ? clear<Side>(edit, scale, part->bounds(), *lasso)
                    : clear<Side>(edit, part->bounds()),
              scale.spacing, telling.report);
  }
  bench.keep(edit, telling.report);
  ToolShape tool;
  tool.shape = Shape::freeform;
  tool.sculpture = part;
  bench.hand.chosen = tool;
  bench.hand.action.kind = ActionKind::add;
  bench.hand.action.strength = 1;
  bench.hand.action.ownColours = true;
}

template <int Side>
void run(const TextOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  TextOptions options;
  if (!operation.font.empty()) options.font = bench.tools.folder / operation.font;
  const double spacing = bench.field().scale.spacing;
  if (!(operation.size > 0) || !(operation.depth > 0))
    throw Error("text: size " + numberText(operation.size) + " and depth " +
                numberText(operation.depth) + " found, numbers above 0 expected");
  const GreyImage image = drawText(operation.text, options);
  const double width = image.width * operation.size / options.pixels;
  const Clay letters = standingText(image, {width, operation.depth, spacing, operation.colour});
  CombineOperation as;
  as.pose = operation.pose;
  combineWith(std::make_shared<const Sculpture>(letters), as, bench, telling);
}

BOZZETTO_RUNS(CombineOperation);
BOZZETTO_RUNS(CutOperation);
BOZZETTO_RUNS(TextOperation);

}  // namespace bozzetto
