// What each operation does: one function a kind, in the file of its family (run_FAMILY.cpp),
// instantiated there for both block sides. All or nothing: what throws has changed nothing.
#pragma once
#include "bozzetto/base/progress.hpp"
#include "bozzetto/sculptor/operation.hpp"
#include "bozzetto/sculptor/workbench.hpp"

namespace bozzetto {

/// Whom a run tells what it does.
struct Telling {
  OperationReport& report;
  Progress& progress;
};

/// The sculpture that a source means, also the clay at hand. Throws what ToolLibrary does.
template <int Side>
std::shared_ptr<const Sculpture> sculptureFor(const ToolSource& source, Workbench<Side>& bench,
                                              Progress& progress);

template <int Side>
void run(const SceneOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const FillOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const ImportOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const ResampleOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const ToolOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const ActionOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const StrokeOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const UndoOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const RedoOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const GoToOperation& operation, Workbench<Side>& bench, const Telling& telling);

template <int Side>
void run(const SolidOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const SolidMoveOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const BakeOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const WrapOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const WrapApplyOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const SolidDropOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const ClayOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const RelaxOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const SupportOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const HoldOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const ReleaseOperation& operation, Workbench<Side>& bench, const Telling& telling);

template <int Side>
void run(const SolidFromClayOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const SolidCarveOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const SolidExtrudeOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const SolidJoinOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const SolidSubdivideOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const SolidSharpOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const SolidPullOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const SolidRunOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const SolidSplineOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const SolidPaintOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const SolidInflateOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const SolidTrimOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const SolidWindowOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const SolidRestOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const SolidSettingsOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const SolidProbeOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const CombineOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const CutOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const TextOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const ShelfKeepOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const ShelfRenameOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const ShelfDropOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const SupportMoveOperation& operation, Workbench<Side>& bench, const Telling& telling);
template <int Side>
void run(const SupportDropOperation& operation, Workbench<Side>& bench, const Telling& telling);

/// At the end of a family's file.
#define BOZZETTO_RUNS(Kind)                                      \
  template void run(const Kind&, Workbench<1>&, const Telling&); \
  template void run(const Kind&, Workbench<8>&, const Telling&)

}  // namespace bozzetto
