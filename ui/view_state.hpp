// From where the sculptor looks, and how dragging changes that. Pure: no OpenGL, no window. World
// units; pixels count from the viewport's top left corner.
#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "bozzetto/render/camera.hpp"
#include "bozzetto/render/studio.hpp"
#include "bozzetto/scene/view.hpp"

namespace bozzetto::ui {

struct Ray {
  glm::dvec3 origin{0}, direction{0, 0, -1};  ///< direction has length 1
};

enum class OrbitStyle { turntable, trackball };

struct ViewState {
  glm::dvec3 target{0};
  glm::dquat worldFromView{1, 0, 0, 0};
  double distance = 200;
  double fieldOfView = 0.4537856;  ///< vertical, radians
  Projection projection = Projection::perspective;

  friend bool operator==(const ViewState&, const ViewState&) = default;

  glm::dvec3 right() const { return worldFromView * glm::dvec3(1, 0, 0); }
  glm::dvec3 up() const { return worldFromView * glm::dvec3(0, 1, 0); }
  glm::dvec3 back() const { return worldFromView * glm::dvec3(0, 0, 1); }
  glm::dvec3 eye() const { return target + back() * distance; }

  /// Turns so that yaw and pitch are these (radians, as in Camera), without roll.
  void turnTo(double yaw, double pitch);
};

/// A viewport's size in pixels.
struct Extent {
  double width = 1, height = 1;
  double aspect() const { return width / height; }
};

/// The renderer's camera for it; `spacing` in world units per cell.
Camera cameraOf(const ViewState& view, double spacing);

SceneCamera sceneCameraOf(const ViewState& view);
ViewState viewOf(const SceneCamera& camera);

/// Through a pixel, from the eye (perspective) or the picture's plane.
Ray rayThrough(const ViewState& view, const Extent& extent, glm::dvec2 pixel);
/// Where a point appears, in pixels; behind the eye the numbers mean nothing.
glm::dvec2 pixelOf(const ViewState& view, const Extent& extent, const glm::dvec3& point);
/// World units that a pixel covers at the depth of a point.
double unitsPerPixel(const ViewState& view, const Extent& extent, const glm::dvec3& at);
/// The point of a ray in the plane through `at` that faces the viewer.
glm::dvec3 onFacingPlane(const ViewState& view, const Ray& ray, const glm::dvec3& at);

/// Turns about the target as the pointer goes from one pixel to another.
void orbit(ViewState& view, const Extent& extent, glm::dvec2 from, glm::dvec2 to, OrbitStyle style);
/// What lies at the target's depth follows the pointer.
void pan(ViewState& view, const Extent& extent, glm::dvec2 pixels);
/// Closer by `notches` (each 12 %), towards the point at the target's depth under `pixel`.
void zoom(ViewState& view, const Extent& extent, double notches, glm::dvec2 pixel);
/// Keeps direction and projection; shows all boxes (world units) as large as `fill` allows.
void frame(ViewState& view, std::span<const CellBounds> boxes, double aspect, double fill = 0.86);

/// From where one looks, and in what light.
struct Sight {
  ViewState view;
  Studio studio;
};

/// Sights one has had, separate from the clay's history.
class ViewHistory {
 public:
  /// Remembers what was before it changed; small changes that follow each other are one.
  void moved(const Sight& before, double seconds);
  bool undo(Sight& sight);
  bool redo(Sight& sight);

 private:
  std::vector<Sight> past_, future_;
  double last_ = -1e9;
};

}  // namespace bozzetto::ui
