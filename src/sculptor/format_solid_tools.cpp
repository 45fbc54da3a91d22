// The sixteen tools on solids in JSON.
#include "sculptor/operation_format.hpp"

namespace bozzetto {
namespace {

glm::dvec3 readAt(JsonObject& object) { return readRequiredVector(object, "at"); }

int readSteps(JsonObject& object) {
  const int steps = object.integer("steps", 20);
  if (steps < 0 || steps > 100000) object.fail("steps", "0 to 100000");
  return steps;
}

std::vector<glm::dvec3> readPlaces(JsonObject& object, const char* key) {
  const Json& lists = object.required(key);
  if (!lists.is_array() || lists.size() < 2) object.fail(key, "a list of two or more points");
  std::vector<glm::dvec3> places;
  for (const Json& list : lists) {
    if (!list.is_array() || list.size() != 3) object.fail(key, "points of 3 coordinates");
    places.emplace_back(object.toNumber(list[0], key), object.toNumber(list[1], key),
                        object.toNumber(list[2], key));
  }
  return places;
}

// Calls back for every object of a list.
template <class Callback>
void forObjects(JsonObject& object, const char* key, Callback&& callback) {
  const Json& list = object.required(key);
  if (!list.is_array() || list.empty()) object.fail(key, "a list of objects");
  for (const Json& each : list) {
    JsonObject inner(each, object.where() + ": " + key);
    callback(inner);
    inner.done();
  }
}

SolidFromClayOperation readFromClay(JsonObject& object) { return {object.integer("cells", 8)}; }
Json writeFromClay(const SolidFromClayOperation& tool) { return {{"cells", tool.cells}}; }

SolidCarveOperation readCarve(JsonObject& object) { return {readAt(object)}; }
Json writeCarve(const SolidCarveOperation& tool) { return {{"at", listOf(tool.at)}}; }

SolidExtrudeOperation readExtrude(JsonObject& object) {
  return {readAt(object), object.number("length", 0)};
}
Json writeExtrude(const SolidExtrudeOperation& tool) {
  return {{"at", listOf(tool.at)}, {"length", tool.length}};
}

SolidJoinOperation readJoin(JsonObject& object) {
  const glm::dvec3 at = readAt(object);
  return {at, readRequiredVector(object, "to")};
}
Json writeJoin(const SolidJoinOperation& tool) {
  return {{"at", listOf(tool.at)}, {"to", listOf(tool.to)}};
}

SolidSubdivideOperation readSubdivide(JsonObject& object) { return {readAt(object)}; }
Json writeSubdivide(const SolidSubdivideOperation& tool) { return {{"at", listOf(tool.at)}}; }

SolidSharpOperation readSharp(JsonObject& object) {
  SolidSharpOperation tool;
  tool.element = object.choice<Element>(
      "what", {{"face", Element::face}, {"edge", Element::edge}, {"point", Element::point}},
      Element::face);
  tool.at = readAt(object);
  tool.sharp = object.flag("sharp", true) ? Sharp::yes : Sharp::no;
  return tool;
}
Json writeSharp(const SolidSharpOperation& tool) {
  const char* what = tool.element == Element::face   ? "face"
                     : tool.element == Element::edge ? "edge"
                                                     : "point";
  return {{"what", what}, {"at", listOf(tool.at)}, {"sharp", tool.sharp == Sharp::yes}};
}

SolidPullOperation readPull(JsonObject& object) {
  SolidPullOperation tool;
  forObjects(object, "ropes", [&](JsonObject& rope) {
    const glm::dvec3 at = readAt(rope);
    tool.ropes.push_back({at, readRequiredVector(rope, "to")});
  });
  if (tool.ropes.size() > 64) object.fail("ropes", "at most 64 ropes");
  if (object.has("strength")) tool.strength = object.number("strength");
  if (tool.strength && !(*tool.strength >= 0 && *tool.strength <= 1e6))
    object.fail("strength", "0 to 1e6");
  tool.steps = readSteps(object);
  return tool;
}
Json writePull(const SolidPullOperation& tool) {
  Json json{{"ropes", Json::array()}, {"steps", tool.steps}};
  for (const Pull& pull : tool.ropes)
    json["ropes"].push_back({{"at", listOf(pull.at)}, {"to", listOf(pull.to)}});
  if (tool.strength) json["strength"] = *tool.strength;
  return json;
}

SolidRunOperation readRun(JsonObject& object) { return {readSteps(object)}; }
Json writeRun(const SolidRunOperation& tool) { return {{"steps", tool.steps}}; }

SolidSplineOperation readSpline(JsonObject& object) {
  SolidSplineOperation tool;
  tool.points = readPlaces(object, "points");
  if (tool.points.size() > 64) object.fail("points", "at most 64 points");
  forObjects(object, "drag", [&](JsonObject& drag) {
    const int control = drag.integer("control", 0);
    if (control < 0) drag.fail("control", "a control point's number");
    tool.drags.push_back({static_cast<std::size_t>(control), readRequiredVector(drag, "by")});
  });
  tool.steps = readSteps(object);
  return tool;
}
Json writeSpline(const SolidSplineOperation& tool) {
  Json json{{"points", Json::array()}, {"drag", Json::array()}, {"steps", tool.steps}};
  for (const auto& point : tool.points) json["points"].push_back(listOf(point));
  for (const SplineDrag& drag : tool.drags)
    json["drag"].push_back({{"control", drag.control}, {"by", listOf(drag.by)}});
  return json;
}

SolidPaintOperation readPaint(JsonObject& object) {
  SolidPaintOperation tool;
  tool.matter = object.choice<Matter>(
      "what", {{"mass", Matter::mass}, {"stiffness", Matter::hardness}}, Matter::mass);
  tool.at = readAt(object);
  tool.radius = object.number("radius", 10);
  tool.factor = object.number("factor", 2);
  return tool;
}
Json writePaint(const SolidPaintOperation& tool) {
  return {{"what", tool.matter == Matter::mass ? "mass" : "stiffness"},
          {"at", listOf(tool.at)},
          {"radius", tool.radius},
          {"factor", tool.factor}};
}

SolidInflateOperation readInflate(JsonObject& object) {
  const glm::dvec3 at = readAt(object);
  return {at, object.number("radius", 10), object.number("amount", 0.5), readSteps(object)};
}
Json writeInflate(const SolidInflateOperation& tool) {
  return {{"at", listOf(tool.at)},
          {"radius", tool.radius},
          {"amount", tool.amount},
          {"steps", tool.steps}};
}

SolidTrimOperation readTrim(JsonObject& object) {
  const glm::dvec3 at = readAt(object);
  return {at, object.number("radius", 10),
          object.flag("takes_part", false) ? TakesPart::yes : TakesPart::no};
}
Json writeTrim(const SolidTrimOperation& tool) {
  return {{"at", listOf(tool.at)},
          {"radius", tool.radius},
          {"takes_part", tool.part == TakesPart::yes}};
}

SolidWindowOperation readWindow(JsonObject& object) {
  if (object.has("min") != object.has("max")) object.fail("'min' and 'max' go together");
  if (!object.has("min")) return {};
  const glm::dvec3 low = readRequiredVector(object, "min");
  return {std::array{low, readRequiredVector(object, "max")}};
}
Json writeWindow(const SolidWindowOperation& tool) {
  if (!tool.box) return Json::object();
  return {{"min", listOf((*tool.box)[0])}, {"max", listOf((*tool.box)[1])}};
}

SolidRestOperation readRest(JsonObject&) { return {}; }
Json writeRest(const SolidRestOperation&) { return Json::object(); }

SolidSettingsOperation readSettings(JsonObject& object) {
  SolidSettingsOperation tool;
  if (object.has("solver")) {
    tool.solver = object.choice<Solver>("solver",
                                        {{"standard", Solver::standard},
                                         {"live", Solver::live},
                                         {"paper_explicit", Solver::paperExplicit},
                                         {"paper_implicit", Solver::paperImplicit}},
                                        Solver::standard);
  }
  if (object.has("levels")) tool.levels = object.integer("levels", 1);
  for (const SolidNumber& number : kSolidNumbers)
    if (object.has(number.name)) tool.*number.wanted = object.number(number.name);
  return tool;
}
Json writeSettings(const SolidSettingsOperation& tool) {
  Json json = Json::object();
  if (tool.solver) json["solver"] = toText(*tool.solver);
  if (tool.levels) json["levels"] = *tool.levels;
  for (const SolidNumber& number : kSolidNumbers)
    if (const auto& value = tool.*number.wanted) json[number.name] = *value;
  return json;
}

SolidProbeOperation readProbe(JsonObject& object) {
  const glm::dvec3 at = readAt(object);
  return {at, object.number("radius", 10)};
}
Json writeProbe(const SolidProbeOperation& tool) {
  return {{"at", listOf(tool.at)}, {"radius", tool.radius}};
}

}  // namespace

SolidSettingsOperation operationOf(const SolidSettings& settings) {
  SolidSettingsOperation all;
  all.solver = settings.solver;
  all.levels = settings.levels;
  for (const SolidNumber& number : kSolidNumbers) all.*number.wanted = settings.*number.value;
  return all;
}

std::span<const OperationFormat> solidToolFormats() {
  static constexpr OperationFormat kFormats[] = {
      formatOf<readFromClay, writeFromClay>("solid_from_clay"),
      formatOf<readCarve, writeCarve>("solid_carve"),
      formatOf<readExtrude, writeExtrude>("solid_extrude"),
      formatOf<readJoin, writeJoin>("solid_join"),
      formatOf<readSubdivide, writeSubdivide>("solid_subdivide"),
      formatOf<readSharp, writeSharp>("solid_sharp"),
      formatOf<readPull, writePull>("solid_pull"),
      formatOf<readRun, writeRun>("solid_run"),
      formatOf<readSpline, writeSpline>("solid_spline"),
      formatOf<readPaint, writePaint>("solid_paint"),
      formatOf<readInflate, writeInflate>("solid_inflate"),
      formatOf<readTrim, writeTrim>("solid_trim"),
      formatOf<readWindow, writeWindow>("solid_window"),
      formatOf<readRest, writeRest>("solid_rest"),
      formatOf<readSettings, writeSettings>("solid_settings"),
      formatOf<readProbe, writeProbe>("solid_probe")};
  return kFormats;
}

}  // namespace bozzetto
