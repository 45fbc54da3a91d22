#include "bozzetto/tool/solid.hpp"

#include "bozzetto/base/error.hpp"
#include "tool/block_rows.hpp"
#include "tool/distance.hpp"

namespace bozzetto {
namespace {

template <class Distance>
struct SlopeRule {
  Distance distance;
  BOZZETTO_KERNEL float operator()(float x, float y, float z) const {
    const float value = 0.5f - 0.5f * distance(x, y, z);
    return lesser(positive(value), 1.0f);
  }
};

// Radii of 1: local positions are in cells.
LocalFrame unscaledFrame(DabPose pose) {
  pose.radii = {1, 1, 1};
  return localFrame(pose);
}

template <class Distance>
class SolidOf final : public Solid {
 public:
  explicit SolidOf(const DabPose& pose) : frame_(unscaledFrame(pose)), rule_{Distance(pose.radii)} {
    cell = frame_.cell;
  }

  void evaluate(Key first, int side, float* value) const override {
    forRows({frame_, first}, side, rule_, value);
  }

  double distance(const glm::dvec3& position) const override {
    double local[3];
    for (int axis = 0; axis < 3; ++axis) {
      double sum = frame_.first[axis];
      for (int grid = 0; grid < 3; ++grid)
        sum += position[grid] * static_cast<double>(frame_.step[grid][axis]);
      local[axis] = std::abs(sum);
    }
    return rule_.distance(local[0], local[1], local[2]);
  }

 private:
  LocalFrame frame_;
  SlopeRule<Distance> rule_;
};

void swapAxes(DabPose& pose, int a, int b) {
  std::swap(pose.radii[a], pose.radii[b]);
  std::swap(pose.orientation[a], pose.orientation[b]);
}

// The shortest axis first, among those about which the shape is round; all sorted where it can be,
// so that quarter turns are swapped radii to the bit.
DabPose ordered(Shape shape, DabPose pose) {
  if (shape == Shape::box) return pose;
  if (pose.radii.z < pose.radii.x) swapAxes(pose, 0, 2);
  if (shape != Shape::ellipsoid) return pose;
  if (pose.radii.y < pose.radii.x) swapAxes(pose, 0, 1);
  if (pose.radii.z < pose.radii.y) swapAxes(pose, 1, 2);
  return pose;
}

template <class Round>
std::unique_ptr<Solid> makeRound(Shape shape, const DabPose& pose) {
  if (shape == Shape::cylinder) return std::make_unique<SolidOf<CylinderDistance<Round>>>(pose);
  if (shape == Shape::capsule) return std::make_unique<SolidOf<CapsuleDistance<Round>>>(pose);
  return std::make_unique<SolidOf<Round>>(pose);
}

}  // namespace

std::unique_ptr<Solid> makeSolid(Shape shape, const DabPose& given) {
  if (shape == Shape::freeform) throw Error("fill: freeform found, a primitive expected (combine)");
  if (shape == Shape::box) return std::make_unique<SolidOf<BoxDistance>>(given);
  // A capsule without a straight part is an ellipsoid.
  const bool flat =
      shape == Shape::capsule && given.radii.y <= std::sqrt(given.radii.x * given.radii.z);
  const Shape kind = flat ? Shape::ellipsoid : shape;
  const DabPose pose = ordered(kind, given);
  const bool circular = pose.radii.x == pose.radii.z;
  const bool ball = circular && (kind != Shape::ellipsoid || pose.radii.x == pose.radii.y);
  return ball ? makeRound<BallDistance>(kind, pose) : makeRound<EllipsoidDistance>(kind, pose);
}

}  // namespace bozzetto
