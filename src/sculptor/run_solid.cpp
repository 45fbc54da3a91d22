// solid, solid_move, bake, wrap, wrap_apply, solid_drop.
#include <fmt/format.h>

#include "sculptor/run_solid.hpp"
#include "sculptor/timer.hpp"

namespace bozzetto {

template <int Side>
void run(const SolidOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  NamedLattice block = makeBlock(operation.block);
  keepSolid(bench, newSolid(std::move(block)), telling.report);
}

template <int Side>
void run(const SolidMoveOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  Solid solid = solidOf(bench, "solid_move");
  const bool named = std::holds_alternative<Key>(operation.point);
  const Id point =
      named ? solid.pointNamed(std::get<Key>(operation.point)) : std::get<Id>(operation.point);
  if (point >= solid.control.points.size())
    throw Error(fmt::format("solid_move: found point {}, expected less than {}", point,
                            solid.control.points.size()));
  solid.control.points[point] += operation.by;
  keepSolid(bench, std::move(solid), telling.report);
}

template <int Side>
void run(const BakeOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  const Solid& solid = solidOf(bench, "bake");
  Edit<CornerBlock<Side>> edit(bench.tree());
  {
    const Timer timer(telling.report.msField);
    telling.report.dirty =
        bake<Side>(edit, bench.field().scale, solid.control, operation.options, telling.progress)
            .dirty;
  }
  bench.keep(edit, telling.report);
}

template <int Side>
void run(const WrapOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  const auto box = operation.box ? *operation.box : clayBox(bench.field());
  NamedLattice block = wrapBlock(box[0], box[1], operation.cells);
  Solid solid = newSolid(std::move(block));
  solid.wrapRest = solid.control.points;
  keepSolid(bench, std::move(solid), telling.report);
}

template <int Side>
void run(const WrapApplyOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  Solid solid = solidOf(bench, "wrap_apply");
  if (!solid.isWrap())
    throw Error("wrap_apply: found a solid of its own, expected a wrap ('wrap' makes it)");
  Lattice rest = solid.control;
  rest.points = solid.wrapRest;
  Edit<CornerBlock<Side>> edit(bench.tree());
  {
    const Timer timer(telling.report.msField);
    telling.report.dirty = applyWrap<Side>(edit, bench.field().scale, rest, solid.control.points,
                                           operation.options, telling.progress)
                               .dirty;
  }
  solid.wrapRest = solid.control.points;
  bench.setSolid(std::make_shared<const Solid>(std::move(solid)));
  bench.keep(edit, telling.report);
}

template <int Side>
void run(const SolidDropOperation&, Workbench<Side>& bench, const Telling& telling) {
  solidOf(bench, "solid_drop");
  keepSolid(bench, std::nullopt, telling.report);
}

BOZZETTO_RUNS(SolidOperation);
BOZZETTO_RUNS(SolidMoveOperation);
BOZZETTO_RUNS(BakeOperation);
BOZZETTO_RUNS(WrapOperation);
BOZZETTO_RUNS(WrapApplyOperation);
BOZZETTO_RUNS(SolidDropOperation);

}  // namespace bozzetto
