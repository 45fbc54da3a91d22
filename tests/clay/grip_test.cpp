// What a grip pulls out of a body: a horn with a neck, smooth and in one piece, whatever the
// stiffness.
#include <algorithm>
#include <numbers>

#include "clay/clay_fixture.hpp"

namespace bozzetto::clay::testing {
namespace {

constexpr double kRadius = 20, kWay = 12;
constexpr int kHeld = -5;  // last plane of held clay

// A ball held on one side, its other end gripped and pulled out: 25 free cells become 37.
Clay pulledBall(double stiffness) {
  Clay clay;
  addSolid(clay, Shape::ellipsoid, {0, 0, 0}, {kRadius, kRadius, kRadius});
  holdBox(clay, {-24, -24, -24}, {kHeld, 24, 24});
  Push push{toolOf(Shape::ellipsoid, {9, 9, 9}), Role::grip, {}, {}};
  push.setup.settings.stiffness = stiffness;
  push.stroke.points = {{{18, 0, 0}, 1}, {{18 + kWay, 0, 0}, 1}};
  run(clay, push);
  return clay;
}

float between(const Clay& clay, int i, double y, double z) {
  const int j = static_cast<int>(std::floor(y)), k = static_cast<int>(std::floor(z));
  const auto fy = static_cast<float>(y - j), fz = static_cast<float>(z - k);
  return (1 - fy) * ((1 - fz) * clay.value({i, j, k}) + fz * clay.value({i, j, k + 1})) +
         fy * ((1 - fz) * clay.value({i, j + 1, k}) + fz * clay.value({i, j + 1, k + 1}));
}

// Where a ray from far outside meets the clay of plane i, and whether there is clay all the way on
// to the axis.
struct Section {
  double least = 1e9, most = 0;
  bool solid = true;
};

Section sectionAt(const Clay& clay, int i) {
  Section section;
  for (int n = 0; n < 64; ++n) {
    const double turn = n * std::numbers::pi / 32, y = std::cos(turn), z = std::sin(turn);
    double radius = 30;
    while (radius > 0 && between(clay, i, radius * y, radius * z) < 0.5) radius -= 0.1;
    section.least = std::min(section.least, radius);
    section.most = std::max(section.most, radius);
    for (double r = 0; r < radius - 0.1; r += 0.5)
      section.solid = section.solid && between(clay, i, r * y, r * z) >= 0.5;
  }
  return section;
}

TEST(Grip, SlowABallPulledOutGrowsASmoothHorn) {
  Clay ball;
  addSolid(ball, Shape::ellipsoid, {0, 0, 0}, {kRadius, kRadius, kRadius});
  const Measures before = measure(ball);
  for (const double stiffness : {0.0, 0.3, 0.7, 1.0}) {
    SCOPED_TRACE(stiffness);
    const Clay clay = pulledBall(stiffness);
    const Measures after = measure(clay);
    EXPECT_EQ(after.pieces, 1);
    EXPECT_NEAR(after.mass / before.mass, 1, 1e-7);
    EXPECT_NEAR(after.volume / before.volume, 1, 0.005);
    EXPECT_LT(after.thickness, 2.2);
    EXPECT_GT(clay.value({31, 0, 0}), 0.5) << "its end comes along, as far as the grip goes";
    EXPECT_LT(clay.value({33, 0, 0}), 0.5);
    Section last = sectionAt(clay, kHeld + 1);
    double neck = last.least, beyond = 0;
    for (int i = kHeld + 2; i < 30; ++i) {
      const Section here = sectionAt(clay, i);
      EXPECT_TRUE(here.solid) << i;
      EXPECT_LT(here.most - here.least, 2.0) << i;
      EXPECT_LT(std::abs(here.least - last.least), 2.5) << i;
      if (here.least < neck) neck = here.least, beyond = 0;
      beyond = std::max(beyond, here.least - neck);
      last = here;
    }
    EXPECT_GT(neck, 5);
    EXPECT_LT(beyond, 3) << "thin once, not again and again";
  }
}

// What a grip holds follows by its strength, as a share of its way and of its turn.
TEST(Grip, StrengthIsTheShareThatFollows) {
  for (const double strength : {0.25, 0.5, 1.0}) {
    Clay clay;
    addSolid(clay, Shape::box, {0, 0, 0}, {9, 4, 4});
    Push push{toolOf(Shape::ellipsoid, {24, 24, 24}), Role::grip, {}, {}};
    push.strength = strength;
    push.stroke.points = {{{0, 0, 0}, 1}, {{0, 8, 0}, 1}};
    push.stroke.rotations = {{1, 0, 0, 0}, glm::angleAxis(0.5, glm::dvec3(0, 0, 1))};
    run(clay, push);
    const Measures after = measure(clay);
    EXPECT_NEAR(after.centre.y, 8 * strength, 0.15) << strength;
    double skew = 0, spread = 0;
    for (int n = 0; n < 41 * 41; ++n) {
      const double i = n / 41 - 20, j = n % 41 - 16;
      for (int k = -5; k <= 5; ++k) {
        const double v = clay.value({n / 41 - 20, n % 41 - 16, k});
        skew += v * (i - after.centre.x) * (j - after.centre.y);
        spread += v * ((i - after.centre.x) * (i - after.centre.x) -
                       (j - after.centre.y) * (j - after.centre.y));
      }
    }
    EXPECT_NEAR(0.5 * std::atan2(2 * skew, spread), 0.5 * strength, 0.03) << strength;
  }
}

}  // namespace
}  // namespace bozzetto::clay::testing
