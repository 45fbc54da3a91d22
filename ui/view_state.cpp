#include "ui/view_state.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <utility>

namespace bozzetto::ui {
namespace {

constexpr double kQuarter = std::numbers::pi / 2;
constexpr double kTurnPerHeight = std::numbers::pi * 1.1;  // radians for a drag of one height
constexpr double kTogether = 0.7;                          // seconds between moves that are one
constexpr std::size_t kMostViews = 200;

glm::dmat3 axesOf(const ViewState& view) { return glm::mat3_cast(view.worldFromView); }

double halfHeight(const ViewState& view) { return std::tan(view.fieldOfView / 2); }

// Bell's trackball: a sphere in the middle, a hyperbola outside, smooth between.
glm::dvec3 onBall(const Extent& extent, glm::dvec2 pixel) {
  const double x = (2 * pixel.x - extent.width) / extent.height;
  const double y = 1 - 2 * pixel.y / extent.height;
  const double square = x * x + y * y;
  return glm::normalize(
      glm::dvec3(x, y, square < .5 ? std::sqrt(1 - square) : .5 / std::sqrt(square)));
}

void orbitTrackball(ViewState& view, const Extent& extent, glm::dvec2 from, glm::dvec2 to) {
  const glm::dvec3 a = onBall(extent, from), b = onBall(extent, to);
  const glm::dvec3 axis = glm::cross(a, b);
  const double length = glm::length(axis);
  if (length < 1e-12) return;
  // Twice the angle between the points, as with any trackball.
  const double angle = 2 * std::atan2(length, glm::dot(a, b));
  const glm::dquat turn = glm::angleAxis(-angle, axis / length);
  view.worldFromView = glm::normalize(view.worldFromView * turn);
}

}  // namespace

void ViewState::turnTo(double yaw, double pitch) {
  worldFromView =
      glm::angleAxis(yaw, glm::dvec3(0, 1, 0)) * glm::angleAxis(-pitch, glm::dvec3(1, 0, 0));
}

Camera cameraOf(const ViewState& view, double spacing) {
  Camera camera;
  camera.target = view.target / spacing;
  camera.distance = view.distance / spacing;
  camera.fieldOfView = view.fieldOfView;
  camera.projection = view.projection;
  const glm::dvec3 back = view.back();
  camera.pitch = std::asin(std::clamp(back.y, -1.0, 1.0));
  camera.yaw = std::hypot(back.x, back.z) < 1e-9 ? 0 : std::atan2(back.x, back.z);
  camera.roll = 0;
  const glm::dmat3 level = camera.worldFromView();
  camera.roll = std::atan2(glm::dot(view.right(), level[1]), glm::dot(view.right(), level[0]));
  return camera;
}

SceneCamera sceneCameraOf(const ViewState& view) {
  SceneCamera camera;
  camera.target = view.target;
  camera.worldFromCamera = view.worldFromView;
  camera.distance = view.distance;
  camera.fieldOfView = view.fieldOfView * 90 / kQuarter;
  camera.projection = view.projection == Projection::perspective ? SceneProjection::perspective
                                                                 : SceneProjection::orthographic;
  return camera;
}

ViewState viewOf(const SceneCamera& camera) {
  ViewState view;
  view.target = camera.target;
  view.worldFromView = glm::normalize(camera.worldFromCamera);
  view.distance = camera.distance;
  view.fieldOfView = camera.fieldOfView * kQuarter / 90;
  view.projection = camera.projection == SceneProjection::perspective ? Projection::perspective
                                                                      : Projection::orthographic;
  return view;
}

Ray rayThrough(const ViewState& view, const Extent& extent, glm::dvec2 pixel) {
  const double x = (2 * pixel.x / extent.width - 1) * halfHeight(view) * extent.aspect();
  const double y = (1 - 2 * pixel.y / extent.height) * halfHeight(view);
  const glm::dmat3 axes = axesOf(view);
  if (view.projection == Projection::perspective) {
    return {view.eye(), glm::normalize(axes[0] * x + axes[1] * y - axes[2])};
  }
  return {view.eye() + (axes[0] * x + axes[1] * y) * view.distance, -axes[2]};
}

glm::dvec2 pixelOf(const ViewState& view, const Extent& extent, const glm::dvec3& point) {
  const glm::dvec3 seen = glm::transpose(axesOf(view)) * (point - view.target);
  const bool perspective = view.projection == Projection::perspective;
  const double depth = perspective ? view.distance - seen.z : view.distance;
  const double scale = extent.height / 2 / (halfHeight(view) * depth);
  return {extent.width / 2 + seen.x * scale, extent.height / 2 - seen.y * scale};
}

double unitsPerPixel(const ViewState& view, const Extent& extent, const glm::dvec3& at) {
  const bool perspective = view.projection == Projection::perspective;
  const double depth = perspective ? glm::dot(view.eye() - at, view.back()) : view.distance;
  return std::max(depth, 1e-9) * 2 * halfHeight(view) / extent.height;
}

glm::dvec3 onFacingPlane(const ViewState& view, const Ray& ray, const glm::dvec3& at) {
  const double along = glm::dot(at - ray.origin, view.back());
  return ray.origin + ray.direction * (along / glm::dot(ray.direction, view.back()));
}

void orbit(ViewState& view, const Extent& extent, glm::dvec2 from, glm::dvec2 to,
           OrbitStyle style) {
  if (style == OrbitStyle::trackball) return orbitTrackball(view, extent, from, to);
  const glm::dvec2 turn = (to - from) * (kTurnPerHeight / extent.height);
  view.worldFromView =
      glm::normalize(glm::angleAxis(-turn.x, glm::dvec3(0, 1, 0)) * view.worldFromView *
                     glm::angleAxis(-turn.y, glm::dvec3(1, 0, 0)));
}

void pan(ViewState& view, const Extent& extent, glm::dvec2 pixels) {
  const double scale = unitsPerPixel(view, extent, view.target);
  view.target += (view.up() * pixels.y - view.right() * pixels.x) * scale;
}

void zoom(ViewState& view, const Extent& extent, double notches, glm::dvec2 pixel) {
  const glm::dvec3 at = onFacingPlane(view, rayThrough(view, extent, pixel), view.target);
  const double factor = std::pow(0.88, notches);
  view.distance = std::clamp(view.distance * factor, 1e-6, 1e12);
  view.target = at + (view.target - at) * factor;
}

// Each side of the view pyramid must pass the farthest corner: its tip follows, axis by axis.
void frame(ViewState& view, std::span<const CellBounds> boxes, double aspect, double fill) {
  if (boxes.empty()) return;
  const glm::dmat3 axes = axesOf(view);
  const bool perspective = view.projection == Projection::perspective;
  const double tangent = halfHeight(view) * fill;
  CellBounds all;
  for (const CellBounds& box : boxes) all.add(box);
  const double depth = glm::dot(axes[2], all.centre());
  double tip = 0, middle[2] = {};
  for (int axis = 0; axis < 2; ++axis) {
    const double t = axis == 0 ? tangent * aspect : tangent, slant = perspective ? t : 0;
    const double a = support(boxes, axes[axis] + axes[2] * slant);
    const double b = support(boxes, -axes[axis] + axes[2] * slant);
    const double distance = (a + b) / (2 * t) - (perspective ? depth : 0);
    tip = std::max(tip, distance);
    middle[axis] = (a - b) / 2;
  }
  view.target = axes[0] * middle[0] + axes[1] * middle[1] + axes[2] * depth;
  view.distance = std::max(tip, 1e-6);
}

void ViewHistory::moved(const Sight& before, double seconds) {
  if (seconds - last_ > kTogether) {
    past_.push_back(before);
    if (past_.size() > kMostViews) past_.erase(past_.begin());
  }
  future_.clear();
  last_ = seconds;
}

bool ViewHistory::undo(Sight& sight) {
  if (past_.empty()) return false;
  future_.push_back(std::exchange(sight, past_.back()));
  past_.pop_back();
  last_ = -1e9;
  return true;
}

bool ViewHistory::redo(Sight& sight) {
  if (future_.empty()) return false;
  past_.push_back(std::exchange(sight, future_.back()));
  future_.pop_back();
  last_ = -1e9;
  return true;
}

}  // namespace bozzetto::ui
