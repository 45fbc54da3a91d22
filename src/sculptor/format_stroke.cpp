// stroke in JSON.
#include <algorithm>
#include <cmath>

#include "sculptor/operation_format.hpp"

namespace bozzetto {
namespace {

Symmetry readSymmetry(JsonObject& object) {
  Symmetry result;
  for (const char letter : object.text("mirror", "")) {
    if (letter < 'x' || letter > 'z') object.fail("mirror", "some of the letters x, y, z");
    result.mirror[static_cast<std::size_t>(letter - 'x')] = true;
  }
  result.centre = readVector(object, "mirror_at", {0, 0, 0});
  if (object.has("radial")) {
    JsonObject radial(object.required("radial"), object.where() + ": radial");
    result.radialAxis = readAxis(radial, "axis");
    result.radialCount = radial.integer("count", 1);
    radial.done();
  }
  return result;
}

void writeSymmetry(const Symmetry& symmetry, Json& json) {
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

PressureTargets readPressureTargets(JsonObject& object) {
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

std::vector<glm::dquat> readRotations(JsonObject& object) {
  std::vector<glm::dquat> rotations;
  if (!object.has("rotations")) return rotations;
  const Json& lists = object.required("rotations");
  if (!lists.is_array()) object.fail("rotations", "a list of rotations, one a point");
  for (const Json& list : lists) {
    if (!list.is_array() || list.size() != 4)
      object.fail("'rotations': each has 4 numbers: w, x, y, z");
    const auto number = [&](std::size_t n) { return object.toNumber(list[n], "rotations"); };
    rotations.push_back({number(0), number(1), number(2), number(3)});
  }
  return rotations;
}

Placement readPlacement(JsonObject& object) {
  Placement placement;
  if (object.has("orient")) {
    const Json& list = object.required("orient");
    if (!list.is_array()) object.fail("orient", "a list of \"normal\" and \"stroke\"");
    for (const Json& name : list) {
      if (name != "normal" && name != "stroke")
        object.fail("orient", "a list of \"normal\" and \"stroke\"");
      (name == "normal" ? placement.toNormal : placement.alongStroke) = true;
    }
  }
  if (object.has("jitter")) {
    JsonObject jitter(object.required("jitter"), object.where() + ": jitter");
    placement.jitter.position = jitter.number("position", 0);
    placement.jitter.size = jitter.number("size", 0);
    placement.jitter.rotation = jitter.number("rotation", 0);
    placement.jitter.seed = static_cast<std::uint64_t>(jitter.integer("seed", 1));
    jitter.done();
  }
  placement.roll = object.number("roll", 0);
  placement.grid = object.number("grid", 0);
  placement.anchored = object.flag("anchored", false);
  if (object.has("array")) {
    JsonObject array(object.required("array"), object.where() + ": array");
    const glm::dvec3 count = readVector(array, "count", {1, 1, 1});
    for (std::size_t a = 0; a < 3; ++a) {
      if (count[int(a)] != std::floor(count[int(a)])) array.fail("count", "three whole numbers");
      placement.copies[a] = static_cast<int>(std::clamp(count[int(a)], -1e9, 1e9));
    }
    placement.copyStep = readVector(array, "step", {0, 0, 0});
    array.done();
  }
  return placement;
}

void writePlacement(const Placement& placement, Json& json) {
  if (placement.toNormal) json["orient"].push_back("normal");
  if (placement.alongStroke) json["orient"].push_back("stroke");
  if (!(placement.jitter == Jitter{})) {
    json["jitter"] = {{"position", placement.jitter.position},
                      {"size", placement.jitter.size},
                      {"rotation", placement.jitter.rotation},
                      {"seed", placement.jitter.seed}};
  }
  if (placement.roll != 0) json["roll"] = placement.roll;
  if (placement.grid != 0) json["grid"] = placement.grid;
  if (placement.anchored) json["anchored"] = true;
  if (placement.copies != std::array<int, 3>{1, 1, 1})
    json["array"] = {{"count", placement.copies}, {"step", listOf(placement.copyStep)}};
}

StrokeOperation readStroke(JsonObject& object) {
  Stroke stroke;
  stroke.points = readPoints(object);
  stroke.rotations = readRotations(object);
  stroke.spacing = object.number("spacing", 0.25);
  stroke.pressure = readPressureTargets(object);
  stroke.symmetry = readSymmetry(object);
  stroke.placement = readPlacement(object);
  object.checked([&] { requireValid(stroke); });
  return {std::move(stroke)};
}

Json writeStroke(const StrokeOperation& operation) {
  const Stroke& stroke = operation.stroke;
  Json json{{"points", listOf(stroke.points)}, {"spacing", stroke.spacing}};
  for (const glm::dquat& rotation : stroke.rotations) json["rotations"].push_back(listOf(rotation));
  if (stroke.pressure.strength) json["pressure"].push_back("strength");
  if (stroke.pressure.size) json["pressure"].push_back("size");
  writeSymmetry(stroke.symmetry, json);
  writePlacement(stroke.placement, json);
  return json;
}

}  // namespace

std::span<const OperationFormat> strokeFormats() {
  static constexpr OperationFormat kFormats[] = {formatOf<readStroke, writeStroke>("stroke")};
  return kFormats;
}

}  // namespace bozzetto
