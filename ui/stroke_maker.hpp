// From the pointer's path to points of a stroke: steadied, given pressure, laid on the clay or
// through the air. Pure: what is under a pixel is asked of whoever calls.
#pragma once
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "ui/press.hpp"

namespace bozzetto::ui {

/// Pulls a point on a rope: it follows only when the rope is tight, so that the hand's tremble is
/// lost and corners stay corners.
class Rope {
 public:
  Rope(glm::dvec2 start, double length) : end_(start), length_(length) {}
  /// Where the end is once the hand is here.
  glm::dvec2 pull(glm::dvec2 hand);
  glm::dvec2 end() const { return end_; }

 private:
  glm::dvec2 end_;
  double length_;
};

/// Lays one stroke. The clay is the one it began on (`ground` is a copy of the patches), so that a
/// stroke does not climb up what it adds.
class StrokeMaker {
 public:
  struct Setting {
    ViewState view;
    Extent extent;
    double spacing = 1;      ///< world units per cell
    glm::dvec3 airPoint{0};  ///< strokes in the air run through the facing plane at this point
    /// Of a stroke that begins there, when it pushes: the tool is led outside what it lies on.
    std::function<std::optional<Press>(const GroundHit&)> pressOn{};
  };

  StrokeMaker(PatchSet ground, const SculptState& state, const Setting& setting);

  /// The stroke's first point; nothing when the pixel is not on clay and air is not allowed.
  std::optional<StrokePoint> begin(glm::dvec2 pixel, double pressure);
  /// The next point; nothing while the rope is slack.
  std::optional<StrokePoint> move(glm::dvec2 pixel, double pressure);

  /// What the first point lay on; its normal faces the viewer in the air.
  const GroundHit& start() const { return start_; }
  bool onClay() const { return onClay_; }
  /// Where the tool is now, world units.
  const glm::dvec3& last() const { return last_; }
  /// The rope's end in pixels.
  std::optional<glm::dvec2> ropeEnd() const;

 private:
  StrokePoint pointAt(glm::dvec2 pixel, double pressure);
  std::optional<GroundHit> hit(const Ray& ray) const;
  glm::dvec3 pressed(const Ray& ray, const GroundHit& ground, double pressure) const;

  PatchSet ground_;
  const SculptState state_;
  Setting setting_;
  GroundHit start_;
  bool onClay_ = false;
  std::optional<Press> press_;
  glm::dvec3 last_{0}, depthPoint_{0}, lift_{0};
  std::optional<Rope> rope_;
};

}  // namespace bozzetto::ui
