#include "tool/stamp_depth.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "tool/block_rows.hpp"
#include "tool/distance.hpp"
#include "tool/gauge.hpp"
#include "tool/sculpted_grids.hpp"

namespace bozzetto {
namespace {

/// Distance to the tool's surface ÷ its reference radius, of corners outside; inside anything ≥ 0.
class Outside {
 public:
  virtual ~Outside() = default;
  virtual void evaluate(const LocalFrame& frame, Key first, int side, float* distance) const = 0;
};

template <class Distance>
struct DistanceRule {
  Distance distance;
  float rx, ry, rz, rounding, scale;
  BOZZETTO_KERNEL float operator()(float x, float y, float z) const {
    return positive(distance(x * rx, y * ry, z * rz) - rounding) * scale;
  }
};

template <class Distance>
class PrimitiveOutside final : public Outside {
 public:
  PrimitiveOutside(const Distance& distance, const glm::dvec3& radii, double rounding, double R)
      : rule_{distance,       float(radii.x),  float(radii.y),
              float(radii.z), float(rounding), static_cast<float>(1 / R)} {}
  void evaluate(const LocalFrame& frame, Key first, int side, float* distance) const override {
    forRows({frame, first}, side, rule_, distance);
  }

 private:
  DistanceRule<Distance> rule_;
};

// u of the surface: where the profile falls to iso.
double surfaceGauge(Profile profile, double iso) {
  double low = 0, high = 1;
  for (int n = 0; n < 50; ++n) {
    const double u = 0.5 * (low + high);
    const auto u2 = static_cast<float>(u * u);
    const float p = profile == Profile::wyvill ? WyvillProfile{}(u2) : BoxProfile{}(u2);
    (static_cast<double>(p) >= iso ? low : high) = u;
  }
  return low;
}

std::unique_ptr<Outside> primitiveOutside(const ToolShape& tool, double iso) {
  const double u = surfaceGauge(tool.profile, iso), R = referenceRadius(tool);
  const glm::dvec3 surface = u * tool.radii;
  const auto make = [&](const auto& distance, double rounding) -> std::unique_ptr<Outside> {
    using Distance = std::decay_t<decltype(distance)>;
    return std::make_unique<PrimitiveOutside<Distance>>(distance, tool.radii, rounding, R);
  };
  if (tool.shape == Shape::box) {
    const double smallest = std::min({surface.x, surface.y, surface.z});
    const double rounding = BoxGauge::kRounding * smallest;
    return make(BoxDistance(surface - rounding), rounding);
  }
  if (tool.shape == Shape::cylinder) return make(CylinderDistance<EllipsoidDistance>(surface), 0);
  if (tool.shape == Shape::capsule) return make(CapsuleDistance<EllipsoidDistance>(surface), 0);
  return make(EllipsoidDistance(surface), 0);
}

class FreeformOutside final : public Outside {
 public:
  FreeformOutside(const ToolShape& tool, const StampReach& reach)
      : grids_(tool, reach.rim),
        distances_(grids_.level().outside(static_cast<float>(reach.iso), grids_.reach())),
        scale_(static_cast<float>(1 / grids_.radius())) {}

  void evaluate(const LocalFrame& frame, Key first, int side, float* distance) const override {
    grids_.read(*distances_, frame, first, side, scale_, distance);
  }

 private:
  SculptedGrids grids_;
  std::shared_ptr<const DistanceField> distances_;
  float scale_;
};

// The room of a sculpture and its handle.
class Handle {
 public:
  Handle(const ToolShape& tool, const StampReach& reach)
      : grids_(tool, reach.rim), room_(grids_.level().handle(grids_.contact(), grids_.reach())) {}

  void evaluate(const LocalFrame& frame, Key first, int side, float* room) const {
    grids_.read(*room_, frame, first, side, 1, room);
  }

