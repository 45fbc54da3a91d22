// From the pointer to the clay.
#include "ui/stroke_maker.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "bozzetto/sculptor/sculptor.hpp"

namespace bozzetto::ui {
namespace {

constexpr double kRadius = 20;
constexpr Extent kExtent{800, 600};

// A ball of clay about the origin.
PatchSet ballSet(glm::dvec3 centre = glm::dvec3(0)) {
  Sculptor sculptor({}, SurfaceUpkeep::afterEachDab);
  Primitive ball;
  ball.centre = centre;
  ball.radii = glm::dvec3(kRadius);
  sculptor.apply(FillOperation{ball});
  PatchSet set;
  for (const auto& [block, run] : sculptor.surface().patches()) {
    const Key corner = BlockGeometry<8>::firstCornerOf(block);
    set.put(corner, std::make_shared<const ShownPatch>(UnpackedPatch(corner, *run.block)));
  }
  return set;
}

StrokeMaker::Setting frontView() {
  StrokeMaker::Setting setting;
  setting.view.distance = 150;
  setting.extent = kExtent;
  return setting;
}

TEST(PatchSet, raysMeetTheBallWhereItIs) {
  const PatchSet ball = ballSet();
  int hits = 0;
  for (int n = 0; n < 400; ++n) {
    const double a = n * 0.7, b = n * 0.37;
    const glm::dvec3 from = glm::normalize(glm::dvec3(std::cos(a), std::sin(b), std::sin(a))) * 90.;
    const glm::dvec3 aim(3 * std::sin(n * 1.3), 4 * std::cos(n * 0.9), 2);
    const auto hit = ball.pick({from, glm::normalize(aim - from)});
    ASSERT_TRUE(hit.has_value()) << n;
    EXPECT_NEAR(glm::length(hit->position), kRadius, 0.15);
    EXPECT_GT(glm::dot(hit->normal, glm::normalize(hit->position)), 0.98);
    ++hits;
  }
  EXPECT_EQ(hits, 400);
  EXPECT_FALSE(ball.pick({{0, 0, 90}, {0, 0, 1}}).has_value());
  EXPECT_FALSE(ball.pick({{25, 0, 90}, {0, 0, -1}}).has_value());
}

TEST(PatchSet, worksFarFromTheOrigin) {
  const glm::dvec3 far(1 << 29, -(1 << 29), 1 << 29);
  const auto hit = ballSet(far).pick({far + glm::dvec3(0, 0, 90), {0, 0, -1}});
  ASSERT_TRUE(hit.has_value());
  EXPECT_NEAR(hit->position.z - far.z, kRadius, 0.1);
}

TEST(PatchSet, aCopyStaysAsItWas) {
  PatchSet set = ballSet();
  const PatchSet frozen = set;
  const std::size_t triangles = set.triangles();
  std::vector<Key> keys;
  set.forEach([&](const ShownPatch& patch) { keys.push_back(patch.data.origin); });
  for (const Key key : keys) set.put(key, nullptr);
  EXPECT_TRUE(set.empty());
  EXPECT_TRUE(set.bounds().empty());
  EXPECT_EQ(frozen.triangles(), triangles);
  EXPECT_TRUE(frozen.pick({{0, 0, 90}, {0, 0, -1}}).has_value());
}

TEST(StrokeMaker, liesOnTheClayItBeganOn) {
  SculptState state;
  StrokeMaker maker(ballSet(), state, frontView());
  const auto first = maker.begin({400, 300}, 1);
  ASSERT_TRUE(first.has_value());
  EXPECT_TRUE(maker.onClay());
  EXPECT_NEAR(first->position.z, kRadius, 0.1);
  EXPECT_GT(maker.start().normal.z, 0.99);
  const auto next = maker.move({440, 300}, 0.5);
  ASSERT_TRUE(next.has_value());
  EXPECT_NEAR(glm::length(next->position), kRadius, 0.1);
  EXPECT_DOUBLE_EQ(next->pressure, 0.5);
}

TEST(StrokeMaker, goesOnBesideTheClayAtTheSameDepth) {
  SculptState state;
  StrokeMaker maker(ballSet(), state, frontView());
  maker.begin({400, 300}, 1);
  const glm::dvec3 onRim = maker.move({470, 300}, 1)->position;
  const glm::dvec3 beside = maker.move({700, 300}, 1)->position;
  EXPECT_NEAR(beside.z, onRim.z, 1e-9);
  EXPECT_GT(beside.x, kRadius);
}

TEST(StrokeMaker, worksInTheAirWhereItIsAllowed) {
  SculptState state;
  StrokeMaker::Setting setting = frontView();
  setting.airPoint = {0, 0, 33};
  StrokeMaker maker(ballSet(), state, setting);
  const auto first = maker.begin({40, 40}, 1);
  ASSERT_TRUE(first.has_value());
  EXPECT_FALSE(maker.onClay());
  EXPECT_NEAR(first->position.z, 33, 1e-9);
  // Over clay it stays in its plane.
  EXPECT_NEAR(maker.move({400, 300}, 1)->position.z, 33, 1e-9);
  state.air = false;
  StrokeMaker other(ballSet(), state, setting);
  EXPECT_FALSE(other.begin({40, 40}, 1).has_value());
}

TEST(Rope, isSlackUntilItIsTight) {
  Rope rope({0, 0}, 10);
  EXPECT_EQ(rope.pull({6, 0}), glm::dvec2(0, 0));
  EXPECT_EQ(rope.pull({25, 0}), glm::dvec2(15, 0));
  EXPECT_NEAR(glm::distance(rope.pull({40, 30}), glm::dvec2(40, 30)), 10, 1e-12);
}

TEST(StrokeMaker, theRopeSwallowsTrembling) {
  SculptState state;
  state.steady = true;
  state.rope = 30;
  StrokeMaker maker(ballSet(), state, frontView());
  ASSERT_TRUE(maker.begin({400, 300}, 1).has_value());
  EXPECT_FALSE(maker.move({410, 308}, 1).has_value());
  EXPECT_TRUE(maker.move({460, 300}, 1).has_value());
}

TEST(PressureCurve, keepsItsEnds) {
  const PressureCurve curve{2, 0.2};
  EXPECT_DOUBLE_EQ(curve(0), 0.2);
  EXPECT_DOUBLE_EQ(curve(1), 1);
  EXPECT_DOUBLE_EQ(curve(0.5), 0.2 + 0.8 * 0.25);
  EXPECT_DOUBLE_EQ(curve(7), 1);
}

}  // namespace
}  // namespace bozzetto::ui
