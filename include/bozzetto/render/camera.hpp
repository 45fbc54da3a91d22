// Where the eye stands. The lights go with it: the studio is fixed to the camera.
#pragma once
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>

namespace bozzetto {

/// An axis-aligned box in cells; empty when low exceeds high.
struct CellBounds {
  glm::dvec3 low{1}, high{0};

  bool empty() const { return low.x > high.x; }
  void add(const CellBounds& other);
  glm::dvec3 centre() const { return (low + high) * 0.5; }
};

/// The studio's scale: half a model, roughly, is one stage unit.
struct Stage {
  glm::dvec3 centre{0};  ///< cells
  double unit = 32;      ///< cells
  double floor = -32;    ///< height of the floor, cells
  friend bool operator==(const Stage&, const Stage&) = default;

  /// The stage for clay in `bounds`; the default one when they are empty.
  static Stage around(const CellBounds& bounds);
};

enum class Projection { perspective, orthographic };

struct Camera {
  glm::dvec3 target{0};            ///< cells
  double yaw = 0;                  ///< radians; 0 looks from +z, positive from the right
  double pitch = 0;                ///< radians; positive looks from above
  double roll = 0;                 ///< radians; positive turns the camera to the left
  double distance = 200;           ///< from the target, cells
  double fieldOfView = 0.4537856;  ///< vertical, radians: 26°, a portrait lens
  Projection projection = Projection::perspective;

  /// Columns: right, up, towards the viewer.
  glm::dmat3 worldFromView() const;
  glm::dvec3 eye() const;
  /// Sets yaw, pitch and roll from such axes (a rotation).
  void orient(const glm::dmat3& worldFromView);
  friend bool operator==(const Camera&, const Camera&) = default;
};

/// Where a picture is taken from. `hero` is the three-quarter view from a little above.
enum class Viewpoint { hero, front, back, left, right, top, bottom, iso };

/// The name on the command line → viewpoint. Throws Error naming the choices.
Viewpoint parseViewpoint(std::string_view name);

struct Framing {
  Viewpoint viewpoint = Viewpoint::hero;
  Projection projection = Projection::perspective;
  double aspect = 4.0 / 3.0;  ///< width / height
  double fill = 0.86;         ///< part of the picture's width or height that the clay takes
  std::optional<double> yaw = {}, pitch = {};  ///< instead of the viewpoint's, radians
};

/// How far the corners of all boxes reach in the direction `d`: max of dot(d, corner). O(boxes).
double support(std::span<const CellBounds> boxes, const glm::dvec3& d);

/// A camera that shows all boxes as large as `fill` allows. O(boxes).
Camera framed(std::span<const CellBounds> boxes, const Framing& framing);

}  // namespace bozzetto
