#include <algorithm>

#include "sculptor/operation_json.hpp"

namespace bozzetto {
namespace {

glm::dvec3 vectorOf(const std::array<double, 3>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

glm::dvec3 vector(JsonObject& object, const char* key, std::array<double, 3> fallback) {
  return vectorOf(object.numbers<3>(key, fallback));
}

glm::dquat rotation(JsonObject& object) {
  const auto wxyz = object.numbers<4>("rotation", {1, 0, 0, 0});
  return {wxyz[0], wxyz[1], wxyz[2], wxyz[3]};
}

Shape shape(JsonObject& object) {
  return object.choice<Shape>("shape",
                              {{"ellipsoid", Shape::ellipsoid},
                               {"box", Shape::box},
                               {"cylinder", Shape::cylinder},
                               {"capsule", Shape::capsule}},
                              Shape::ellipsoid);
}

Colour colour(JsonObject& object) {
  if (!object.has("colour")) return {};
  try {
    return parseColour(object.text("colour"));
  } catch (const Error& error) {
    object.fail(error.what());
  }
}

Operation readScene(JsonObject& object) {
  SceneOperation scene;
  if (object.has("spacing")) scene.spacing = object.number("spacing");
  if (object.has("iso")) scene.iso = object.number("iso");
  if (scene.spacing && *scene.spacing <= 0) object.fail("spacing", "a number above 0");
  if (scene.iso && (*scene.iso <= 0 || *scene.iso >= 1)) object.fail("iso", "a number in (0, 1)");
  return scene;
}

Operation readFill(JsonObject& object) {
  return FillOperation{{shape(object), vector(object, "center", {0, 0, 0}),
                        vector(object, "radii", {8, 8, 8}), rotation(object), colour(object)}};
}

Operation readTool(JsonObject& object) {
  ToolShape tool;
  tool.shape = shape(object);
  tool.profile = object.choice<Profile>(
      "profile", {{"wyvill", Profile::wyvill}, {"box", Profile::box}}, Profile::wyvill);
  tool.radii = vector(object, "radii", {8, 8, 8});
  tool.rotation = rotation(object);
  return ToolOperation{tool};
}

Operation readAction(JsonObject& object) {
  using enum ActionKind;
  ActionOptions action;
  object.required("name");
  action.kind = object.choice<ActionKind>("name",
                                          {{"add", add},
                                           {"remove", remove},
                                           {"erase", erase},
                                           {"paint", paint},
                                           {"paint_soft", paintSoft},
                                           {"smooth", smooth}},
                                          add);
  action.strength = object.number("strength", 0.5);
  action.colour = colour(object);
  return ActionOperation{action};
}

StrokePoint point(const JsonObject& object, const Json& list) {
  if (!list.is_array() || (list.size() != 3 && list.size() != 4)) {
    object.fail("'points': each point has 3 coordinates and maybe a pressure");
  }
  const auto number = [&](std::size_t n) { return object.toNumber(list[n], "points"); };
  StrokePoint result{{number(0), number(1), number(2)}, list.size() == 4 ? number(3) : 1.0};
  if (result.pressure < 0 || result.pressure > 1) object.fail("'points': pressure not in 0…1");
  return result;
}

Axis axisFrom(JsonObject& object, const char* key) {
  return object.choice<Axis>(key, {{"x", Axis::x}, {"y", Axis::y}, {"z", Axis::z}}, Axis::y);
}

Symmetry symmetry(JsonObject& object) {
  Symmetry result;
  for (const char letter : object.text("mirror", "")) {
    if (letter < 'x' || letter > 'z') object.fail("mirror", "some of the letters x, y, z");
    result.mirror[static_cast<std::size_t>(letter - 'x')] = true;
  }
  result.centre = vector(object, "mirror_at", {0, 0, 0});
  if (object.has("radial")) {
    JsonObject radial(object.required("radial"), object.where() + ": radial");
    result.radialAxis = axisFrom(radial, "axis");
    result.radialCount = radial.integer("count", 1);
    radial.done();
  }
  return result;
}

PressureTargets pressureTargets(JsonObject& object) {
  PressureTargets targets;
  if (!object.has("pressure")) return targets;
  const Json& list = object.required("pressure");
  if (!list.is_array()) object.fail("pressure", "a list of \"strength\" and \"size\"");
  for (const Json& name : list) {
    if (name != "strength" && name != "size") {
      object.fail("pressure", "a list of \"strength\" and \"size\"");
    }
    (name == "size" ? targets.size : targets.strength) = true;
  }
  return targets;
}

Operation readStroke(JsonObject& object) {
  Stroke stroke;
  const Json& points = object.required("points");
  if (!points.is_array() || points.empty()) object.fail("points", "a list of points");
  stroke.points.reserve(points.size());
  for (const Json& list : points) stroke.points.push_back(point(object, list));
  stroke.spacing = object.number("spacing", 0.25);
  stroke.pressure = pressureTargets(object);
  stroke.symmetry = symmetry(object);
  return StrokeOperation{std::move(stroke)};
}

int count(JsonObject& object) {
  const int result = object.integer("count", 1);
  if (result < 0) object.fail("count", "a number of steps");
  return result;
}

Operation readUndo(JsonObject& object) { return UndoOperation{count(object)}; }
Operation readRedo(JsonObject& object) { return RedoOperation{count(object)}; }

Operation readResample(JsonObject& object) {
  const double spacing = object.number("spacing");
  if (spacing <= 0) object.fail("spacing", "a number above 0");
  return ResampleOperation{spacing};
}

using Reader = Operation (*)(JsonObject&);
constexpr std::pair<std::string_view, Reader> kReaders[] = {
    {"scene", readScene},   {"fill", readFill}, {"tool", readTool}, {"action", readAction},
    {"stroke", readStroke}, {"undo", readUndo}, {"redo", readRedo}, {"resample", readResample}};

}  // namespace

Operation operationFrom(JsonObject& object) {
  const std::string name = object.text("op");
  const auto* reader =
      std::ranges::find(kReaders, name, &std::pair<std::string_view, Reader>::first);
  if (reader == std::end(kReaders)) object.fail("unknown operation '" + name.substr(0, 40) + "'");
  Operation operation = reader->second(object);
  object.done();
  return operation;
}

}  // namespace bozzetto
