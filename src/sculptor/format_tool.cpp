// tool and action in JSON.
#include "sculptor/operation_format.hpp"

namespace bozzetto {
namespace {

ToolOperation readFreeform(JsonObject& object) {
  ToolOperation tool;
  tool.shape.shape = Shape::freeform;
  tool.shape.scale = readVector(object, "scale", {1, 1, 1});
  tool.shape.rotation = readRotation(object);
  tool.source = readSource(object, "from");
  object.checked([&] { requireValid(tool.shape); });
  return tool;
}

StampOptions readStamp(JsonObject& object) {
  StampOptions stamp;
  stamp.conserving = object.flag("conserving", stamp.conserving);
  if (!object.has("bulge")) return stamp;
  JsonObject bulge(object.required("bulge"), object.where() + ": bulge");
  stamp.height = bulge.number("height", stamp.height);
  stamp.rise = bulge.number("rise", stamp.rise);
  stamp.fall = bulge.number("fall", stamp.fall);
  stamp.slope = bulge.number("slope", stamp.slope);
  stamp.profile = bulge.choice<StampProfile>(
      "profile", {{"radius", StampProfile::radius}, {"paper", StampProfile::paper}},
      StampProfile::radius);
  bulge.done();
  return stamp;
}

Json jsonOf(const StampOptions& stamp) {
  return {{"height", stamp.height},
          {"rise", stamp.rise},
          {"fall", stamp.fall},
          {"slope", stamp.slope},
          {"profile", stamp.profile == StampProfile::paper ? "paper" : "radius"}};
}

ToolOperation readTool(JsonObject& object) {
  ToolShape tool;
  tool.shape = readToolShape(object);
  if (tool.shape == Shape::freeform) return readFreeform(object);
  tool.profile = object.choice<Profile>(
      "profile", {{"wyvill", Profile::wyvill}, {"box", Profile::box}}, Profile::wyvill);
  tool.radii = readVector(object, "radii", {8, 8, 8});
  tool.rotation = readRotation(object);
  object.checked([&] { requireValid(tool); });
  return {tool};
}

Json writeTool(const ToolOperation& tool) {
  if (tool.source) {
    Json json{{"shape", "freeform"},
              {"scale", listOf(tool.shape.scale)},
              {"rotation", listOf(tool.shape.rotation)}};
    writeSource(*tool.source, "from", json);
    return json;
  }
  return {{"shape", toText(tool.shape.shape)},
          {"profile", toText(tool.shape.profile)},
          {"radii", listOf(tool.shape.radii)},
          {"rotation", listOf(tool.shape.rotation)}};
}

ActionOptions readOptions(JsonObject& object) {
  using enum ActionKind;
  ActionOptions action;
  action.kind = object.choice<ActionKind>("name",
                                          {{"add", add},
                                           {"remove", remove},
                                           {"erase", erase},
                                           {"paint", paint},
                                           {"paint_soft", paintSoft},
                                           {"smooth", smooth},
                                           {"stamp", stamp},
                                           {"hold", hold},
                                           {"free", free},
                                           {"stiffen", stiffen},
                                           {"soften", soften},
                                           {"push", push},
                                           {"grip", grip},
                                           {"swell", swell}},
                                          add);
  action.strength = object.number("strength", action.kind == grip ? 1 : 0.5);
  action.colour = readColour(object);
  action.ownColours = object.flag("own_colours", false);
  if (action.kind == stamp) action.stamp = readStamp(object);
  return action;
}

ActionOperation readAction(JsonObject& object) {
  ActionOperation operation;
  if (object.text("name") == "recall") {
    operation.action.strength = object.number("strength", 0.5);
    operation.recall = readStep(object);
  } else {
    operation.action = readOptions(object);
  }
  object.checked([&] { requireValid(operation.action); });
  return operation;
}

Json writeAction(const ActionOperation& operation) {
  const ActionOptions& action = operation.action;
  if (operation.recall)
    return {{"name", "recall"}, {"strength", action.strength}, {"step", *operation.recall}};
  Json json{{"name", toText(action.kind)},
            {"strength", action.strength},
            {"colour", toText(action.colour)}};
  if (action.ownColours) json["own_colours"] = true;
  if (action.kind == ActionKind::stamp) {
    json["bulge"] = jsonOf(action.stamp);
    json["conserving"] = action.stamp.conserving;
  }
  return json;
}

}  // namespace

std::span<const OperationFormat> toolFormats() {
  static constexpr OperationFormat kFormats[] = {formatOf<readTool, writeTool>("tool"),
                                                 formatOf<readAction, writeAction>("action")};
  return kFormats;
}

}  // namespace bozzetto
