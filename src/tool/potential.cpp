#include "bozzetto/tool/potential.hpp"

#include "tool/block_rows.hpp"
#include "tool/freeform.hpp"
#include "tool/gauge.hpp"

namespace bozzetto {
namespace {

template <class Gauge, class Profile>
struct Falling {
  Gauge gauge;
  BOZZETTO_KERNEL float operator()(float x, float y, float z) const {
    return Profile{}(gauge(x, y, z));
  }
};

template <class Gauge, class Profile>
class PrimitivePotential final : public Potential {
 public:
  explicit PrimitivePotential(const glm::dvec3& radii) : rule_{Gauge(radii)} {}

  bool misses(const LocalFrame& frame, Key low, Key high) const override {
    float nearest[3];
    for (int axis = 0; axis < 3; ++axis) {
      float centre = frame.first[axis], extent = 0;
      for (const Axis grid : kAxes) {
        const float step = frame.step[index(grid)][axis];
        centre += 0.5f * static_cast<float>(low[grid] + high[grid]) * step;
        extent += 0.5f * static_cast<float>(high[grid] - low[grid]) * std::abs(step);
      }
      const float distance = std::abs(centre) - extent;
      nearest[axis] = distance > 0 ? distance : 0;
    }
    return rule_.gauge(nearest[0], nearest[1], nearest[2]) > 1.00005f;
  }

  void evaluate(const LocalFrame& frame, Key first, int side, float* potential) const override {
    forRows({frame, first}, side, rule_, potential);
  }

 private:
  Falling<Gauge, Profile> rule_;
};

template <class Gauge>
std::unique_ptr<Potential> make(const ToolShape& shape) {
  if (shape.profile == Profile::wyvill)
    return std::make_unique<PrimitivePotential<Gauge, WyvillProfile>>(shape.radii);
  return std::make_unique<PrimitivePotential<Gauge, BoxProfile>>(shape.radii);
}

}  // namespace

std::unique_ptr<Potential> makePotential(const ToolShape& shape) {
  switch (shape.shape) {
    case Shape::ellipsoid:
      return make<EllipsoidGauge>(shape);
    case Shape::box:
      return make<BoxGauge>(shape);
    case Shape::cylinder:
      return make<CylinderGauge>(shape);
    case Shape::capsule:
      return make<CapsuleGauge>(shape);
    case Shape::freeform:
      return makeFreeform(shape.sculpture, shape.radii);
  }
  return nullptr;
}

}  // namespace bozzetto
