// tool and action in JSON.
#include "sculptor/operation_format.hpp"

namespace bozzetto {
namespace {

ToolOperation readTool(JsonObject& object) {
  ToolShape tool;
  tool.shape = readShape(object);
  tool.profile = object.choice<Profile>(
      "profile", {{"wyvill", Profile::wyvill}, {"box", Profile::box}}, Profile::wyvill);
  tool.radii = readVector(object, "radii", {8, 8, 8});
  tool.rotation = readRotation(object);
  return {tool};
}

Json writeTool(const ToolOperation& tool) {
  return {{"shape", toText(tool.shape.shape)},
          {"profile", toText(tool.shape.profile)},
          {"radii", listOf(tool.shape.radii)},
          {"rotation", listOf(tool.shape.rotation)}};
}

ActionOperation readAction(JsonObject& object) {
  using enum ActionKind;
  ActionOptions action;
  if (object.text("name") == "recall") {
    action.strength = object.number("strength", 0.5);
    return {action, readStep(object)};
  }
  action.kind = object.choice<ActionKind>("name",
                                          {{"add", add},
                                           {"remove", remove},
                                           {"erase", erase},
                                           {"paint", paint},
                                           {"paint_soft", paintSoft},
                                           {"smooth", smooth},
                                           {"hold", hold},
                                           {"push", push},
                                           {"grip", grip},
                                           {"swell", swell}},
                                          add);
  action.strength = object.number("strength", 0.5);
  action.colour = readColour(object);
  return {action, std::nullopt};
}

Json writeAction(const ActionOperation& operation) {
  if (operation.recall) {
    return {
        {"name", "recall"}, {"strength", operation.action.strength}, {"step", *operation.recall}};
  }
  return {{"name", toText(operation.action.kind)},
          {"strength", operation.action.strength},
          {"colour", toText(operation.action.colour)}};
}

}  // namespace

std::span<const OperationFormat> toolFormats() {
  static constexpr OperationFormat kFormats[] = {formatOf<readTool, writeTool>("tool"),
                                                 formatOf<readAction, writeAction>("action")};
  return kFormats;
}

}  // namespace bozzetto
