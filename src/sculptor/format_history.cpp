// undo, redo and goto in JSON.
#include "sculptor/operation_format.hpp"

namespace bozzetto {
namespace {

int readCount(JsonObject& object) {
  const int result = object.integer("count", 1);
  if (result < 0) object.fail("count", "a number of steps");
  return result;
}

UndoOperation readUndo(JsonObject& object) { return {readCount(object)}; }
RedoOperation readRedo(JsonObject& object) { return {readCount(object)}; }
GoToOperation readGoTo(JsonObject& object) { return {readStep(object)}; }
Json writeUndo(const UndoOperation& undo) { return {{"count", undo.count}}; }
Json writeRedo(const RedoOperation& redo) { return {{"count", redo.count}}; }
Json writeGoTo(const GoToOperation& goTo) { return {{"step", goTo.step}}; }

}  // namespace

std::span<const OperationFormat> historyFormats() {
  static constexpr OperationFormat kFormats[] = {formatOf<readUndo, writeUndo>("undo"),
                                                 formatOf<readRedo, writeRedo>("redo"),
                                                 formatOf<readGoTo, writeGoTo>("goto")};
  return kFormats;
}

}  // namespace bozzetto
