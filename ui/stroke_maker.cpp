#include "ui/stroke_maker.hpp"

#include <glm/geometric.hpp>

namespace bozzetto::ui {

glm::dvec2 Rope::pull(glm::dvec2 hand) {
  const glm::dvec2 way = hand - end_;
  const double distance = glm::length(way);
  if (distance > length_) end_ += way * ((distance - length_) / distance);
  return end_;
}

StrokeMaker::StrokeMaker(PatchSet ground, const SculptState& state, const Setting& setting)
    : ground_(std::move(ground)), state_(state), setting_(setting) {}

std::optional<GroundHit> StrokeMaker::hit(const Ray& ray) const {
  return groundUnder(ground_, ray, setting_.spacing);
}

std::optional<StrokePoint> StrokeMaker::begin(glm::dvec2 pixel, double pressure) {
  const Ray ray = rayThrough(setting_.view, setting_.extent, pixel);
  const auto found = hit(ray);
  onClay_ = found.has_value();
  if (!onClay_ && !state_.air) return std::nullopt;
  start_ = found.value_or(
      GroundHit{onFacingPlane(setting_.view, ray, setting_.airPoint), setting_.view.back()});
  depthPoint_ = start_.position;
  if (onClay_ && setting_.pressOn) press_ = setting_.pressOn(start_);
  if (state_.steady) rope_.emplace(pixel, state_.rope);
  return pointAt(pixel, pressure);
}

std::optional<StrokePoint> StrokeMaker::move(glm::dvec2 pixel, double pressure) {
  if (rope_) {
    const glm::dvec2 before = rope_->end();
    pixel = rope_->pull(pixel);
    if (pixel == before) return std::nullopt;
  }
  return pointAt(pixel, pressure);
}

glm::dvec3 StrokeMaker::pressed(const Ray& ray, const GroundHit& ground, double pressure) const {
  const glm::dvec3 normal = broadNormal(ground_, ray, ground, press_->radius(), setting_.spacing);
  return press_->lift(normal, pressure);
}

// On the clay; beside it, at the depth where the clay was last. A tool that pushes keeps its
// distance there too, and does not turn in behind a rim.
StrokePoint StrokeMaker::pointAt(glm::dvec2 pixel, double pressure) {
  const Ray ray = rayThrough(setting_.view, setting_.extent, pixel);
  const auto found = onClay_ ? hit(ray) : std::nullopt;
  const double felt = state_.curve(pressure);
  if (found) {
    depthPoint_ = found->position;
    if (press_) lift_ = pressed(ray, *found, felt);
    last_ = found->position + found->normal * (state_.depth * state_.size) + lift_;
  } else {
    last_ = onFacingPlane(setting_.view, ray, depthPoint_) + lift_;
  }
  return {last_, felt};
}

std::optional<glm::dvec2> StrokeMaker::ropeEnd() const {
  if (!rope_) return std::nullopt;
  return rope_->end();
}

}  // namespace bozzetto::ui
