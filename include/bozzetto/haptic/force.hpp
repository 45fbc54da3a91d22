// The laws of what is felt: the rope, the surface, and how stiff a loop may be at all
// (solid.md §4).
#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <span>

namespace bozzetto::haptic {

/// Greatest stiffness that a device with damping b (N·s/m) renders without adding energy, the loop
/// running every `seconds`: K < 2(b − |B|)/T (Colgate & Schenkel). 0 where there is none.
double passiveStiffness(double deviceDamping, double virtualDamping, double seconds);

struct ForceLimits {
  double stiffness = 1000;  ///< N/m, from passiveStiffness
  double force = 3;         ///< N, what the device can do
};

/// A force cut to a length.
glm::dvec3 limited(const glm::dvec3& force, double most);

/// Rope: F = −k (x − grabbed); k in N/m already holds the paper's factor of the point's mass.
glm::dvec3 ropeForce(const glm::dvec3& device, const glm::dvec3& grabbed, double stiffness,
                     const ForceLimits& limits);

/// Where a grabbed point is between two steps of the clay: linear, one step late, so that forces
/// have no jumps.
class GrabbedPoint {
 public:
  /// A step of the clay put the point there at that time (s).
  void arrive(const glm::dvec3& place, double time);
  glm::dvec3 at(double time) const;
  bool grabbed() const { return count_ > 0; }
  void letGo() { count_ = 0; }

 private:
  glm::dvec3 from_{0}, to_{0};
  double since_ = 0, length_ = 0;
  int count_ = 0;
};

using TouchTriangle = std::array<glm::dvec3, 3>;  ///< counter-clockwise from outside

glm::dvec3 nearestOn(const TouchTriangle& triangle, const glm::dvec3& place);

/// The surface as felt: a proxy stays on the outside while the device goes in (god object).
class SurfaceProxy {
 public:
  struct Touch {
    glm::dvec3 force{0}, proxy{0};
    bool touching = false;
  };
  /// O(triangles), some 5 ns each; no allocation.
  Touch touch(std::span<const TouchTriangle> surface, const glm::dvec3& device, double stiffness,
              const ForceLimits& limits);

 private:
  bool inside_ = false;
};

}  // namespace bozzetto::haptic
