// combine, cut and text in JSON, and where tools come from.
#include "bozzetto/tool/relative.hpp"
#include "sculptor/operation_format.hpp"

namespace bozzetto {

namespace {

Lasso readLasso(JsonObject& region) {
  Lasso lasso;
  const Json& outline = region.required("lasso");
  if (!outline.is_array()) region.fail("lasso", "a list of points [x, y]");
  for (const Json& point : outline) {
    if (!point.is_array() || point.size() != 2) region.fail("lasso", "a list of points [x, y]");
    lasso.outline.emplace_back(region.toNumber(point[0], "lasso"),
                               region.toNumber(point[1], "lasso"));
  }
  JsonObject view(region.required("view"), region.where() + ": view");
  lasso.eye = readRequiredVector(view, "eye");
  const glm::dquat rotation = readRotation(view);
  view.checked([&] { lasso.worldFromView = normalisedRotation(rotation); });
  lasso.rays = view.flag("parallel", false) ? LassoRays::parallel : LassoRays::fromEye;
  view.done();
  return lasso;
}

}  // namespace

WorldRegion readRegion(JsonObject& object) {
  JsonObject json(object.required("region"), object.where() + ": region");
  WorldRegion region;
  if (json.has("lasso")) region.lasso = readLasso(json);
  if (!region.lasso || json.has("min") || json.has("max")) {
    region.low = readRequiredVector(json, "min");
    region.high = readRequiredVector(json, "max");
  }
  json.done();
  object.checked([&] { requireValid(region); });
  return region;
}

Json listOf(const WorldRegion& region) {
  Json json = Json::object();
  if (region.low != glm::dvec3(-WorldRegion::kEverywhere)) {
    json["min"] = listOf(region.low);
    json["max"] = listOf(region.high);
  }
  if (!region.lasso) return json;
  const Lasso& lasso = *region.lasso;
  for (const glm::dvec2& point : lasso.outline) json["lasso"].push_back({point.x, point.y});
  json["view"] = {{"eye", listOf(lasso.eye)},
                  {"rotation", listOf(lasso.worldFromView)},
                  {"parallel", lasso.rays == LassoRays::parallel}};
  return json;
}

namespace {

PatchSource readPatch(JsonObject& object) {
  JsonObject json(object.required("patch"), object.where() + ": patch");
  PatchSource patch;
  if (json.has("at") || json.has("normal"))
    patch.plane = {readRequiredVector(json, "at"), readVector(json, "normal", {0, 0, 1})};
  json.done();
  return patch;
}

Json jsonOf(const PatchSource& patch) {
  if (!patch.plane) return Json::object();
  return {{"at", listOf(patch.plane->at)}, {"normal", listOf(patch.plane->normal)}};
}

}  // namespace

ToolSource readSource(JsonObject& object, const char* key) {
  ToolSource source;
  source.from = object.text(key, "");
  if (object.has("region")) source.region = readRegion(object);
  if (object.has("patch")) source.patch = readPatch(object);
  if (object.has("pivot")) source.pivot = readVector(object, "pivot", {});
  if (object.has("contact")) source.contact = readVector(object, "contact", {});
  source.cells = object.number("cells", source.cells);
  source.width = object.number("width", source.width);
  source.height = object.number("height", source.height);
  source.text = object.text("text", "");
  source.font = object.text("font", "");
  source.letterSize = object.number("size", source.letterSize);
  source.letterDepth = object.number("depth", source.letterDepth);
  object.checked([&] { requireValid(source); });
  return source;
}

void writeSource(const ToolSource& source, const char* key, Json& json) {
  const ToolSource usual;
  if (!source.from.empty()) json[key] = source.from;
  if (source.region) json["region"] = listOf(*source.region);
  if (source.patch) json["patch"] = jsonOf(*source.patch);
  if (source.pivot) json["pivot"] = listOf(*source.pivot);
  if (source.contact) json["contact"] = listOf(*source.contact);
  if (source.cells != usual.cells) json["cells"] = source.cells;
  if (source.width != usual.width) json["width"] = source.width;
  if (source.height != usual.height) json["height"] = source.height;
  if (!source.text.empty()) json["text"] = source.text;
  if (!source.font.empty()) json["font"] = source.font;
  if (source.letterSize != usual.letterSize) json["size"] = source.letterSize;
  if (source.letterDepth != usual.letterDepth) json["depth"] = source.letterDepth;
}

namespace {

CombinePose readPose(JsonObject& object) {
  CombinePose pose;
  if (!object.has("pose")) return pose;
  JsonObject json(object.required("pose"), object.where() + ": pose");
  pose.at = readVector(json, "at", {0, 0, 0});
  pose.rotation = readRotation(json);
  pose.scale = readVector(json, "scale", {1, 1, 1});
  json.done();
  return pose;
}

Json jsonOf(const CombinePose& pose) {
  return {
      {"at", listOf(pose.at)}, {"rotation", listOf(pose.rotation)}, {"scale", listOf(pose.scale)}};
}

CombineOperation readCombine(JsonObject& object) {
  CombineOperation combine;
  object.required("with");
  combine.with = readSource(object, "with");
  combine.how = object.choice<Combining>("how",
                                         {{"union", Combining::unite},
                                          {"subtract", Combining::subtract},
                                          {"intersect", Combining::intersect}},
                                         Combining::unite);
  combine.pose = readPose(object);
  return combine;
}

Json writeCombine(const CombineOperation& combine) {
  Json json{{"how", toText(combine.how)}, {"pose", jsonOf(combine.pose)}};
  writeSource(combine.with, "with", json);
  return json;
}

CutOperation readCut(JsonObject& object) { return {readRegion(object)}; }
Json writeCut(const CutOperation& cut) { return {{"region", listOf(cut.region)}}; }

TextOperation readText(JsonObject& object) {
  TextOperation text;
  text.text = object.text("text");
  text.size = object.number("size", text.size);
  text.depth = object.number("depth", text.depth);
  text.pose = readPose(object);
  text.colour = readColour(object);
  text.font = object.text("font", "");
  return text;
}

Json writeText(const TextOperation& text) {
  Json json{{"text", text.text},
            {"size", text.size},
            {"depth", text.depth},
            {"pose", jsonOf(text.pose)},
            {"colour", toText(text.colour)}};
  if (!text.font.empty()) json["font"] = text.font;
  return json;
}

}  // namespace

std::span<const OperationFormat> volumeFormats() {
  static constexpr OperationFormat kFormats[] = {formatOf<readCombine, writeCombine>("combine"),
                                                 formatOf<readCut, writeCut>("cut"),
                                                 formatOf<readText, writeText>("text")};
  return kFormats;
}

}  // namespace bozzetto
