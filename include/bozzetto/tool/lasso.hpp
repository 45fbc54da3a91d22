// What an outline drawn in a picture holds of the clay: a prism of parallel rays, or all that it
// hides from an eye.
#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace bozzetto {

enum class LassoRays { fromEye, parallel };

struct Lasso {
  /// Closed, in the picture: x right, y up; at distance 1 from the eye, or world units where rays
  /// are parallel. Where it crosses itself, what is enclosed twice is outside.
  std::vector<glm::dvec2> outline;
  glm::dvec3 eye{0};                     ///< world units; parallel: the picture's origin
  glm::dquat worldFromView{1, 0, 0, 0};  ///< the eye looks along its −z
  LassoRays rays = LassoRays::fromEye;

  /// Where a place in the world appears; nothing is seen behind an eye. O(1).
  bool sees(const glm::dvec3& place, glm::dvec2& at) const;
  /// How much of the clay there it holds: 1 … 0, falling across the outline over two cells of
  /// world units, as the density of a primitive does. O(points of the outline).
  double share(const glm::dvec3& place, double cell) const;

  friend bool operator==(const Lasso&, const Lasso&) = default;
};

/// Throws Error for fewer than three points or more than 10,000, for points on one line, and for
/// numbers that are not finite or no rotation.
void requireValid(const Lasso& lasso);

/// Of all places in a ball: whether the lasso holds none, some or all. Careful: `some` may be said
/// of balls near the outline that are on one side.
enum class Coverage { none, some, all };
Coverage coverageOf(const Lasso& lasso, const glm::dvec3& centre, double radius);

}  // namespace bozzetto
