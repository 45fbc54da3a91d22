// What a tool is before it is used: a shape, a profile, radii and a rotation (Ferley §4.1).
#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace bozzetto {

/// Each fills the box of its radii; its own axes are x, y, z before the rotation.
///   box       rounded by a quarter of its smallest radius (as a tool; sharp as a primitive)
///   cylinder  elliptic about y, flat ends: [x radius, half height, z radius]
///   capsule   elliptic about y, its caps inside the half height and √(rx·rz) high where there is
///             room
///   freeform  a sculpture (Ferley §4.1.2); tools only
enum class Shape { ellipsoid, box, cylinder, capsule, freeform };

/// How the potential falls from 1 at the core to 0 at the limit of influence; u is the shape's
/// gauge: 0 at the centre, 1 on the limit, proportional along every ray.
///   wyvill  1 − 4/9·u⁶ + 17/9·u⁴ − 22/9·u², ½ at u = ½
///   box     1 up to u = 0.7, then a C¹ cubic fall
enum class Profile { wyvill, box };

std::string_view toText(Shape shape);
std::string_view toText(Profile profile);
std::optional<Shape> shapeNamed(std::string_view name);
std::optional<Profile> profileNamed(std::string_view name);

class Sculpture;

struct ToolShape {
  Shape shape = Shape::ellipsoid;
  Profile profile = Profile::wyvill;
  glm::dvec3 radii{8, 8, 8};        ///< world units: the limit of influence
  glm::dquat rotation{1, 0, 0, 0};  ///< w, x, y, z; any length but zero

  /// Of freeform tools; their radii follow from it and from `scale`, along the tool's own axes.
  std::shared_ptr<const Sculpture> sculpture{};
  glm::dvec3 scale{1, 1, 1};
};

/// The world radii of a freeform tool: half its bounds and one of its cells, scaled.
glm::dvec3 freeformRadii(const Sculpture& sculpture, const glm::dvec3& scale);

/// Narrower tools are not sampled properly by the grid (Ferley §6); wider ones are mistakes.
inline constexpr double kSmallestToolCells = 2, kLargestToolCells = 4096;
/// Corners in the box of a tool: what a dab may have to write, 8 bytes each.
inline constexpr double kMostToolCorners = 1 << 29;

/// A tool as it can be used on a grid.
struct FittedTool {
  ToolShape shape;     ///< radii still in world units, rotation of length 1
  std::string notice;  ///< what was changed and why; empty when nothing was
};

/// What can be said without a grid. Throws Error for radii (of freeform tools: scales) that are not
/// finite or not above 0, and for rotations that cannot be normalised.
void requireValid(const ToolShape& shape);

/// Widens radii under two cells of `spacing` to two and says so. Throws Error for what requireValid
/// refuses, for radii beyond 4096 cells and for boxes of more than 2²⁹ corners. Freeform tools are
/// not widened: their thin parts are pre-filtered; refused are those that would shrink to a 256th.
FittedTool fitTool(const ToolShape& shape, double spacing);

/// The rotation with length 1. Throws Error when it has none.
glm::dquat normalisedRotation(const glm::dquat& rotation);

}  // namespace bozzetto
