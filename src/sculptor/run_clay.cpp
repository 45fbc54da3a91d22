// clay, relax, support and its like, hold, release.
#include <algorithm>
#include <cmath>

#include "bozzetto/clay/hold.hpp"
#include "bozzetto/tool/relative.hpp"
#include "sculptor/run.hpp"
#include "sculptor/timer.hpp"

namespace bozzetto {

// Some layer moves matter when a tool comes; tension only tidies up.
bool givesWay(const clay::Settings& settings) {
  return std::ranges::any_of(
      settings.layers, [](clay::LayerKind layer) { return layer != clay::LayerKind::tension; });
}

// What displacement leads together only conservation parts again.
bool crams(const clay::Settings& settings) {
  const auto runs = [&](clay::LayerKind layer) {
    return std::ranges::find(settings.layers, layer) != settings.layers.end();
  };
  return runs(clay::LayerKind::displacement) && !runs(clay::LayerKind::conservation);
}

template <int Side>
void run(const ClayOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  requireValid(operation.settings);
  if (!givesWay(operation.settings))
    telling.progress.note(
        "clay: without layers that move it, strokes that push or grip do nothing");
  if (crams(operation.settings))
    telling.progress.note("clay: it is crammed where it is pushed: no layer conserves its volume");
  bench.clay.settings = operation.settings;
}

template <int Side>
void run(const RelaxOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  Edit<CornerBlock<Side>> edit(bench.tree());
  {
    const Timer timer(telling.report.msField);
    clay::relax<Side>(edit, bench.field().scale, bench.clay, operation.steps);
  }
  bench.keep(edit, telling.report);
}

// With its sculpture, whose distances are made now: no stroke waits for them.
template <int Side>
clay::Support supportFrom(const SupportOperation& operation, Workbench<Side>& bench,
                          const Telling& telling) {
  clay::Support support = operation.support;
  if (support.shape == Shape::freeform) {
    if (operation.source)
      support.sculpture = sculptureFor(*operation.source, bench, telling.progress);
    if (support.sculpture && operation.scale)
      support.radii = freeformRadii(*support.sculpture, *operation.scale);
  }
  clay::requireValid(support);
  clay::requireInWorkspace(support, bench.field().scale.spacing);
  const std::string notice = clay::noticeOf(support, bench.field().scale.spacing);
  if (!notice.empty()) telling.progress.note(notice);
  if (support.sculpture) support.sculpture->distance();
  return support;
}

// A step of history that leaves the clay as it is.
template <int Side>
void keepSupports(Workbench<Side>& bench, const Telling& telling) {
  Edit<CornerBlock<Side>> edit(bench.tree());
  bench.keep(edit, telling.report);
}

template <int Side>
void run(const SupportOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  bench.clay.supports.push_back(supportFrom(operation, bench, telling));
  keepSupports(bench, telling);
}

template <int Side>
clay::Support& supportOf(Workbench<Side>& bench, int number, const char* op) {
  auto& supports = bench.clay.supports;
  if (number >= 0 && std::size_t(number) < supports.size()) return supports[std::size_t(number)];
  const std::string found = std::string(op) + ": support " + std::to_string(number) + " found, ";
  if (supports.empty()) throw Error(found + "but there are no supports");
  throw Error(found + "0 to " + std::to_string(supports.size() - 1) + " expected");
}

template <int Side>
void run(const SupportMoveOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  clay::Support& support = supportOf(bench, operation.number, "support_move");
  SupportOperation to = operation.to;
  if (!to.source) to.support.sculpture = support.sculpture;
  support = supportFrom(to, bench, telling);
  keepSupports(bench, telling);
}

template <int Side>
void run(const SupportDropOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  const clay::Support* gone = &supportOf(bench, operation.number, "support_drop");
  auto& supports = bench.clay.supports;
  supports.erase(supports.begin() + (gone - supports.data()));
  keepSupports(bench, telling);
}

// The corners of a box in world units, both ends.
KeyBox cornersWithin(const HoldOperation& operation, double spacing) {
  KeyBox box;
  const Key low = cellOf(operation.low, spacing, "hold min");
  const Key high = cellOf(operation.high, spacing, "hold max");
  const glm::dvec3 below = relativeTo(low, operation.low, spacing);
  const glm::dvec3 above = relativeTo(high, operation.high, spacing);
  for (const Axis axis : kAxes) {
    box.low[axis] = low[axis] + static_cast<std::int32_t>(std::ceil(below[index(axis)]));
    box.high[axis] = high[axis] + static_cast<std::int32_t>(std::floor(above[index(axis)]));
  }
  return box;
}

template <int Side>
void run(const HoldOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  const KeyBox box = cornersWithin(operation, bench.field().scale.spacing);
  Edit<CornerBlock<Side>> edit(bench.tree());
  {
    const Timer timer(telling.report.msField);
    clay::holdClay<Side>(edit, box, operation.amount);
  }
  bench.keep(edit, telling.report);
}

template <int Side>
void run(const ReleaseOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  if (operation.supports) bench.clay.supports.clear();
  if (operation.stiffness) bench.clay.stiffness = {};
  Edit<CornerBlock<Side>> edit(bench.tree());
  if (operation.hold) {
    const Timer timer(telling.report.msField);
    clay::releaseClay<Side>(edit);
  }
  bench.keep(edit, telling.report);
}

BOZZETTO_RUNS(ClayOperation);
BOZZETTO_RUNS(RelaxOperation);
BOZZETTO_RUNS(SupportOperation);
BOZZETTO_RUNS(SupportMoveOperation);
BOZZETTO_RUNS(SupportDropOperation);
BOZZETTO_RUNS(HoldOperation);
BOZZETTO_RUNS(ReleaseOperation);

}  // namespace bozzetto