 private:
  SculptedGrids grids_;
  std::shared_ptr<const HandleRoom> room_;
};

std::unique_ptr<Outside> makeOutside(const ToolShape& tool, const StampReach& reach) {
  if (reach.profile == StampProfile::paper) return nullptr;
  if (tool.shape == Shape::freeform) return std::make_unique<FreeformOutside>(tool, reach);
  return primitiveOutside(tool, reach.iso);
}

class StampDepth final : public StampTool {
 public:
  StampDepth(const ToolShape& tool, const StampReach& reach)
      : tool_(makePotential(tool)),
        outside_(makeOutside(tool, reach)),
        radii_(tool.radii),
        sculpted_(tool.sculpture != nullptr),
        iso_(static_cast<float>(reach.iso)) {
    if (reach.facing && sculpted_ && outside_ != nullptr) handle_.emplace(tool, reach);
    reach_ = tool_->reach();
    if (outside_ == nullptr) return;
    double across = 1;  // cells of the clay to one of the tool's
    if (tool.sculpture) {
      const glm::dvec3 ratio = radii_ / tool.sculpture->halfExtents();
      across = std::max({ratio.x, ratio.y, ratio.z});
    }
    const double R = tool.sculpture ? tool.sculpture->referenceRadius() : referenceRadius(tool);
    const double inset = tool.sculpture ? 1 : surfaceGauge(tool.profile, reach.iso);
    wall_ = inset + (reach.wall * R + 0.01) / radii_;
    perDepth_ = static_cast<float>(1 / reach.wall);
    const glm::dvec3 wanted = inset * radii_ + reach.rim * R * across + 1.0;
    reach_ = glm::max(reach_, wanted - radii_);
  }

  LocalFrame frame(const DabPose& pose) const override { return tool_->frame(pose); }
  glm::dvec3 reach() const override { return reach_; }

  bool misses(const LocalFrame& frame, Key low, Key high) const override {
    return beyond(1.0001 + reach_ / radii_, frame, low, high);
  }
  bool bodyMisses(const LocalFrame& frame, Key low, Key high) const override {
    if (sculpted_) return tool_->misses(frame, low, high);
    return beyond(wall_, frame, low, high);
  }

  bool hasHandle() const override { return handle_.has_value(); }
  void evaluateHandle(const LocalFrame& frame, Key first, int side, float* room) const override {
    handle_->evaluate(frame, first, side, room);
  }

  void evaluateBody(const LocalFrame& frame, Key first, int side, float* body) const override {
    if (sculpted_ || outside_ == nullptr) return tool_->evaluate(frame, first, side, body);
    alignas(64) float depth[512];
    evaluateWithBody(frame, first, side, depth, body);
  }

  void evaluateWithBody(const LocalFrame& frame, Key first, int side, float* depth,
                        float* body) const override {
    const int count = side * side * side;
    if (sculpted_ || outside_ == nullptr) {
      tool_->evaluate(frame, first, side, body);
      return depthOf(frame, first, side, body, depth);
    }
    evaluate(frame, first, side, depth);
    for (int n = 0; n < count; ++n) {
      const float t = positive(1.0f - positive(depth[n] - (1 - iso_)) * perDepth_);
      body[n] = (t * t) * (3.0f - 2.0f * t);
    }
  }

  void evaluate(const LocalFrame& frame, Key first, int side, float* depth) const override {
    alignas(64) float covered[512];
    tool_->evaluate(frame, first, side, covered);
    depthOf(frame, first, side, covered, depth);
  }

 private:
  // The local box of these half sides has nothing of the corners' box.
  static bool beyond(const glm::dvec3& half, const LocalFrame& frame, Key low, Key high) {
    for (int axis = 0; axis < 3; ++axis) {
      double centre = frame.first[axis], extent = 0;
      for (const Axis grid : kAxes) {
        const double step = frame.step[index(grid)][axis];
        centre += 0.5 * (double(low[grid]) + double(high[grid])) * step;
        extent += 0.5 * (double(high[grid]) - double(low[grid])) * std::abs(step);
      }
      if (std::abs(centre) - extent > half[axis]) return true;
    }
    return false;
  }

