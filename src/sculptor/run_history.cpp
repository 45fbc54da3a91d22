// undo and redo.
#include "sculptor/run.hpp"

namespace bozzetto {

template <int Side>
void run(const UndoOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  for (int n = 0; n < operation.count; ++n) {
    if (!bench.revisit(Direction::backward, telling.report)) break;
  }
}

template <int Side>
void run(const RedoOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  for (int n = 0; n < operation.count; ++n) {
    if (!bench.revisit(Direction::forward, telling.report)) break;
  }
}

BOZZETTO_RUNS(UndoOperation);
BOZZETTO_RUNS(RedoOperation);

}  // namespace bozzetto
