// How a tool that pushes meets the clay: from outside, and in by a share of its radius. Pure.
#pragma once
#include "ui/patch_set.hpp"
#include "ui/sculpt_state.hpp"

namespace bozzetto::ui {

/// The clay under a ray in world units, or nothing.
struct GroundHit {
  glm::dvec3 position{0}, normal{0, 1, 0};
};

/// The clay that a ray (world units) meets.
std::optional<GroundHit> groundUnder(const PatchSet& patches, const Ray& ray, double spacing);

/// The mean normal, of length 1, of what lies round a hit within `radius` (world units), as rays
/// beside its own meet it: what a tool of that size lies on. O(blocks along nine rays).
glm::dvec3 broadNormal(const PatchSet& patches, const Ray& ray, const GroundHit& hit, double radius,
                       double spacing);

class Press {
 public:
  /// A tool as it stands, with the state's strength for pushing as the share of its half width by
  /// which it sinks; `spacing` is world units a cell.
  Press(const ToolShape& tool, const SculptState& state, double spacing);
  /// From a point of the surface to where the tool's pivot is led; `pressure` 0…1 is what is left
  /// of the hand's by its curve. World units.
  glm::dvec3 lift(const glm::dvec3& normal, double pressure) const;
  /// The largest, world units.
  double radius() const;

 private:
  ToolShape tool_;
  glm::dvec3 pivot_{0};  // from its middle
  double share_, least_;
  PressureTargets pressure_;
};

}  // namespace bozzetto::ui
