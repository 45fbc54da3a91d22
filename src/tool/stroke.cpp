#include "bozzetto/tool/stroke.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "bozzetto/base/text.hpp"
#include "bozzetto/tool/relative.hpp"
#include "tool/conserving_stamp.hpp"
#include "tool/freeform.hpp"
#include "tool/placer.hpp"
#include "tool/swept.hpp"

namespace bozzetto {
void requireValid(const Stroke& stroke) {
  const std::size_t points = stroke.points.size(), rotations = stroke.rotations.size();
  if (points == 0) throw Error("stroke: no points found, at least one expected");
  if (rotations != 0 && rotations != points) {
    throw Error("stroke: " + std::to_string(rotations) + " rotations found, " +
                std::to_string(points) + " expected, one a point");
  }
  if (!(stroke.spacing > 0) || !std::isfinite(stroke.spacing)) {
    throw Error("stroke spacing: " + numberText(stroke.spacing) +
                " found, a number above 0 expected");
  }
  requireValid(stroke.symmetry);
  requireValid(stroke.placement);
}

namespace {

// Blocks of a report, before those listed twice are thrown out.
constexpr std::size_t kMostListed = std::size_t{1} << 17;

double smallest(const glm::dvec3& radii) { return std::min({radii.x, radii.y, radii.z}); }

// What a sculpture may be scaled by and still be sampled.
double smallestFactor(const ToolShape& tool) {
  return std::min(1.0, minification(*tool.sculpture, tool.radii) / kMostMinified);
}

// The clay as it is before the stroke, where dabs ask for it.
template <int Side>
Field<Side> facedBy(const Stroke& stroke, const Edit<CornerBlock<Side>>& edit,
                    const FieldScale& scale) {
  Field<Side> field{{}, scale};
  if (stroke.placement.toNormal) field.tree = edit.tree();
  return field;
}

}  // namespace

template <int Side>
StrokeRunner<Side>::StrokeRunner(Edit<CornerBlock<Side>>& edit, const FieldScale& scale,
                                 const ToolShape& tool, const ActionOptions& action,
                                 const Stroke& stroke)
    : StrokeRunner(edit, facedBy(stroke, edit, scale), tool, action, stroke) {}

template <int Side>
StrokeRunner<Side>::StrokeRunner(Edit<CornerBlock<Side>>& edit, const Field<Side>& faced,
                                 const ToolShape& tool, const ActionOptions& action,
                                 const Stroke& stroke)
    : edit_(&edit),
      scale_(faced.scale),
      walker_(edit),
      options_(action),
      pressure_(stroke.pressure) {
  requireValid(stroke);
  const FieldScale& scale = scale_;
  const FittedTool fitted = fitTool(tool, scale.spacing);
  tool_ = fitted.shape;
  tool_.radii /= scale.spacing;
  notice_ = fitted.notice;
  origin_ = cellOf(stroke.points.front().position, scale.spacing, "stroke point");
  images_ = imagesOf(stroke.symmetry);
  centre_ = relativeTo(origin_, stroke.symmetry.centre, scale.spacing);
  const Repeats repeats{origin_, centre_, turnsOf(stroke.symmetry, images_)};
  placer_ = std::make_unique<Placer<Side>>(stroke.placement, tool_, faced, repeats);

  potential_ = potentialOf(tool_);
  options_.ownColours = options_.ownColours && potential_->coloured();
  const bool sculpted = tool.shape == Shape::freeform;
  action_ = makeAction(options_, scale.iso, sculpted ? ToolBody::sculpture : ToolBody::potential);
  path_.emplace(relative(stroke.points), stroke.spacing * smallest(tool_.radii));
  count_ = countOf(*path_);
}

template <int Side>
StrokeRunner<Side>::~StrokeRunner() = default;

template <int Side>
std::unique_ptr<Potential> StrokeRunner<Side>::potentialOf(const ToolShape& tool) const {
  if (options_.kind != ActionKind::stamp) return makePotential(tool);
  return makeStampPotential(tool, options_.stamp, scale_.iso, placer_->facing());
}

template <int Side>
std::int64_t StrokeRunner<Side>::sureDabs() const {
  return placer_->sureOf(path_->sure());
}

template <int Side>
std::string StrokeRunner<Side>::placementNotice() const {
  return placer_->notice(*path_);
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
    cellOf(point.position, scale_.spacing, "stroke point");
    if (!(point.pressure >= 0 && point.pressure <= 1)) {
      throw Error("stroke pressure: " + numberText(point.pressure) +
                  " found, a number in 0…1 expected");
    }
    samples.push_back({relativeTo(origin_, point.position, scale_.spacing), point.pressure});
  }
  requireRoom(samples);
  return samples;
}

