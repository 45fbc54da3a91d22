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

// A view in which strokes push with this tool.
StrokeMaker::Setting pressing(const SculptState& state, const ToolShape& tool) {
  StrokeMaker::Setting setting = frontView();
  setting.pressOn = [=](const GroundHit&) { return Press(tool, state, setting.spacing); };
  return setting;
}

TEST(StrokeMaker, aPushSinksByAShareOfItsRadiusAllTheWay) {
  SculptState state;
  state.strengthOf(ActionKind::push) = 0.25;
  StrokeMaker maker(ballSet(), state, pressing(state, ToolShape{}));
  EXPECT_NEAR(maker.begin({400, 300}, 1)->position.z, kRadius + 6, 0.1);
  for (int x = 405; x < 460; x += 5) {
    const glm::dvec3 at = maker.move({x, 300}, 1)->position;
    EXPECT_NEAR(glm::length(at), kRadius + 6, 0.25) << x;
  }
  EXPECT_NEAR(glm::length(maker.move({430, 300}, 0.5)->position), kRadius + 7, 0.2)
      << "half as deep, with half the pressure";
  EXPECT_NEAR(glm::length(maker.move({430, 300}, 0)->position), kRadius + 8, 0.2) << "it touches";
}

TEST(StrokeMaker, aPushLeavesTheClayWithoutTurningIn) {
  SculptState state;
  StrokeMaker maker(ballSet(), state, pressing(state, ToolShape{}));
  maker.begin({400, 300}, 1);
  glm::dvec3 last(0);
  for (int x = 405; x < 600; x += 5) {
    const glm::dvec3 at = maker.move({x, 300}, 1)->position;
    EXPECT_GT(glm::length(at), kRadius + 5) << x;
    EXPECT_GT(at.x, last.x) << x;
    last = at;
  }
}

TEST(StrokeMaker, aPushFromTheAirIsNotLed) {
  SculptState state;
  StrokeMaker::Setting setting = pressing(state, ToolShape{});
  setting.airPoint = {0, 0, 3};
  StrokeMaker maker(ballSet(), state, setting);
  EXPECT_NEAR(maker.begin({40, 300}, 1)->position.z, 3, 1e-9);
  EXPECT_NEAR(maker.move({400, 300}, 1)->position.z, 3, 1e-9);
}

// Of every form the side that meets the clay sinks by the share of its half width.
TEST(Press, knowsHowFarAToolReaches) {
  SculptState state;
  state.strengthOf(ActionKind::push) = 0.5;
  const double half = std::sqrt(0.5);
  const glm::dvec3 slanted(0, half, half);
  const auto lift = [&](Shape shape, glm::dvec3 normal) {
    ToolShape tool;
    tool.shape = shape;
    tool.radii = {4, 10, 4};
    return glm::dot(Press(tool, state, 1).lift(normal, 1), normal);
  };
  for (const Shape shape : {Shape::ellipsoid, Shape::box, Shape::cylinder, Shape::capsule}) {
    EXPECT_NEAR(lift(shape, {0, 1, 0}), 5, 1e-12);
    EXPECT_NEAR(lift(shape, {1, 0, 0}), 2, 1e-12);
  }
  EXPECT_NEAR(lift(Shape::ellipsoid, slanted), 0.5 * std::sqrt((100 + 16) / 2.), 1e-12);
  EXPECT_NEAR(lift(Shape::box, slanted), 0.5 * ((9 + 3) * half + 1), 1e-12);
  EXPECT_NEAR(lift(Shape::cylinder, slanted), 0.5 * (14 * half), 1e-12);
  EXPECT_NEAR(lift(Shape::capsule, slanted), 0.5 * (6 * half + 4), 1e-12);
}

// A pen that sizes the tool: no smaller than tools are; a strength that pressure does not drive.
TEST(Press, followsASizeUnderThePen) {
  SculptState state;
  state.strengthOf(ActionKind::push) = 0.25;
  state.pressureStrength = false;
  state.pressureSize = true;
  const Press press(ToolShape{}, state, 1);
  EXPECT_NEAR(press.lift({0, 0, 1}, 0.5).z, 3, 1e-12);
  EXPECT_NEAR(press.lift({0, 0, 1}, 0).z, 1.5, 1e-12) << "of two cells";
}

// One wrinkle under the pointer does not turn the tool.
TEST(Press, theNormalIsOfWhatTheToolLiesOn) {
  const PatchSet ball = ballSet();
  const Ray ray{{0, 0, 90}, {0, 0, -1}};
  GroundHit wrinkle = *groundUnder(ball, ray, 1);
  wrinkle.normal = {1, 0, 0};
  EXPECT_GT(broadNormal(ball, ray, wrinkle, 8, 1).z, 0.95);
  // Nothing beside it: its own.
  EXPECT_EQ(broadNormal(PatchSet(), ray, wrinkle, 8, 1), wrinkle.normal);
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
