#include "bozzetto/render/camera.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <utility>

#include "bozzetto/base/error.hpp"
#include "render/names.hpp"

namespace bozzetto {
namespace {

// Stage units from the stage's centre to the corners of the clay's box: the lights, shadows and
// floor of the studio are made for models of this size.
constexpr double kRadiusUnits = 1.75;

struct Direction {
  double yaw, pitch;
};

Direction directionOf(Viewpoint viewpoint) {
  constexpr double quarter = std::numbers::pi / 2;
  switch (viewpoint) {
    case Viewpoint::front:
      return {0, 0};
    case Viewpoint::back:
      return {2 * quarter, 0};
    case Viewpoint::left:
      return {-quarter, 0};
    case Viewpoint::right:
      return {quarter, 0};
    case Viewpoint::top:
      return {0, quarter};
    case Viewpoint::bottom:
      return {0, -quarter};
    case Viewpoint::iso:
      return {quarter / 2, std::atan(std::numbers::sqrt2 / 2)};
    case Viewpoint::hero:
      break;
  }
  return {0.42, 0.10};
}

}  // namespace

double support(std::span<const CellBounds> boxes, const glm::dvec3& d) {
  double most = -HUGE_VAL;
  for (const CellBounds& box : boxes) {
    const glm::dvec3 corner(d.x > 0 ? box.high.x : box.low.x, d.y > 0 ? box.high.y : box.low.y,
                            d.z > 0 ? box.high.z : box.low.z);
    most = std::max(most, glm::dot(d, corner));
  }
  return most;
}

namespace {

// The boxes between two slanted planes: distance at which they just fit, and the middle.
struct Fit {
  double distance, middle;
};
Fit fitBetween(std::span<const CellBounds> boxes, const glm::dvec3& side, const glm::dvec3& back,
               double tangent, double slant) {
  const double a = support(boxes, side + back * slant);
  const double b = support(boxes, -side + back * slant);
  return {(a + b) / (2 * tangent), (a - b) / 2};
}

}  // namespace

void CellBounds::add(const CellBounds& other) {
  if (other.empty()) return;
  *this = empty() ? other : CellBounds{glm::min(low, other.low), glm::max(high, other.high)};
}

Stage Stage::around(const CellBounds& bounds) {
  Stage stage;
  if (bounds.empty()) return stage;
  stage.centre = bounds.centre();
  stage.unit = std::max(glm::length(bounds.high - bounds.low) / 2 / kRadiusUnits, 1.0);
  stage.floor = bounds.low.y;
  return stage;
}

glm::dmat3 Camera::worldFromView() const {
  const double sy = std::sin(yaw), cy = std::cos(yaw), sp = std::sin(pitch), cp = std::cos(pitch);
  const glm::dvec3 back(sy * cp, sp, cy * cp), right(cy, 0, -sy), up = glm::cross(back, right);
  const double sr = std::sin(roll), cr = std::cos(roll);
  return {right * cr + up * sr, up * cr - right * sr, back};
}

void Camera::orient(const glm::dmat3& axes) {
  const glm::dvec3& back = axes[2];
  pitch = std::asin(std::clamp(back.y, -1.0, 1.0));
  roll = 0;
  // Straight up or down all of the turn is yaw.
  const bool pole = back.x * back.x + back.z * back.z < 1e-18;
  yaw = pole ? std::atan2(-axes[0].z, axes[0].x) : std::atan2(back.x, back.z);
  if (pole) return;
  const glm::dmat3 level = worldFromView();
  roll = std::atan2(glm::dot(axes[0], level[1]), glm::dot(axes[0], level[0]));
}

glm::dvec3 Camera::eye() const { return target + worldFromView()[2] * distance; }

Viewpoint parseViewpoint(std::string_view name) {
  using enum Viewpoint;
  return parseName<Viewpoint>("view", name,
                              {{"front", front},
                               {"back", back},
                               {"left", left},
                               {"right", right},
                               {"top", top},
                               {"bottom", bottom},
                               {"iso", iso},
                               {"hero", hero}});
}

// For one viewing direction the four sides of the view pyramid are known but for its tip; each
// must pass the boxes' farthest point, which gives the tip in closed form, axis by axis.
Camera framed(std::span<const CellBounds> boxes, const Framing& framing) {
  Camera camera;
  const Direction direction = directionOf(framing.viewpoint);
  camera.yaw = framing.yaw.value_or(direction.yaw);
  camera.pitch = framing.pitch.value_or(direction.pitch);
  camera.projection = framing.projection;
  CellBounds all;
  for (const CellBounds& box : boxes) all.add(box);
  const Stage stage = Stage::around(all);
  if (all.empty()) {
    camera.target = stage.centre;
    camera.distance = 6.2 * stage.unit;
    return camera;
  }
  const glm::dmat3 axes = camera.worldFromView();
  const double tangent = std::tan(camera.fieldOfView / 2) * framing.fill;
  const bool perspective = framing.projection == Projection::perspective;
  const auto fit = [&](int axis, double t) {
    return fitBetween(boxes, axes[axis], axes[2], t, perspective ? t : 0);
  };
  const Fit across = fit(0, tangent * framing.aspect), upwards = fit(1, tangent);
  // Measured from the world's origin along `back`; the target is put level with the centre.
  const double depth = glm::dot(axes[2], all.centre());
  const double tip = std::max(across.distance, upwards.distance);
  camera.target = axes[0] * across.middle + axes[1] * upwards.middle + axes[2] * depth;
  camera.distance = std::max(perspective ? tip - depth : tip, stage.unit * 0.5);
  return camera;
}

}  // namespace bozzetto
