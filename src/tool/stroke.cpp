#include "bozzetto/tool/stroke.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "bozzetto/tool/relative.hpp"
#include "tool/freeform.hpp"

namespace bozzetto {
namespace {

void requireValid(const Stroke& stroke) {
  if (stroke.points.empty()) throw Error("stroke: no points found, at least one expected");
  if (!(stroke.spacing > 0) || !std::isfinite(stroke.spacing)) {
    throw Error("stroke spacing: " + std::to_string(stroke.spacing) +
                " found, a number above 0 expected");
  }
  requireValid(stroke.symmetry);
}

// Blocks of a report, before those listed twice are thrown out.
constexpr std::size_t kMostListed = std::size_t{1} << 17;

double smallest(const glm::dvec3& radii) { return std::min({radii.x, radii.y, radii.z}); }

// What a sculpture may be scaled by and still be sampled.
double smallestFactor(const ToolShape& tool) {
  return std::min(1.0, minification(*tool.sculpture, tool.radii) / kMostMinified);
}

}  // namespace

template <int Side>
StrokeRunner<Side>::StrokeRunner(Edit<CornerBlock<Side>>& edit, const FieldScale& scale,
                                 const ToolShape& tool, const ActionOptions& action,
                                 const Stroke& stroke)
    : edit_(&edit),
      spacing_(scale.spacing),
      walker_(edit),
      strength_(action.strength),
      pressure_(stroke.pressure) {
  requireValid(stroke);
  const FittedTool fitted = fitTool(tool, scale.spacing);
  tool_ = fitted.shape;
  tool_.radii /= scale.spacing;
  notice_ = fitted.notice;
  potential_ = makePotential(tool_);
  ActionOptions options = action;
  options.ownColours = options.ownColours && potential_->coloured();
  action_ = makeAction(options);

  origin_ = cellOf(stroke.points.front().position, scale.spacing, "stroke point");
  images_ = imagesOf(stroke.symmetry);
  centre_ = relativeTo(origin_, stroke.symmetry.centre, scale.spacing);
  path_.emplace(relative(stroke.points), stroke.spacing * smallest(tool_.radii));
  count_ = countOf(*path_);
}

template <int Side>
void StrokeRunner<Side>::extend(std::span<const StrokePoint> points) {
  const std::size_t before = path_->pointCount();
  for (const StrokePath::Sample& point : relative(points)) path_->append(point);
  try {
    count_ = countOf(*path_);
  } catch (...) {
    path_->shorten(before);
    throw;
  }
}

// In cells from the origin; all dabs there have room.
template <int Side>
std::vector<StrokePath::Sample> StrokeRunner<Side>::relative(
    std::span<const StrokePoint> points) const {
  std::vector<StrokePath::Sample> samples;
  for (const StrokePoint& point : points) {
    cellOf(point.position, spacing_, "stroke point");
    if (!(point.pressure >= 0 && point.pressure <= 1)) {
      throw Error("stroke pressure: " + std::to_string(point.pressure) +
                  " found, a number in 0…1 expected");
    }
    samples.push_back({relativeTo(origin_, point.position, spacing_), point.pressure});
  }
  requireRoom(samples);
  return samples;
}

template <int Side>
std::int64_t StrokeRunner<Side>::countOf(const StrokePath& path) const {
  const double count = path.count();
  if (!(count * static_cast<double>(images_.size()) <= static_cast<double>(kMostDabs))) {
    throw Error("stroke: " + std::to_string(count) + " dabs × " + std::to_string(images_.size()) +
                " images found, at most 10 million expected");
  }
  return static_cast<std::int64_t>(count);
}

// Dabs between points lie between their boxes.
template <int Side>
void StrokeRunner<Side>::requireRoom(const std::vector<StrokePath::Sample>& points) const {
  for (const StrokePath::Sample& point : points)
    for (const DabPose& pose : imagesOf(poseAt({point.position, 1}), tool_.shape, images_, centre_))
      dabBox(influenceOf(*potential_, pose));
}

template <int Side>
ToolShape StrokeRunner<Side>::sized(double pressure) const {
  ToolShape shape = tool_;
  if (!pressure_.size) return shape;
  if (shape.shape == Shape::freeform) {
    shape.radii *= std::max(pressure, smallestFactor(tool_));
  } else {
    shape.radii = glm::max(tool_.radii * pressure, kSmallestToolCells);
  }
  return shape;
}

template <int Side>
DabPose StrokeRunner<Side>::poseAt(const StrokePath::Sample& sample) const {
  DabPose pose{origin_, sample.position, glm::mat3_cast(tool_.rotation),
               sized(sample.pressure).radii};
  if (tool_.shape == Shape::freeform) putOnPivot(*tool_.sculpture, pose);
  return pose;
}

template <int Side>
DabReport StrokeRunner<Side>::dab(std::int64_t n) {
  DabReport report;
  const StrokePath::Sample sample = path_->at(n);
  const double strength = pressure_.strength ? strength_ * sample.pressure : strength_;
  if (strength <= 0 || (pressure_.size && sample.pressure <= 0)) return report;
  if (pressure_.size) potential_ = makePotential(sized(sample.pressure));
  try {
    for (const DabPose& pose : imagesOf(poseAt(sample), tool_.shape, images_, centre_)) {
      walker_.apply({pose, potential_.get(), action_.get(), static_cast<float>(strength)}, report);
    }
  } catch (...) {
    edit_->rollback();
    throw;
  }
  return report;
}

template <int Side>
void StrokeRunner<Side>::step(Progress& progress, std::int64_t n) {
  try {
    progress.step("stroke", static_cast<double>(n + 1) / static_cast<double>(count_));
  } catch (...) {
    edit_->rollback();
    throw;
  }
}

template class StrokeRunner<1>;
template class StrokeRunner<8>;

template <int Side>
StrokeReport applyStroke(StrokeRunner<Side>& runner, Progress& progress) {
  StrokeReport report{runner.dabCount(), {}, runner.notice()};
  for (std::int64_t n = 0; n < report.dabs; ++n) {
    report.total.add(runner.dab(n));
    auto& changed = report.total.changed;
    if (changed.size() > kMostListed) changed = sortedOnce(std::move(changed));
    runner.step(progress, n);
  }
  report.total.changed = sortedOnce(std::move(report.total.changed));
  return report;
}

template StrokeReport applyStroke(StrokeRunner<1>&, Progress&);
template StrokeReport applyStroke(StrokeRunner<8>&, Progress&);

}  // namespace bozzetto
