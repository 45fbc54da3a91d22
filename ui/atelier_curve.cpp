// The curve tool of solid mode: points picked on the surface, a cubic B-spline through them, its
// control points dragged (McDonnell & Qin §6.4).
#include <algorithm>
#include <glm/geometric.hpp>

#include "ui/atelier.hpp"

namespace bozzetto::ui {
namespace {

constexpr double kHandlePixels = 11;

}  // namespace

std::vector<glm::dvec3> Atelier::curvePlaces() const {
  std::vector<glm::dvec3> places;
  if (!solidShown_) return places;
  for (const Id n : curve_.points) places.push_back(solidShown_->mass.points[n]);
  return places;
}

std::vector<glm::dvec3> Atelier::curveControls() const {
  const bool dragged = gesture_ == Gesture::solid && curve_.handle;
  auto controls = splineThrough(dragged ? curveStart_ : curvePlaces());
  if (dragged) controls[*curve_.handle] += dragged_ - solidHit_.place;
  return controls;
}

void Atelier::hoverCurve() {
  const auto controls = curveControls();
  double least = kHandlePixels * scale_;
  for (std::size_t n = 0; n < controls.size(); ++n) {
    const double distance = glm::distance(pixelOf(view, extent_, controls[n]), pointer_);
    if (distance >= least) continue;
    least = distance;
    curve_.handle = n;
  }
}

// A control is dragged, or taken out; anywhere else on the surface the curve gets a point.
bool Atelier::beginCurve() {
  const bool takesOut = heldMeaning() == Held::invert;
  if (curve_.handle && takesOut) {
    curve_.points.erase(curve_.points.begin() + std::ptrdiff_t(*curve_.handle));
    curve_.handle.reset();
    return false;
  }
  if (curve_.handle && curve_.points.size() > 1) {
    curveStart_ = curvePlaces();
    const auto controls = splineThrough(curveStart_);
    solidHit_ = {curve_.points[*curve_.handle], controls[*curve_.handle]};
    dragged_ = handTo_ = solidHit_.place;
    return true;
  }
  const bool known = std::ranges::find(curve_.points, solidHit_.element) != curve_.points.end();
  if (solidHit_.element == kNoId || known || takesOut) return false;
  curve_.points.push_back(solidHit_.element);
  curve_.of = solidShown_->mass.points.size();
  return false;
}

// It goes with the points it runs through.
void Atelier::keepCurve() {
  if (!solidShown_ || solidShown_->mass.points.size() != curve_.of) dropCurve();
}

void Atelier::dropCurve() { curve_ = {}; }

}  // namespace bozzetto::ui
