// The way of a tool, position and rotation, in steps of equal length: what clay does must not
// depend on how often the pointer was asked (clay.md §3.0).
#pragma once
#include <glm/gtc/quaternion.hpp>
#include <vector>

namespace bozzetto::clay {

struct Pose {
  glm::dvec3 position{0};  ///< cells from the stroke's origin
  glm::dquat rotation{1, 0, 0, 0};
  double size = 1;  ///< of the tool, × its radii
};

class PosePath {
 public:
  /// Steps of `step` cells of the fastest point of a tool of this radius; the last may be shorter.
  PosePath(const std::vector<Pose>& poses, double radius, double step);
  void append(const Pose& pose);
  const glm::dquat& lastRotation() const { return poses_.back().rotation; }
  /// Steps after the first pose, as a double because it may be absurd.
  double count() const;
  /// How many of these stay as they are however the way goes on.
  double sure() const;
  /// The pose after `steps` steps, a fraction too; rounded so that more points on the same way
  /// change no bit.
  Pose at(double steps) const;

 private:
  std::vector<Pose> poses_;
  std::vector<double> distance_;
  double radius_, step_;
};

}  // namespace bozzetto::clay
