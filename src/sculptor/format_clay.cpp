// clay, relax, support, hold, release in JSON.
#include <glm/vector_relational.hpp>

#include "sculptor/operation_format.hpp"

namespace bozzetto {
namespace {

std::vector<clay::LayerKind> readLayers(JsonObject& object) {
  if (!object.has("layers")) return clay::Settings{}.layers;
  const Json& list = object.required("layers");
  std::vector<clay::LayerKind> layers;
  if (!list.is_array()) object.fail("layers", "a list of names");
  for (const Json& name : list) {
    const auto layer = name.is_string() ? clay::layerNamed(name.get<std::string>()) : std::nullopt;
    if (!layer)
      object.fail("layers", "displacement, conservation, tension, diffusion or automaton");
    layers.push_back(*layer);
  }
  return layers;
}

// Spreading curves by name: even, straight, and bell-like (Raffin, figure 5).
std::array<double, 2> readProfile(JsonObject& object) {
  if (!object.has("profile") || !object.required("profile").is_string())
    return object.numbers<2>("profile", clay::Settings{}.profile);
  using Point = std::array<double, 2>;
  return object.choice<Point>(
      "profile",
      {{"uniform", clay::kUniform}, {"linear", clay::kLinear}, {"gaussian", clay::kGaussian}},
      clay::kLinear);
}

ClayOperation readClay(JsonObject& object) {
  using namespace clay;
  Settings s;
  s.layers = readLayers(object);
  s.scheme = object.choice<Scheme>("scheme",
                                   {{"projected", Scheme::projected},
                                    {"paper", Scheme::paper},
                                    {"paper_sweeps", Scheme::paperSweeps}},
                                   s.scheme);
  s.stiffness = object.number("stiffness", s.stiffness);
  s.distanceOffset = object.number("distance_offset", s.distanceOffset);
  s.parting = object.number("parting", s.parting);
  s.crumb = object.integer("crumb", s.crumb);
  s.iterations = object.integer("iterations", s.iterations);
  s.viscosity = object.number("viscosity", s.viscosity);
  s.profile = readProfile(object);
  s.walk = object.number("walk", s.walk);
  s.rate = object.number("rate", s.rate);
  s.threshold = object.number("threshold", s.threshold);
  s.sharing = object.choice<SharingRule>(
      "sharing", {{"capped", SharingRule::capped}, {"literal", SharingRule::literal}}, s.sharing);
  s.sweeps = object.integer("sweeps", s.sweeps);
  try {
    requireValid(s);
  } catch (const Error& error) {
    object.fail(error.what());
  }
  return {s};
}

Json writeClay(const ClayOperation& operation) {
  const clay::Settings& s = operation.settings;
  Json layers = Json::array();
  for (const clay::LayerKind layer : s.layers) layers.push_back(toText(layer));
  return {{"layers", layers},
          {"scheme", toText(s.scheme)},
          {"stiffness", s.stiffness},
          {"distance_offset", s.distanceOffset},
          {"parting", s.parting},
          {"crumb", s.crumb},
          {"iterations", s.iterations},
          {"viscosity", s.viscosity},
          {"profile", s.profile},
          {"walk", s.walk},
          {"rate", s.rate},
          {"threshold", s.threshold},
          {"sharing", toText(s.sharing)},
          {"sweeps", s.sweeps}};
}

RelaxOperation readRelax(JsonObject& object) {
  const int steps = object.integer("steps", 10);
  if (steps < 0) object.fail("steps", "a number of steps");
  return {steps};
}

Json writeRelax(const RelaxOperation& relax) { return {{"steps", relax.steps}}; }

SupportOperation readSupport(JsonObject& object) {
  SupportOperation operation;
  clay::Support& support = operation.support;
  support.centre = readVector(object, "center", {0, 0, 0});
  support.rotation = readRotation(object);
  support.shape = readToolShape(object);
  if (support.shape != Shape::freeform) {
    support.radii = readVector(object, "radii", {8, 8, 8});
    return operation;
  }
  operation.source = readSource(object, "from");
  if (object.has("radii")) {
    support.radii = readRequiredVector(object, "radii");
  } else {
    operation.scale = readVector(object, "scale", {1, 1, 1});
  }
  return operation;
}

Json writeSupport(const SupportOperation& operation) {
  const clay::Support& support = operation.support;
  Json json{{"shape", toText(support.shape)},
            {"center", listOf(support.centre)},
            {"rotation", listOf(support.rotation)}};
  if (operation.scale) {
    json["scale"] = listOf(*operation.scale);
  } else {
    json["radii"] = listOf(support.radii);
  }
  if (operation.source) writeSource(*operation.source, "from", json);
  return json;
}

int readNumber(JsonObject& object) {
  object.required("number");
  const int number = object.integer("number", 0);
  if (number < 0) object.fail("number", "a number of a support, from 0");
  return number;
}

SupportMoveOperation readSupportMove(JsonObject& object) {
  const bool brings = object.has("from") || object.has("text") || object.has("region");
  SupportMoveOperation move{readNumber(object), readSupport(object)};
  if (!brings) move.to.source.reset();
  return move;
}

Json writeSupportMove(const SupportMoveOperation& operation) {
  Json json = writeSupport(operation.to);
  json["number"] = operation.number;
  return json;
}

SupportDropOperation readSupportDrop(JsonObject& object) { return {readNumber(object)}; }
Json writeSupportDrop(const SupportDropOperation& drop) { return {{"number", drop.number}}; }

HoldOperation readHold(JsonObject& object) {
  HoldOperation hold;
  JsonObject box(object.required("box"), object.where() + ": box");
  box.required("min");
  box.required("max");
  hold.low = readVector(box, "min", {0, 0, 0});
  hold.high = readVector(box, "max", {0, 0, 0});
  box.done();
  if (glm::any(glm::greaterThan(hold.low, hold.high)))
    object.fail("box", "min at most max on every axis");
  hold.amount = object.number("amount", 1);
  if (hold.amount < 0 || hold.amount > 1) object.fail("amount", "a number in 0…1");
  return hold;
}

Json writeHold(const HoldOperation& hold) {
  return {{"box", {{"min", listOf(hold.low)}, {"max", listOf(hold.high)}}},
          {"amount", hold.amount}};
}

ReleaseOperation readRelease(JsonObject& object) {
  return {object.flag("hold", true), object.flag("supports", true), object.flag("stiffness", true)};
}

Json writeRelease(const ReleaseOperation& release) {
  return {{"hold", release.hold}, {"supports", release.supports}, {"stiffness", release.stiffness}};
}

}  // namespace

std::span<const OperationFormat> clayFormats() {
  static constexpr OperationFormat kFormats[] = {
      formatOf<readClay, writeClay>("clay"),
      formatOf<readRelax, writeRelax>("relax"),
      formatOf<readSupport, writeSupport>("support"),
      formatOf<readHold, writeHold>("hold"),
      formatOf<readRelease, writeRelease>("release"),
      formatOf<readSupportMove, writeSupportMove>("support_move"),
      formatOf<readSupportDrop, writeSupportDrop>("support_drop")};
  return kFormats;
}

}  // namespace bozzetto
