// scene, fill, import, resample.
#include <fmt/format.h>

#include "bozzetto/field/resample.hpp"
#include "bozzetto/io/mesh_file.hpp"
#include "bozzetto/io/voxelise.hpp"
#include "sculptor/dab_counts.hpp"
#include "sculptor/run.hpp"
#include "sculptor/timer.hpp"

namespace bozzetto {
namespace {

template <int Side>
bool begun(const Workbench<Side>& bench) {
  return !bench.field().tree.empty() || bench.history().tree().size() > 0;
}

// Puts other clay in the place of all there is.
template <int Side>
void replaceAll(Edit<CornerBlock<Side>>& edit, const KeyTree<CornerBlock<Side>>& old,
                const KeyTree<CornerBlock<Side>>& clay) {
  for (const auto& [key, run] : old) edit.replace({key, run.length}, nullptr);
  for (const auto& [key, run] : clay) edit.replace({key, run.length}, run.block);
}

}  // namespace

template <int Side>
void run(const SceneOperation& operation, Workbench<Side>& bench, const Telling&) {
  FieldScale scale = bench.field().scale;
  if (operation.spacing) scale.spacing = *operation.spacing;
  if (operation.iso) scale.iso = static_cast<float>(*operation.iso);
  if (begun(bench) && !(scale == bench.field().scale)) {
    throw Error(fmt::format(
        "scene: the clay has spacing {} and iso {}; spacing {} and iso {} need an empty document "
        "(use resample)",
        bench.field().scale.spacing, bench.field().scale.iso, scale.spacing, scale.iso));
  }
  bench.setScale(scale);
}

template <int Side>
void run(const FillOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  const FieldScale& scale = bench.field().scale;
  Edit<CornerBlock<Side>> edit(bench.tree());
  {
    const Timer timer(telling.report.msField);
    addCounts(fill<Side>(edit, scale, operation.primitive, telling.progress), scale.spacing,
              telling.report);
  }
  bench.keep(edit, telling.report);
}

template <int Side>
void run(const ImportOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  if (begun(bench)) throw Error("import: an empty document expected (use combine)");
  ImportOptions options;
  options.cells = operation.cells;
  options.colour = operation.colour;
  Clay clay{{}, bench.field().scale};
  Edit<CornerBlock<Side>> edit(bench.tree());
  {
    const Timer timer(telling.report.msField);
    const auto mesh = readMesh(bench.tools.folder / operation.from, telling.progress);
    options.spacing = operation.spacing.value_or(importSpacing(mesh, options));
    clay.scale.spacing = options.spacing;
    Edit<CornerBlock<8>> imported(clay.tree);
    const ImportReport report = voxelise(mesh, options, imported, telling.progress);
    imported.commit();
    if (report.openEdges > 0) {
      telling.progress.note(fmt::format("{} open edges were closed", report.openEdges));
    }
    replaceAll<Side>(edit, {}, withSide<Side>(clay).tree);
  }
  bench.keep(edit, clay.scale, telling.report);
}

template <int Side>
void run(const ResampleOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  const Clay before = withSide<8>(bench.field());
  const auto prediction = predictResample(before, operation.spacing);
  telling.progress.note(fmt::format("resampling to spacing {}: about {} corners, {} MB",
                                    operation.spacing, prediction.corners,
                                    prediction.bytes / 1'000'000));
  Edit<CornerBlock<Side>> edit(bench.tree());
  FieldScale scale;
  {
    const Timer timer(telling.report.msField);
    const Clay clay = resample(before, operation.spacing, {}, telling.progress);
    replaceAll<Side>(edit, Field<Side>(bench.field()).tree, withSide<Side>(clay).tree);
    scale = clay.scale;
    if (bench.clay.stiffness.any())
      bench.clay.stiffness = clay::stiffnessOf(
          resample(*bench.clay.stiffness.painted, operation.spacing, {}, telling.progress));
  }
  bench.keep(edit, scale, telling.report);
}

BOZZETTO_RUNS(SceneOperation);
BOZZETTO_RUNS(FillOperation);
BOZZETTO_RUNS(ImportOperation);
BOZZETTO_RUNS(ResampleOperation);

}  // namespace bozzetto