  void depthOf(const LocalFrame& frame, Key first, int side, const float* covered,
               float* depth) const {
    const int count = side * side * side;
    const bool inside = std::all_of(covered, covered + count, [&](float p) { return p >= iso_; });
    if (outside_ == nullptr || inside) {
      for (int n = 0; n < count; ++n) depth[n] = 1 - covered[n];
      return;
    }
    outside_->evaluate(frame, first, side, depth);
    for (int n = 0; n < count; ++n)
      depth[n] = covered[n] < iso_ ? (1 - iso_) + depth[n] : 1 - covered[n];
  }

  std::unique_ptr<Potential> tool_;
  std::unique_ptr<Outside> outside_;
  std::optional<Handle> handle_;
  glm::dvec3 radii_, reach_;
  bool sculpted_;
  glm::dvec3 wall_{1};  // of primitives: where it ends, ÷ radii
  float perDepth_ = 0;  // it falls so much
  float iso_;
};

// def(d), in float.
class StampPotential final : public StampTool {
 public:
  StampPotential(const ToolShape& tool, const StampOptions& options, double iso, bool facing)
      : depth_(tool, {options.profile, iso, options.rise + options.fall,
                      options.rise + options.fall, facing}),
        curve_(options, iso) {}
  bool hasHandle() const override { return depth_.hasHandle(); }
  void evaluateHandle(const LocalFrame& frame, Key first, int side, float* room) const override {
    depth_.evaluateHandle(frame, first, side, room);
  }
  LocalFrame frame(const DabPose& pose) const override { return depth_.frame(pose); }
  glm::dvec3 reach() const override { return depth_.reach(); }
  bool misses(const LocalFrame& frame, Key low, Key high) const override {
    return depth_.misses(frame, low, high);
  }
  bool bodyMisses(const LocalFrame& frame, Key low, Key high) const override {
    return depth_.bodyMisses(frame, low, high);
  }
  void evaluateBody(const LocalFrame& frame, Key first, int side, float* body) const override {
    depth_.evaluateBody(frame, first, side, body);
  }
  void evaluateWithBody(const LocalFrame& frame, Key first, int side, float* def,
                        float* body) const override {
    depth_.evaluateWithBody(frame, first, side, def, body);
    deform(side, def);
  }
  void evaluate(const LocalFrame& frame, Key first, int side, float* def) const override {
    depth_.evaluate(frame, first, side, def);
    deform(side, def);
  }

 private:
  void deform(int side, float* def) const {
    const int count = side * side * side;
    for (int n = 0; n < count; ++n)
      def[n] = static_cast<float>(curve_(static_cast<double>(def[n])));
  }

  StampDepth depth_;
  StampCurve curve_;
};

}  // namespace

double referenceRadius(const ToolShape& tool) {
  const glm::dvec3& r = tool.radii;
  const double box = r.x * r.y * r.z;
  switch (tool.shape) {
    case Shape::ellipsoid:
      return std::cbrt(box);
    case Shape::box:
      return std::cbrt(box * 6 / 3.14159265358979323846);
    case Shape::cylinder:
      return std::cbrt(box * 1.5);
    case Shape::capsule: {
      const double cap = std::min(r.y, std::sqrt(r.x * r.z));
      return std::cbrt(r.x * r.z * (1.5 * (r.y - cap) + cap));
    }
    case Shape::freeform: {
      const glm::dvec3 ratio = r / tool.sculpture->halfExtents();
      return tool.sculpture->referenceRadius() * std::cbrt(ratio.x * ratio.y * ratio.z);
    }
  }
  return 0;
}

std::unique_ptr<StampTool> makeStampDepth(const ToolShape& tool, const StampReach& reach) {
  return std::make_unique<StampDepth>(tool, reach);
}

std::unique_ptr<StampTool> makeStampPotential(const ToolShape& tool, const StampOptions& options,
                                              double iso, bool facing) {
  return std::make_unique<StampPotential>(tool, clamped(options, iso), iso, facing);
}

}  // namespace bozzetto
