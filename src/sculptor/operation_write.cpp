#include "sculptor/operation_json.hpp"

namespace bozzetto {
namespace {

Json listOf(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }
Json listOf(const glm::dquat& q) { return Json::array({q.w, q.x, q.y, q.z}); }

Json jsonOf(const SceneOperation& scene) {
  Json json;
  if (scene.spacing) json["spacing"] = *scene.spacing;
  if (scene.iso) json["iso"] = *scene.iso;
  return json;
}

Json jsonOf(const FillOperation& fill) {
  const Primitive& p = fill.primitive;
  return {{"shape", toText(p.shape)},
          {"center", listOf(p.centre)},
          {"radii", listOf(p.radii)},
          {"rotation", listOf(p.rotation)},
          {"colour", toText(p.colour)}};
}

Json jsonOf(const ToolOperation& tool) {
  return {{"shape", toText(tool.shape.shape)},
          {"profile", toText(tool.shape.profile)},
          {"radii", listOf(tool.shape.radii)},
          {"rotation", listOf(tool.shape.rotation)}};
}

Json jsonOf(const ActionOperation& operation) {
  return {{"name", toText(operation.action.kind)},
          {"strength", operation.action.strength},
          {"colour", toText(operation.action.colour)}};
}

Json jsonOf(const StrokePoint& point) {
  Json list = listOf(point.position);
  if (point.pressure != 1) list.push_back(point.pressure);
  return list;
}

void putSymmetry(const Symmetry& symmetry, Json& json) {
  std::string mirror;
  for (std::size_t n = 0; n < 3; ++n) {
    if (symmetry.mirror[n]) mirror += static_cast<char>('x' + n);
  }
  const bool radial = symmetry.radialCount != 1;
  if (!mirror.empty()) json["mirror"] = mirror;
  if (radial) {
    const std::string axis(1, static_cast<char>('x' + index(symmetry.radialAxis)));
    json["radial"] = {{"axis", axis}, {"count", symmetry.radialCount}};
  }
  if (radial || !mirror.empty()) json["mirror_at"] = listOf(symmetry.centre);
}

Json jsonOf(const StrokeOperation& operation) {
  const Stroke& stroke = operation.stroke;
  Json json{{"points", Json::array()}, {"spacing", stroke.spacing}};
  for (const StrokePoint& point : stroke.points) json["points"].push_back(jsonOf(point));
  if (stroke.pressure.strength) json["pressure"].push_back("strength");
  if (stroke.pressure.size) json["pressure"].push_back("size");
  putSymmetry(stroke.symmetry, json);
  return json;
}

Json jsonOf(const UndoOperation& undo) { return {{"count", undo.count}}; }
Json jsonOf(const RedoOperation& redo) { return {{"count", redo.count}}; }
Json jsonOf(const ResampleOperation& resample) { return {{"spacing", resample.spacing}}; }

}  // namespace

Json toJson(const Operation& operation) {
  Json json = std::visit([](const auto& each) { return jsonOf(each); }, operation);
  json["op"] = nameOf(operation);
  return json;
}

std::string_view nameOf(const Operation& operation) {
  constexpr std::string_view names[] = {"scene",  "fill", "tool", "action",
                                        "stroke", "undo", "redo", "resample"};
  static_assert(std::size(names) == std::variant_size_v<Operation>);
  return names[operation.index()];
}

std::string toText(const Operation& operation) { return toJson(operation).dump(); }

}  // namespace bozzetto
