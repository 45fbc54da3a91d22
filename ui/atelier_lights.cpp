// Lights in the hand: handles around what is looked at, and what a document keeps of them.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <numbers>

#include "ui/atelier.hpp"
#include "ui/kept_look.hpp"

namespace bozzetto::ui {
namespace {

constexpr double kBallPart = .78;  // of half the view's smaller side: the ball that handles lie on
constexpr double kReachPixels = 12;

glm::mat3 turnOf(const ViewState& view) { return glm::mat3(glm::mat3_cast(view.worldFromView)); }

double ballRadius(const ViewState& view, const Extent& extent) {
  const double pixels = std::min(extent.width, extent.height) / 2 * kBallPart;
  return unitsPerPixel(view, extent, view.target) * pixels;
}

enum class Side { front, behind };

// Where a ray meets the ball around `centre`, as a direction. A ray beside it goes on around the
// rim to the other side, a quarter turn for a radius.
glm::dvec3 onBall(const Ray& ray, const glm::dvec3& centre, double radius, Side side) {
  const double sign = side == Side::behind ? 1 : -1;
  const double along = glm::dot(centre - ray.origin, ray.direction);
  const glm::dvec3 nearest = ray.origin + ray.direction * along - centre;
  const double beside = glm::length(nearest);
  if (beside < radius) {
    const double half = std::sqrt(radius * radius - beside * beside);
    return glm::normalize(nearest + ray.direction * (sign * half));
  }
  const double angle = std::min(beside / radius - 1, 1.) * std::numbers::pi / 2;
  return nearest / beside * std::cos(angle) - ray.direction * (sign * std::sin(angle));
}

Ink inkOf(const glm::vec3& colour) {
  const glm::vec3 hue = colour / std::max({colour.r, colour.g, colour.b, 1e-6f});
  return {std::sqrt(hue.r), std::sqrt(hue.g), std::sqrt(hue.b), 1};
}

}  // namespace

void Atelier::turnLight(glm::dvec2 by) { options.look.studio.turn += float(by.x * 0.01 / scale_); }

// One to a light, while somebody is busy with lights.
std::vector<LightMark> Atelier::lightMarks() const {
  const bool shown = lightsOpen || mouseMoves == Moves::light || puckMoves == Moves::light;
  if (!shown || dialog != Dialog::none) return {};
  const double spacing = status_.scale.spacing, radius = ballRadius(view, extent_);
  const Studio& studio = options.look.studio;
  std::vector<LightMark> marks;
  for (std::size_t n = 0; n < studio.lights.size(); ++n) {
    const glm::dvec3 towards(towardsInWorld(studio, n, turnOf(view)));
    LightMark mark;
    mark.place = (view.target + towards * radius) / spacing;
    mark.target = view.target / spacing;
    mark.ink = inkOf(studio.lights[n].colour);
    mark.active = lightHandle_ == n;
    marks.push_back(mark);
  }
  return marks;
}

// The handle under the pointer, the nearest to the eye.
void Atelier::findLight() {
  if (gesture_ == Gesture::lightHandle) return;
  lightHandle_.reset();
  double nearest = HUGE_VAL;
  const std::vector<LightMark> marks = lightMarks();
  for (std::size_t n = 0; n < marks.size(); ++n) {
    const glm::dvec3 place = marks[n].place * status_.scale.spacing;
    const double away = glm::distance(place, view.eye());
    const double beside = glm::distance(pixelOf(view, extent_, place), pointer_);
    if (beside > kReachPixels * scale_ || away >= nearest) continue;
    nearest = away;
    lightHandle_ = n;
    lightBehind_ = glm::dot(place - view.target, view.back()) < 0;
  }
}

void Atelier::dragLight(glm::dvec2 to) {
  Studio& studio = options.look.studio;
  if (!lightHandle_ || *lightHandle_ >= studio.lights.size()) return;
  const glm::dvec3 towards =
      onBall(rayThrough(view, extent_, to), view.target, ballRadius(view, extent_),
             lightBehind_ ? Side::behind : Side::front);
  aimLight(studio, *lightHandle_, glm::vec3(towards), turnOf(view));
}

// Whatever changed the lights, the view's undo takes it back.
void Atelier::watchLights() {
  if (options.look.studio == studioSeen_) return;
  views_.moved({view, std::exchange(studioSeen_, options.look.studio)}, now_);
  touch();
}

void Atelier::changeSight(bool (ViewHistory::*how)(Sight&)) {
  watchLights();
  Sight sight{view, options.look.studio};
  (views_.*how)(sight);
  view = sight.view;
  studioSeen_ = options.look.studio = sight.studio;
  updateHover();
}

// A document without lights of its own has those that its environment is made with. What this
// window kept says more than the plain lights that everybody reads.
void Atelier::takeLights(const SceneParts& parts) {
  Studio& studio = options.look.studio;
  const View& kept = parts.view;
  studio.lights = Studio(studio.environment).lights;
  studio.turn = 0;
  if (!kept.lights.empty()) studio.lights.clear();
  for (const Light& light : kept.lights) {
    if (studio.lights.size() == Studio::kMostLights) break;
    studio.lights.push_back(
        studioLight({light.towards, light.colour, light.intensity, light.softness}));
    if (light.castsShadow) std::swap(studio.lights.front(), studio.lights.back());
  }
  const auto look = parts.settings.find(kLookSetting);
  if (look != parts.settings.end()) takeLook(look->second, options);
  const auto lost = [&](const std::string& from) {
    say(Message::Kind::error, from + ": not found");
  };
  for (const Reference& each : options.references)
    if (!each.picture.image) lost(each.from);
  if (!options.matcapFrom.empty() && !options.look.matcapImage) lost(options.matcapFrom);
  studioSeen_ = studio;
}

std::vector<Light> Atelier::keptLights() const {
  const Studio& studio = options.look.studio;
  if (studio.turn == 0 && studio.lights == Studio(studio.environment).lights) return {};
  const glm::mat3 turn = turnOf(view);
  std::vector<Light> kept;
  for (std::size_t n = 0; n < studio.lights.size(); ++n) {
    const PlainLight plain = plainLight(studio.lights[n]);
    Light light;
    light.towards = glm::transpose(turn) * towardsInWorld(studio, n, turn);
    light.colour = plain.colour;
    light.intensity = plain.intensity;
    light.softness = plain.softness;
    light.castsShadow = n == 0;
    kept.push_back(light);
  }
  return kept;
}

}  // namespace bozzetto::ui
