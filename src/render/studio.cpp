#include "render/studio.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "render/names.hpp"

namespace bozzetto {
namespace {

using glm::vec3;
using glm::vec4;

struct Material {
  float roughness = .36f, sigma = .45f, specular = 1.5f, coat = 0;
  vec4 tint{1, 1, 1, 0};
};

Material materialOf(const Look& look) {
  Material m{look.specular.roughness, .45f, look.specular.strength, 0};
  switch (look.mode) {
    case Mode::glaze:
      m.coat = 1;
      break;
    case Mode::metal:
      m.roughness = look.metal == Metal::chrome ? .10f : .22f;
      m.tint = look.metal == Metal::chrome ? vec4(1, .98f, .96f, 0) : vec4(1.15f, .72f, .42f, 0);
      break;
    case Mode::glass:
      m.roughness = .06f;
      m.tint = {.55f, .85f, .95f, 0};
      break;
    default:
      break;
  }
  return m;
}

StudioLight key() {
  StudioLight light;
  light.towards = {-.58f, .60f, .55f};
  light.colour = {2.35f, 2.16f, 1.90f};
  light.box = {{.40f, .30f}, .10f, {9.5f, 8.9f, 8.0f}};
  return light;
}

// The photo studio: a soft key from the upper left, cool rim left, warm rim right.
std::vector<StudioLight> photoStudio() {
  StudioLight warm, cool, fill;
  warm.towards = {.80f, .30f, -.52f};
  warm.colour = {3.30f, 2.65f, 2.00f};
  warm.wrap = .12f;
  warm.box = {{.20f, .85f}, .06f, {7.0f, 6.3f, 5.4f}};
  cool.towards = {-.86f, .16f, -.50f};
  cool.colour = {1.10f, 1.45f, 1.95f};
  cool.wrap = .15f;
  cool.box = {{.13f, .85f}, .06f, {5.0f, 5.6f, 6.4f}};
  fill.towards = {.75f, -.05f, .66f};
  fill.colour = {.12f, .15f, .21f};
  fill.wrap = .50f;
  return {key(), warm, cool, fill};
}

// One strong light from the surroundings' brightest place.
std::vector<StudioLight> oneLight(vec3 towards, vec3 colour, float size) {
  StudioLight light;
  light.towards = towards;
  light.colour = colour;
  light.wrap = .1f;
  light.box = {{size, size}, .5f * size, colour * 6.f};
  return {light};
}

std::vector<StudioLight> lightsFor(Environment environment) {
  switch (environment) {
    case Environment::daylight:
      return oneLight({-.45f, .75f, .48f}, {2.6f, 2.45f, 2.15f}, .10f);
    case Environment::dusk:
      return oneLight({.90f, .20f, .30f}, {2.9f, 1.75f, .95f}, .14f);
    case Environment::workshop:
      return oneLight({-.75f, .45f, .48f}, {1.7f, 1.75f, 1.85f}, 0);
    case Environment::studio:
    case Environment::zebra:
      break;
  }
  return photoStudio();
}

// Lights whose highlight the environment does not hold have a round one.
bool hasBoxInEnvironment(const StudioLight& light) {
  return light.frame == LightFrame::view && light.distance <= 0 && light.box.half.x > 0;
}

vec3 viewTowards(const StudioLight& light, float turn, const glm::mat3& worldFromView) {
  if (light.frame == LightFrame::view) return turned(light.towards, turn);
  return glm::transpose(worldFromView) * glm::normalize(light.towards);
}

void setLight(StudioBlock& block, std::size_t n, const StudioLight& light, vec3 towards) {
  block.lightDirection[n] = {towards, light.wrap};
  block.lightColour[n] = {light.colour, hasBoxInEnvironment(light) ? 0 : 1};
  if (light.distance <= 0) return;
  block.lightPlace[n] = {vec3(block.middle) + towards * light.distance, light.distance};
}

}  // namespace

vec3 towardsInWorld(const Studio& studio, std::size_t n, const glm::mat3& worldFromView) {
  return worldFromView * viewTowards(studio.lights.at(n), studio.turn, worldFromView);
}

void aimLight(Studio& studio, std::size_t n, const vec3& towards, const glm::mat3& worldFromView) {
  StudioLight& light = studio.lights.at(n);
  const bool withView = light.frame == LightFrame::view;
  light.towards = withView ? turned(glm::transpose(worldFromView) * towards, -studio.turn)
                           : glm::normalize(towards);
}

namespace {

constexpr float kKeyBrightness = 2.2f, kGamma = 2.2f, kHardWrap = .05f, kSoftWrap = .5f;

}  // namespace

StudioLight studioLight(const PlainLight& plain) {
  const auto linear = [](std::uint8_t v) { return std::pow(float(v) / 255, kGamma); };
  const Colour& c = plain.colour;
  StudioLight light;
  light.towards = plain.towards;
  light.colour =
      vec3(linear(c.r), linear(c.g), linear(c.b)) * (kKeyBrightness * float(plain.intensity));
  light.wrap = kHardWrap + kSoftWrap * float(plain.softness);
  return light;
}

PlainLight plainLight(const StudioLight& light) {
  const vec3& c = light.colour;
  const float most = std::max({c.r, c.g, c.b, 1e-6f});
  const auto byte = [&](float v) {
    return std::uint8_t(std::lround(255 * std::pow(std::max(v, 0.f) / most, 1 / kGamma)));
  };
  PlainLight plain;
  plain.towards = light.towards;
  plain.colour = Colour{byte(c.r), byte(c.g), byte(c.b)};
  plain.intensity = double(most) / double(kKeyBrightness);
  plain.softness = std::clamp(double((light.wrap - kHardWrap) / kSoftWrap), 0., 1.);
  return plain;
}

Studio::Studio(Environment which) : lights(lightsFor(which)), environment(which) {}

Environment parseEnvironment(std::string_view name) {
  using enum Environment;
  return parseName<Environment>("environment", name,
                                {{"studio", studio},
                                 {"daylight", daylight},
                                 {"dusk", dusk},
                                 {"workshop", workshop},
                                 {"zebra", zebra}});
}

vec3 turned(const vec3& towards, float turn) {
  const float s = std::sin(turn), c = std::cos(turn);
  return glm::normalize(
      vec3(c * towards.x + s * towards.z, towards.y, c * towards.z - s * towards.x));
}

glm::dvec3 keyTowards(const Studio& studio, const Camera& camera) {
  if (studio.lights.empty()) return {0, 1, 0};
  return viewTowards(studio.lights[0], studio.turn, glm::mat3(camera.worldFromView()));
}

StudioBlock studioFor(const Look& look, const std::array<vec3, 9>& harmonics,
                      const StudioPose& pose) {
  StudioBlock block{};
  for (std::size_t n = 0; n < harmonics.size(); ++n) block.harmonics[n] = {harmonics[n], 0};
  block.middle = {pose.middle, 0};
  const Studio& studio = look.studio;
  const std::size_t count = std::min(studio.lights.size(), Studio::kMostLights);
  for (std::size_t n = 0; n < count; ++n) {
    setLight(block, n, studio.lights[n],
             viewTowards(studio.lights[n], studio.turn, pose.worldFromView));
  }
  const Material m = materialOf(look);
  block.material = {m.roughness, m.sigma, m.specular, m.coat};
  block.toning = {studio.exposure, .45f, 1, 1};
  block.tint = m.tint;
  block.options = {look.shading == Shading::flat, look.mode == Mode::plastic ? look.paint : 0.f,
                   look.holdTint, look.cellLines};
  block.counts = {count, 0, 0, 0};
  return block;
}

}  // namespace bozzetto
