// scene, fill, import, resample in JSON.
#include "sculptor/operation_format.hpp"

namespace bozzetto {
namespace {

SceneOperation readScene(JsonObject& object) {
  SceneOperation scene;
  if (object.has("spacing")) scene.spacing = object.number("spacing");
  if (object.has("iso")) scene.iso = object.number("iso");
  if (scene.spacing && *scene.spacing <= 0) object.fail("spacing", "a number above 0");
  if (scene.iso && (*scene.iso <= 0 || *scene.iso >= 1)) object.fail("iso", "a number in (0, 1)");
  return scene;
}

Json writeScene(const SceneOperation& scene) {
  Json json;
  if (scene.spacing) json["spacing"] = *scene.spacing;
  if (scene.iso) json["iso"] = *scene.iso;
  return json;
}

FillOperation readFill(JsonObject& object) {
  return {{readShape(object), readVector(object, "center", {0, 0, 0}),
           readVector(object, "radii", {8, 8, 8}), readRotation(object), readColour(object)}};
}

Json writeFill(const FillOperation& fill) {
  const Primitive& p = fill.primitive;
  return {{"shape", toText(p.shape)},
          {"center", listOf(p.centre)},
          {"radii", listOf(p.radii)},
          {"rotation", listOf(p.rotation)},
          {"colour", toText(p.colour)}};
}

ImportOperation readImport(JsonObject& object) {
  ImportOperation import;
  import.from = object.text("from");
  import.cells = object.number("cells", import.cells);
  if (import.cells <= 0) object.fail("cells", "a number above 0");
  if (object.has("spacing")) import.spacing = object.number("spacing");
  if (import.spacing && *import.spacing <= 0) object.fail("spacing", "a number above 0");
  import.colour = readColour(object);
  return import;
}

Json writeImport(const ImportOperation& import) {
  Json json{{"from", import.from}, {"cells", import.cells}, {"colour", toText(import.colour)}};
  if (import.spacing) json["spacing"] = *import.spacing;
  return json;
}

ResampleOperation readResample(JsonObject& object) {
  const double spacing = object.number("spacing");
  if (spacing <= 0) object.fail("spacing", "a number above 0");
  return {spacing};
}

Json writeResample(const ResampleOperation& resample) { return {{"spacing", resample.spacing}}; }

}  // namespace

std::span<const OperationFormat> sceneFormats() {
  static constexpr OperationFormat kFormats[] = {formatOf<readScene, writeScene>("scene"),
                                                 formatOf<readFill, writeFill>("fill"),
                                                 formatOf<readImport, writeImport>("import"),
                                                 formatOf<readResample, writeResample>("resample")};
  return kFormats;
}

}  // namespace bozzetto