template <int Side>
std::int64_t StrokeRunner<Side>::countOf(const StrokePath& path) const {
  const double count = path.count();
  const std::size_t images = images_.size() * placer_->copies().size();
  if (!(count * static_cast<double>(images) <= static_cast<double>(kMostDabs))) {
    throw Error("stroke: " + numberText(count) + " dabs × " + std::to_string(images) +
                " images found, at most 10 million expected");
  }
  return placer_->countOf(static_cast<std::int64_t>(count));
}

// Dabs between points lie between their boxes.
template <int Side>
void StrokeRunner<Side>::requireRoom(const std::vector<StrokePath::Sample>& points) const {
  for (const StrokePath::Sample& point : points)
    for (const DabPose& pose : posesOf({point.position, glm::mat3_cast(tool_.rotation)}))
      dabBox(influenceOf(*potential_, pose));
}

template <int Side>
ToolShape StrokeRunner<Side>::sized(double factor) const {
  ToolShape shape = tool_;
  if (factor == 1) return shape;
  if (shape.shape == Shape::freeform) {
    shape.radii *= std::max(factor, smallestFactor(tool_));
  } else {
    shape.radii = glm::max(tool_.radii * factor, kSmallestToolCells);
  }
  return shape;
}

// The dab, its copies and their images.
template <int Side>
std::vector<DabPose> StrokeRunner<Side>::posesOf(const Standing& standing) const {
  const glm::dvec3 radii = sized(standing.factor).radii;
  const bool prints = options_.kind == ActionKind::stamp && placer_->facing() && tool_.sculpture;
  const double deep = prints ? printDepth(*tool_.sculpture, radii) : 0;
  const auto poseAt = [&](const glm::dvec3& position, const glm::dmat3& orientation) {
    DabPose pose{origin_, position, orientation, radii};
    if (tool_.shape == Shape::freeform) putOnPivot(*tool_.sculpture, pose);
    if (deep > 0) pose.position += deep * (orientation * tool_.sculpture->contact());
    return pose;
  };
  std::vector<DabPose> poses;
  const auto addImages = [&](const DabPose& pose, const std::vector<glm::dmat3>& images) {
    const auto made = imagesOf(pose, tool_.shape, images, centre_);
    poses.insert(poses.end(), made.begin(), made.end());
  };
  for (std::size_t n = 0; n < standing.each.size(); ++n) {
    const Stance& stance = standing.each[n];
    addImages(poseAt(stance.position, stance.orientation), {images_[n % images_.size()]});
  }
  if (!poses.empty()) return withoutTwins(poses, tool_.shape);
  for (const glm::dvec3& copy : placer_->copies())
    addImages(poseAt(standing.position + copy, standing.orientation), images_);
  return poses;
}

template <int Side>
void StrokeRunner<Side>::makeDab(const Standing& standing, double strength, DabReport& report) {
  if (standing.factor != factor_) {
    potential_ = potentialOf(sized(standing.factor));
    factor_ = standing.factor;
  }
  const bool conserving = options_.kind == ActionKind::stamp && options_.stamp.conserving;
  const ToolShape tool = sized(standing.factor);
  Swept<Side>* const swept = action_->wantsBody() ? &swept_ : nullptr;
  for (const DabPose& pose : posesOf(standing)) {
    if (conserving) {
      const StampOptions bulge = clamped(options_.stamp, scale_.iso);
      const bool facing = placer_->facing();
      ConservingStamp<Side>(*edit_, {pose, tool, bulge, scale_.iso, strength, swept, facing})
          .apply(report);
    } else {
      walker_.apply({pose, potential_.get(), action_.get(), static_cast<float>(strength), swept},
                    report);
    }
  }
}

template <int Side>
DabReport StrokeRunner<Side>::dab(std::int64_t n) {
  DabReport report;
  const double pressure = path_->at(n).pressure;
  const double strength = pressure_.strength ? options_.strength * pressure : options_.strength;
  if (strength <= 0 || (pressure_.size && pressure <= 0)) return report;
  try {
    Standing standing = placer_->at(*path_, n);
    if (standing.skipped) return report;
    if (pressure_.size) standing.factor *= pressure;
    makeDab(standing, strength, report);
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
