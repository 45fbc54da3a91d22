#include "ui/kept_look.hpp"

#include <array>
#include <glm/geometric.hpp>

#include "bozzetto/base/error.hpp"
#include "bozzetto/render/png.hpp"
#include "ui/lenient_json.hpp"

namespace bozzetto::ui {
namespace {

template <class T>
struct Named {
  const char* name;
  T value;
};
constexpr auto kModes = std::to_array<Named<Mode>>({{"clay", Mode::clay},
                                                    {"glaze", Mode::glaze},
                                                    {"metal", Mode::metal},
                                                    {"plastic", Mode::plastic},
                                                    {"glass", Mode::glass},
                                                    {"matcap", Mode::matcap},
                                                    {"wire", Mode::wire}});
constexpr auto kMatcaps = std::to_array<Named<Matcap>>({{"wax", Matcap::wax},
                                                        {"jade", Matcap::jade},
                                                        {"plaster", Matcap::plaster},
                                                        {"pewter", Matcap::pewter}});
constexpr auto kMetals =
    std::to_array<Named<Metal>>({{"chrome", Metal::chrome}, {"bronze", Metal::bronze}});
constexpr auto kSurroundings =
    std::to_array<Named<Environment>>({{"studio", Environment::studio},
                                       {"daylight", Environment::daylight},
                                       {"dusk", Environment::dusk},
                                       {"workshop", Environment::workshop},
                                       {"zebra", Environment::zebra}});
constexpr auto kFrames =
    std::to_array<Named<LightFrame>>({{"view", LightFrame::view}, {"clay", LightFrame::scene}});

template <class Table, class T>
const char* nameIn(const Table& table, T value) {
  for (const auto& row : table)
    if (row.value == value) return row.name;
  return "";
}

template <class Table, class T>
void takeNamed(const Json& json, const char* field, const Table& table, T& value) {
  std::string name;
  take(json, field, name);
  for (const auto& row : table)
    if (row.name == name) value = row.value;
}

template <class Vector>
Json arrayOf(const Vector& v) {
  Json array = Json::array();
  for (int n = 0; n < Vector::length(); ++n) array.push_back(v[n]);
  return array;
}

constexpr double kFarthest = 1e9;

template <class Vector>
void takeVector(const Json& json, const char* field, Vector& v) {
  std::vector<double> read;
  take(json, field, read);
  if (read.size() != std::size_t(Vector::length())) return;
  for (const double part : read)
    if (!(std::abs(part) <= kFarthest)) return;
  for (int n = 0; n < Vector::length(); ++n)
    v[n] = typename Vector::value_type(read[std::size_t(n)]);
}

Json jsonOf(const StudioLight& light) {
  Json json{{"towards", arrayOf(light.towards)},
            {"colour", arrayOf(light.colour)},
            {"wrap", light.wrap},
            {"goes_with", nameIn(kFrames, light.frame)},
            {"distance", light.distance}};
  if (light.box.half != glm::vec2(0)) {
    json["box"] = {{"half", arrayOf(light.box.half)},
                   {"softness", light.box.softness},
                   {"colour", arrayOf(light.box.colour)}};
  }
  return json;
}

StudioLight lightOf(const Json& json) {
  StudioLight light;
  takeVector(json, "towards", light.towards);
  if (!(glm::length(light.towards) > 1e-6f)) light.towards = {0, 1, 0};
  takeVector(json, "colour", light.colour);
  light.colour = glm::max(light.colour, glm::vec3(0));
  takeWithin(json, "wrap", 0.f, 1.f, light.wrap);
  takeNamed(json, "goes_with", kFrames, light.frame);
  takeWithin(json, "distance", 0.f, 1e6f, light.distance);
  if (const auto box = json.find("box"); box != json.end()) {
    takeVector(*box, "half", light.box.half);
    light.box.half = glm::max(light.box.half, glm::vec2(0));
    takeWithin(*box, "softness", 0.f, 1.f, light.box.softness);
    takeVector(*box, "colour", light.box.colour);
    light.box.colour = glm::max(light.box.colour, glm::vec3(0));
  }
  return light;
}

Json jsonOf(const Studio& studio) {
  Json json{{"surroundings", nameIn(kSurroundings, studio.environment)},
            {"turn", studio.turn},
            {"exposure", studio.exposure},
            {"lights", Json::array()}};
  for (const StudioLight& light : studio.lights) json["lights"].push_back(jsonOf(light));
  return json;
}

void takeStudio(const Json& json, Studio& studio) {
  Environment environment = studio.environment;
  takeNamed(json, "surroundings", kSurroundings, environment);
  studio = Studio(environment);
  takeWithin(json, "turn", -1e3f, 1e3f, studio.turn);
  takeWithin(json, "exposure", .01f, 10.f, studio.exposure);
  const auto lights = json.find("lights");
  if (lights == json.end() || !lights->is_array()) return;
  studio.lights.clear();
  for (const Json& light : *lights) {
    if (studio.lights.size() == Studio::kMostLights) break;
    studio.lights.push_back(lightOf(light));
  }
}

// Nothing where it is gone from where it was: the place stays, for when it comes back.
std::shared_ptr<const Image> imageFrom(const std::string& path) {
  try {
    return std::make_shared<const Image>(readPng(path));
  } catch (const Error&) {
    return nullptr;
  }
}

Json jsonOf(const Reference& reference) {
  const ReferencePicture& picture = reference.picture;
  return {{"from", reference.from},          {"centre", arrayOf(picture.centre)},
          {"right", arrayOf(picture.right)}, {"up", arrayOf(picture.up)},
          {"opacity", picture.opacity},      {"behind", picture.behind}};
}

void takeReference(const Json& json, std::vector<Reference>& all) {
  Reference reference;
  ReferencePicture& picture = reference.picture;
  take(json, "from", reference.from);
  takeVector(json, "centre", picture.centre);
  takeVector(json, "right", picture.right);
  takeVector(json, "up", picture.up);
  takeWithin(json, "opacity", 0.f, 1.f, picture.opacity);
  take(json, "behind", picture.behind);
  if (reference.from.empty()) return;
  picture.image = imageFrom(reference.from);
  all.push_back(std::move(reference));
}

void takeMatcap(const Json& json, ViewOptions& options) {
  options.matcapFrom.clear();
  options.look.matcapImage.reset();
  take(json, "matcap_from", options.matcapFrom);
  if (!options.matcapFrom.empty()) options.look.matcapImage = imageFrom(options.matcapFrom);
}

}  // namespace

std::string lookText(const ViewOptions& options) {
  const Look& look = options.look;
  Json json{{"mode", nameIn(kModes, look.mode)},
            {"metal", nameIn(kMetals, look.metal)},
            {"matcap", nameIn(kMatcaps, look.matcap)},
            {"flat", look.shading == Shading::flat},
            {"edges", look.edges},
            {"floor", look.floor},
            {"smoothed", options.smoothed},
            {"roughness", look.specular.roughness},
            {"highlights", look.specular.strength},
            {"paint", look.paint},
            {"studio", jsonOf(look.studio)},
            {"references", Json::array()}};
  if (!options.matcapFrom.empty()) json["matcap_from"] = options.matcapFrom;
  for (const Reference& each : options.references) json["references"].push_back(jsonOf(each));
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void takeLook(const std::string& text, ViewOptions& options) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return;
  Look& look = options.look;
  takeNamed(json, "mode", kModes, look.mode);
  takeNamed(json, "metal", kMetals, look.metal);
  takeNamed(json, "matcap", kMatcaps, look.matcap);
  takeMatcap(json, options);
  bool flat = look.shading == Shading::flat;
  take(json, "flat", flat);
  look.shading = flat ? Shading::flat : Shading::smooth;
  take(json, "edges", look.edges);
  take(json, "floor", look.floor);
  take(json, "smoothed", options.smoothed);
  takeWithin(json, "roughness", 0.f, 1.f, look.specular.roughness);
  takeWithin(json, "highlights", 0.f, 10.f, look.specular.strength);
  takeWithin(json, "paint", 0.f, 1.f, look.paint);
  if (const auto studio = json.find("studio"); studio != json.end()) {
    takeStudio(*studio, look.studio);
  }
  options.references.clear();
  if (const auto all = json.find("references"); all != json.end() && all->is_array()) {
    for (const Json& each : *all) takeReference(each, options.references);
  }
}

}  // namespace bozzetto::ui
