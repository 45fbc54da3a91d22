// Laws: supports that stand in clay, and clay that has nowhere to go.
#include "clay/clay_fixture.hpp"

namespace bozzetto::clay::testing {
namespace {

// A table dragged over the clay, or round all of it: what stands in it stays, and takes that room.
TEST(Crowded, SlowClayInsideASupportStays) {
  for (const double half : {12.0, 20.0, 60.0}) {
    Clay clay;
    addSolid(clay, Shape::ellipsoid, {0, 0, 0}, {20, 20, 20});
    const Measures before = measure(clay);
    Push push{toolOf(Shape::ellipsoid, {8, 8, 8}), Role::push, {}, {}};
    push.stroke.points = {{{0, -30, 0}, 1}, {{0, -15, 0}, 1}};
    push.setup.supports.push_back({Shape::box, {0, 15, 0}, {half, half, half}, {1, 0, 0, 0}});
    run(clay, push);
    const Measures after = measure(clay);
    EXPECT_EQ(after.pieces, 1) << half;
    EXPECT_NEAR(after.mass / before.mass, 1, 1e-7) << half;
    EXPECT_NEAR(after.volume / before.volume, 1, 0.01) << half;
    EXPECT_LT(after.densest, 1.2) << half;
  }
}

// A piston in a closed box: nothing gives way, so the tool goes through the clay.
TEST(Crowded, SlowDensitiesAreBoundedWhereNothingGivesWay) {
  for (const Scheme scheme : {Scheme::projected, Scheme::paper, Scheme::paperSweeps}) {
    Clay clay;
    addSolid(clay, Shape::box, {0, 0, 0}, {6, 6, 6});
    const double before = statistics(clay).mass;
    Push push{toolOf(Shape::box, {5, 5, 5}), Role::push, {}, {}};
    push.stroke.points = {{{0, 14, 0}, 1}, {{0, -1, 0}, 1}};
    push.setup.settings.scheme = scheme;
    for (int n = 0; n < 6; ++n) {
      glm::dvec3 wall(0), half(20);
      wall[n / 2] = n % 2 == 0 ? 12.5 : -12.5;
      half[n / 2] = 6;
      push.setup.supports.push_back({Shape::box, wall, half, {1, 0, 0, 0}});
    }
    run(clay, push);
    EXPECT_NEAR(statistics(clay).mass / before, 1, 1e-7) << toText(scheme);
    EXPECT_LE(measure(clay).densest, kMostDensity) << toText(scheme);
    EXPECT_EQ(validate(clay), std::nullopt);
  }
}

// What the displacement alone crams comes out again as soon as a layer conserves volumes.
TEST(Crowded, SlowCrammedClayComesOutWhenItIsRelaxed) {
  Clay clay;
  addSolid(clay, Shape::box, {0, 0, 0}, {20, 10, 20});
  holdBox(clay, {-24, -12, -24}, {24, -8, 24});
  const Measures before = measure(clay);
  Push push{toolOf(Shape::ellipsoid, {6, 6, 6}), Role::push, {}, {}};
  push.setup.settings.stiffness = 0.3;
  push.setup.settings.layers = {LayerKind::displacement};
  push.stroke.points = {{{0, 18, 0}, 1}, {{0, 8, 0}, 1}};
  run(clay, push);
  EXPECT_LT(measure(clay).volume, 0.95 * before.volume);
  clay::Setup setup;
  Edit<CornerBlock<8>> edit(clay.tree);
  relax(edit, clay.scale, setup, 40);
  edit.commit();
  const Measures after = measure(clay);
  EXPECT_NEAR(after.mass / before.mass, 1, 1e-6);
  EXPECT_NEAR(after.volume / before.volume, 1, 0.01);
  EXPECT_LT(after.densest, 1.05);
  EXPECT_EQ(after.pieces, 1);
}

// A ball on a table, pressed from above: tables of two cells, thinner ones and thick ones are met
// alike.
TEST(Crowded, SlowNothingGoesThroughATable) {
  using enum LayerKind;
  const std::vector<LayerKind> stacks[] = {
      {diffusion}, {automaton}, {displacement, conservation, tension}};
  for (const auto& layers : stacks)
    for (const double half : {0.01, 0.3, 1.0, 2.0, 10.0}) {
      SCOPED_TRACE(std::string(toText(layers.front())) + ", half " + std::to_string(half));
      Clay clay;
      addSolid(clay, Shape::ellipsoid, {0, 0, 0}, {14, 14, 14});
      const double before = statistics(clay).mass;
      Push push{toolOf(Shape::ellipsoid, {8, 8, 8}), Role::push, {}, {}};
      push.stroke.points = {{{0, 26, 0}, 1}, {{0, 4, 0}, 1}};
      push.setup.settings.layers = layers;
      push.setup.supports.push_back({Shape::box, {0, -14 - half, 0}, {60, half, 60}});
      run(clay, push);
      EXPECT_NEAR(statistics(clay).mass / before, 1, 1e-7);
      EXPECT_EQ(measure(clay).pieces, 1);
      double below = 0, behind = 0;
      for (int i = -40; i <= 40; ++i)
        for (int k = -40; k <= 40; ++k) {
          for (int j = -50; j < -14; ++j) below += clay.value({i, j, k});
          for (int j = 15; j < 40; ++j) behind += clay.value({i, j, k});
        }
      EXPECT_LT(below, half < 1 ? 5 : 1e-9);
      EXPECT_EQ(behind, 0);
    }
}

TEST(Crowded, SupportsUnderTwoCellsAreWidenedAndThatIsTold) {
  Support table{Shape::box, {0, 0, 0}, {9, 0.5, 9}, {1, 0, 0, 0}};
  EXPECT_EQ(noticeOf(table, 1),
            "support of 1 cells widened to 2: clay would go through a thinner one");
  EXPECT_EQ(noticeOf(table, 0.5), "");
  Clay clay;
  addSolid(clay, Shape::box, {0, 20, 0}, {4, 4, 4});
  Edit<CornerBlock<8>> edit(clay.tree);
  Push push{toolOf(Shape::ellipsoid, {4, 4, 4}), Role::push, {}, {}};
  push.stroke.points = {{{0, 30, 0}, 1}};
  push.setup.supports = {table, table};
  const ClayStroke<8> told(edit, clay.scale, push.tool, {}, push.stroke, push.setup);
  EXPECT_EQ(told.notice(), noticeOf(table, 1));
}

}  // namespace
}  // namespace bozzetto::clay::testing
