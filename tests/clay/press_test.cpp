// What a press pushes out fades with the way from the tool: no ledge where the region ends in which
// fluid clay gives way.
#include <algorithm>
#include <numbers>

#include "bozzetto/field/sampler.hpp"
#include "clay/clay_fixture.hpp"

namespace bozzetto::clay::testing {
namespace {

constexpr double kRadius = 40;

// Where a ray from outside towards the middle meets the clay, beyond the ball's radius.
double riseAt(FieldSampler<8>& clay, double height, double round) {
  const glm::dvec3 way(std::cos(height) * std::cos(round), std::sin(height),
                       std::cos(height) * std::sin(round));
  double radius = 1.5 * kRadius;
  while (radius > 0 && clay.value(cellPoint({}, radius * way)) < 0.5f) radius -= 0.02;
  return radius - kRadius;
}

TEST(Press, SlowLeavesNoLedgeRoundTheBody) {
  Clay clay;
  addSolid(clay, Shape::ellipsoid, {0, 0, 0}, {kRadius, kRadius, kRadius});
  Push push{toolOf(Shape::ellipsoid, {16, 16, 16}), Role::push, {}, {}};
  push.setup.settings.stiffness = 0;
  push.setup.supports = {{Shape::box, {0, -60, 0}, {60, 20, 60}, {1, 0, 0, 0}}};
  push.stroke.points = {{{0, 60, 0}, 1}, {{0, 30, 0}, 1}};
  run(clay, push);
  FieldSampler<8> sampler(clay);
  const double degree = std::numbers::pi / 180;
  for (int round = 0; round < 360; round += 30) {
    const auto rise = [&](int height) { return riseAt(sampler, height * degree, round * degree); };
    for (int height = -60; height <= 12; height += 3) {
      const double climb = rise(height) - rise(height - 6);  // on four cells
      EXPECT_GT(climb, -0.2) << height << ", " << round;
      EXPECT_LT(climb, 0.35) << height << ", " << round;
    }
    EXPECT_GT(rise(30), 0.7) << "it goes somewhere";
  }
}

// Where a wall lies on the region's border nothing is cut, and nothing stands still.
TEST(Press, SlowLeavesNoBubblesBehindAWall) {
  Clay clay;
  addSolid(clay, Shape::box, {0, 0, 0}, {40, 14, 32});
  holdBox(clay, {-50, -20, -40}, {50, -9, 40});
  Push push{toolOf(Shape::ellipsoid, {9, 9, 9}), Role::push, {}, {}};
  push.setup.settings.stiffness = 0;
  push.stroke.points = {{{-26, 26, 0}, 1}, {{-26, 18, 0}, 1}, {{26, 18, 0}, 1}};
  run(clay, push);
  float least = 1;
  for (int n = 0; n < 60 * 16 * 3; ++n)
    least = std::min(least, clay.value({n / 48 - 30, n / 3 % 16 - 8, n % 3 - 31}));
  EXPECT_GT(least, 0.9f);
}

}  // namespace
}  // namespace bozzetto::clay::testing
