// What the program promises of clay (README, src/clay/NOTES.md), stated literally and held to it.
#include "bozzetto/clay/hold.hpp"
#include "clay/clay_fixture.hpp"

namespace bozzetto::clay::testing {
namespace {

Push pushOf(Shape shape, glm::dvec3 radii, double stiffness) {
  Push push{toolOf(shape, radii), Role::push, {}, {}};
  push.setup.settings.stiffness = stiffness;
  return push;
}

Settings running(std::vector<LayerKind> layers, Scheme scheme = Scheme::projected) {
  Settings settings;
  settings.layers = std::move(layers);
  settings.scheme = scheme;
  return settings;
}

// Drift ≤ 1e-6 of the total over 1,000 steps of every layer: to and fro, in and out.
TEST(Promises, SlowAThousandStepsOfEveryLayerKeepTheMass) {
  using enum LayerKind;
  Settings viscous = running({diffusion});
  viscous.viscosity = 3;
  const Settings all[] = {running({displacement, conservation, tension}),
                          running({displacement, conservation, tension}, Scheme::paper),
                          running({displacement, conservation, tension}, Scheme::paperSweeps),
                          running({displacement}),
                          running({conservation}),
                          running({tension}),
                          running({diffusion}),
                          viscous,
                          running({automaton})};
  for (const Settings& settings : all) {
    Clay clay;
    addSolid(clay, Shape::box, {3.5, 3.5, 3.5}, {7, 4, 7});
    const double before = statistics(clay).mass;
    Push push = pushOf(Shape::ellipsoid, {3, 3, 3}, 0.5);
    push.setup.settings = settings;
    for (int n = 0; n < 32; ++n) {
      const double x = n % 5 * 2, z = n % 7;
      push.stroke.points.push_back({{x, n % 2 == 0 ? 11.0 : 5.0, z}, 1});
    }
    std::int64_t steps = 0;
    while (steps < 1000) steps += run(clay, push);
    EXPECT_NEAR(statistics(clay).mass / before, 1, 1e-6) << toText(settings.layers.front());
  }
}

// A pen that sizes the tool and hovers does not touch; from the lightest touch on the tool is as
// small as tools are.
TEST(Promises, WithoutPressureAToolThatIsSizedByItDoesNotTouch) {
  Clay clay;
  addSolid(clay, Shape::ellipsoid, {0, 0, 0}, {12, 12, 12});
  const std::uint64_t before = fieldHash(clay);
  Push push = pushOf(Shape::ellipsoid, {5, 5, 5}, 0);
  push.stroke.pressure.size = true;
  push.stroke.points = {{{-12, 8, 0}, 0}, {{12, 8, 0}, 0}};
  run(clay, push);
  EXPECT_EQ(fieldHash(clay), before);
  push.stroke.points = {{{-12, 8, 0}, 0}, {{12, 8, 0}, 0.01}};
  run(clay, push);
  const std::uint64_t light = fieldHash(clay);
  EXPECT_NE(light, before);
  push.stroke.pressure.size = false;
  push.stroke.points = {{{-12, 8, 0}, 0}, {{12, 8, 0}, 0}};
  run(clay, push);
  EXPECT_NE(fieldHash(clay), light) << "pressure plays no other part";
}

// Bent by 90° with a rotating grip round a cylinder.
TEST(Promises, SlowABendKeepsVolumeAndEdges) {
  Clay clay;
  addSolid(clay, Shape::box, {48, 65, 12}, {36, 5, 5});
  holdBox(clay, {8, 55, 0}, {23, 75, 24});
  const Measures before = measure(clay);
  Push push = pushOf(Shape::cylinder, {7, 9, 7}, 1);
  push.role = Role::grip;
  push.tool.rotation = glm::angleAxis(std::acos(-1.0) / 2, glm::dvec3(1, 0, 0));
  const glm::dvec3 hinge(42, 53, 12), start(76, 65, 12);
  for (int n = 0; n <= 120; ++n) {
    const glm::dquat turn = glm::angleAxis(-std::acos(-1.0) / 2 * n / 120, glm::dvec3(0, 0, 1));
    push.stroke.points.push_back({hinge + turn * (start - hinge), 1});
    push.stroke.rotations.push_back(turn);
  }
  push.setup.supports = {{Shape::cylinder, hinge, {7, 9, 7}, push.tool.rotation}};
  run(clay, push);
  const Measures after = measure(clay);
  EXPECT_NEAR(after.volume / before.volume, 1, 0.005);
  EXPECT_EQ(after.pieces, 1);
  EXPECT_LT(after.thickness, 2.4);
}

TEST(Promises, SlowAStretchKeepsVolumeAndHangsTogether) {
  Clay clay;
  addSolid(clay, Shape::box, {32, 16, 16}, {24, 6, 6});
  holdBox(clay, {0, 0, 0}, {15, 31, 31});
  const Measures before = measure(clay);
  Push push = pushOf(Shape::box, {4, 9, 9}, 1);
  push.role = Role::grip;
  push.stroke.points = {{{52, 16, 16}, 1}, {{85, 16, 16}, 1}};  // 44 free cells and 33 more: × 1.75
  run(clay, push);
  const Measures after = measure(clay);
  EXPECT_NEAR(after.volume / before.volume, 1, 0.015);
  EXPECT_EQ(after.pieces, 1);
}

// Volume above and missing below the plane of a slab's top. What is fuller than full is hidden: it
// does not count.
struct Furrow {
  double rim = 0, groove = 0;
};

Furrow furrowOf(const Clay& before, const Clay& after, const KeyBox& box) {
  Furrow furrow;
  for (std::int32_t i = box.low.i; i <= box.high.i; ++i)
    for (std::int32_t k = box.low.k; k <= box.high.k; ++k) {
      double change = 0;
      for (std::int32_t j = box.low.j; j <= box.high.j; ++j)
        change += std::min(after.value({i, j, k}), 1.0f) - before.value({i, j, k});
      (change > 0 ? furrow.rim : furrow.groove) += std::abs(change);
    }
  return furrow;
}

TEST(Promises, SlowAFurrowsRimIsItsGroove) {
  Clay clay;
  addSolid(clay, Shape::box, {70, 12, 32}, {66, 10, 28});
  holdBox(clay, {0, 0, 0}, {140, 4, 64});
  const Clay before = clay;
  Push push = pushOf(Shape::ellipsoid, {7, 7, 7}, 0);
  push.stroke.points = {{{20, 32, 32}, 1}, {{20, 24, 32}, 1}, {{120, 24, 32}, 1}};
  run(clay, push);
  const Furrow furrow = furrowOf(before, clay, {{-4, -4, -4}, {144, 50, 70}});
  EXPECT_GT(furrow.groove, 3000);
  EXPECT_NEAR(furrow.rim / furrow.groove, 1, 0.005);
}

// Ball of 10 driven in until its middle is level with the top.
TEST(Promises, SlowAPrintHasTheRimOfThePrototype) {
  Clay clay;
  addSolid(clay, Shape::box, {36, 14.5, 36}, {30, 12.5, 30});
  holdBox(clay, {0, 0, 0}, {72, 4, 72});
  Push push = pushOf(Shape::ellipsoid, {10, 10, 10}, 0);
  push.stroke.points = {{{36, 38, 36}, 1}, {{36, 27, 36}, 1}};
  run(clay, push);
  const auto heightAt = [&](int i) {
    for (int j = 50; j > 0; --j) {
      const double v = clay.value({i, j, 36}), above = clay.value({i, j + 1, 36});
      if (v >= 0.5) return j + (v - 0.5) / (v - above + 1e-9) - 27;
    }
    return -27.0;
  };
  for (const int beside : {46, 48}) {
    EXPECT_GT(heightAt(beside), 2.0);
    EXPECT_LT(heightAt(beside), 2.8);
  }
  EXPECT_LT(heightAt(54), 0.7);
}

// Nothing over the threshold inside a tool that has room round it.
TEST(Promises, SlowToolsWithRoomHoldNothing) {
  for (const double stiffness : {0.0, 0.3, 1.0}) {
    Clay clay;
    addSolid(clay, Shape::box, {0, 0, 0}, {24, 10, 24});
    holdBox(clay, {-30, -12, -30}, {30, -8, 30});
    Push push = pushOf(Shape::ellipsoid, {6, 6, 6}, stiffness);
    push.stroke.points = {{{-8, 18, 0}, 1}, {{-8, 10, 0}, 1}, {{8, 10, 2}, 1}};
    run(clay, push);
    for (int n = 0; n < 13 * 13 * 13; ++n) {
      const Key key{n / 169 + 2, n / 13 % 13 + 4, n % 13 - 4};
      const double depth =
          6 - std::sqrt(std::pow(key.i - 8, 2) + std::pow(key.j - 10, 2) + std::pow(key.k - 2, 2));
      if (depth < 0.5) continue;
      EXPECT_LE(clay.value(key), 0.002) << toText(key) << " stiffness " << stiffness;
    }
  }
}

// Takai's column: pressed from above it gets shorter and wider, and nothing is left in the plate.
TEST(Promises, AColumnGivesWayUnderAPlate) {
  Clay clay;
  addSolid(clay, Shape::cylinder, {0, 12, 0}, {8, 12, 8});
  holdBox(clay, {-10, -2, -10}, {10, 1, 10});
  const double before = statistics(clay).mass;
  Push push = pushOf(Shape::box, {20, 3, 20}, 1);
  push.setup.settings.layers = {LayerKind::automaton};
  push.stroke.points = {{{0, 28, 0}, 1}, {{0, 19, 0}, 1}};
  run(clay, push);
  EXPECT_NEAR(statistics(clay).mass / before, 1, 1e-7);
  EXPECT_EQ(clay.value({0, 18, 0}), 0);
  EXPECT_EQ(clay.value({0, 23, 0}), 0);
  EXPECT_GT(clay.value({0, 14, 0}), 0.9);
  EXPECT_GT(clay.value({10, 13, 0}), 0.5);
}

// Where clay parts, what is left of a thread goes back to the clay; elsewhere only crumbs do.
TEST(Promises, ShredsAreEatenWhereClayParts) {
  const auto piecesAfter = [](double parting, glm::dvec3 lying) {
    Clay clay;
    addSolid(clay, Shape::box, {0, 0, 0}, {10, 5, 10});
    addSolid(clay, Shape::box, {-3, 10, 0}, lying);
    const double before = statistics(clay).mass;
    Push push = pushOf(Shape::ellipsoid, {4, 4, 4}, 0);
    push.setup.settings.parting = parting;
    push.stroke.points = {{{4, 11, 0}, 1}, {{4, 8, 0}, 1}};
    run(clay, push);
    EXPECT_NEAR(statistics(clay).mass / before, 1, 1e-7);
    return measure(clay).pieces;
  };
  EXPECT_EQ(piecesAfter(4, {4, 1, 0.6}), 1) << "a thread";
  EXPECT_EQ(piecesAfter(0, {4, 1, 0.6}), 2);
  EXPECT_EQ(piecesAfter(4, {2, 2, 2}), 2) << "a lump";
}

// Relief grows stroke by stroke, by strength, and the clay that it is made of lacks nowhere by
// much.
TEST(Promises, SlowSwellingAddsUp) {
  const auto heightAfter = [](int strokes, double strength) {
    Clay clay;
    addSolid(clay, Shape::box, {0, -10, 0}, {20, 10, 20});
    const double before = statistics(clay).mass;
    Edit<CornerBlock<8>> edit(clay.tree);
    for (int n = 0; n < strokes; ++n) {
      Stroke stroke;
      stroke.points = {{{-6, 0, 0}, 1}, {{6, 0, 0}, 1}};
      ClayStroke<8> swelling(edit, clay.scale, toolOf(Shape::ellipsoid, {7, 7, 7}),
                             {Role::swell, strength}, stroke, {});
      for (std::int64_t step = 0; step < swelling.stepCount(); ++step) swelling.step(step);
      swelling.finish();
      swelling.store();
    }
    edit.commit();
    EXPECT_NEAR(statistics(clay).mass / before, 1, 1e-7);
    EXPECT_EQ(measure(clay).pieces, 1);
    EXPECT_GT(clay.value({0, -5, 0}), 0.8);
    double height = 0;
    for (int j = 0; j < 20; ++j) height += std::min(1.0f, clay.value({0, j, 0}));
    return height;
  };
  const double one = heightAfter(1, 1), two = heightAfter(2, 1);
  EXPECT_GT(one, 1);
  EXPECT_GT(two, 1.6 * one);
  EXPECT_NEAR(heightAfter(1, 0.5), 0.5 * one, 0.4);
}

// Clay at rest is not gone over ten million times; what still moves is, as often as asked.
TEST(Promises, RelaxingEndsWhereNothingChanges) {
  const auto relaxed = [](int steps) {
    Clay clay;
    addSolid(clay, Shape::box, {0, 0, 0}, {6, 6, 6});
    addSolid(clay, Shape::box, {20, 0, 0}, {1, 4, 1});
    clay::Setup setup;
    Edit<CornerBlock<8>> edit(clay.tree);
    relax<8>(edit, clay.scale, setup, steps);
    edit.commit();
    return fieldHash(clay);
  };
  EXPECT_EQ(relaxed(10'000'000), relaxed(60));
  EXPECT_THROW(relaxed(10'000'001), Error);
}

// Runs it; how many cells its steps have looked at.
std::int64_t cellsOf(Clay& clay, const Push& push, double strength) {
  Edit<CornerBlock<8>> edit(clay.tree);
  ClayStroke<8> stroke(edit, clay.scale, push.tool, {push.role, strength}, push.stroke, push.setup);
  std::int64_t cells = 0;
  for (std::int64_t n = 0; n < stroke.stepCount(); ++n) cells += stroke.step(n).cells;
  stroke.finish();
  stroke.store();
  edit.commit();
  return cells;
}

// What the automaton loads does not depend on how much clay there is beyond its matter's way, and a
// region that grows on the way gives what one does that had the room from the start.
TEST(Promises, SlowTheAutomatonCostsWhatItReaches) {
  const auto pressed = [](double half, bool roomy, std::int64_t& cells) {
    Clay clay;
    addSolid(clay, Shape::box, {half, -half, half}, {half, half, half});
    Push push = pushOf(Shape::box, {9, 3, 9}, 1);
    push.setup.settings.layers = {LayerKind::automaton};
    push.stroke.points = {{{9, 4, 9}, 1}, {{9, 1, 9}, 1}};
    if (roomy) push.stroke.symmetry = {.mirror = {true, false, false}, .centre = {100, 0, 0}};
    cells = cellsOf(clay, push, 0.5);
    return clay;
  };
  std::int64_t small, huge, roomy;
  const Clay a = pressed(56, false, small), b = pressed(120, false, huge);
  EXPECT_EQ(small, huge);
  for (Key key{-30, -60, -30}; key.i < 60; ++key.i)
    for (key.j = -60; key.j < 20; ++key.j)
      for (key.k = -30; key.k < 60; ++key.k) ASSERT_EQ(a.value(key), b.value(key)) << toText(key);
  const Clay c = pressed(56, true, roomy);
  EXPECT_GT(roomy, small);
  EXPECT_EQ(fieldHash(a), fieldHash(c));
}

// Nor does what it loads where it pulls, nor what comes of that.
TEST(Promises, SlowAPullOfTheAutomatonCostsWhatItReaches) {
  const auto pulled = [](double half, std::int64_t& cells) {
    Clay clay;
    addSolid(clay, Shape::box, {half, -half, half}, {half, half, half});
    Push push = pushOf(Shape::ellipsoid, {6, 6, 6}, 1);
    push.role = Role::grip;
    push.setup.settings.layers = {LayerKind::automaton};
    push.stroke.points = {{{14, -1, 14}, 1}, {{14, 4, 14}, 1}};
    cells = cellsOf(clay, push, 1);
    return clay;
  };
  std::int64_t small, huge;
  const Clay a = pulled(40, small), b = pulled(64, huge);
  EXPECT_EQ(small, huge);
  EXPECT_GT(a.value({14, 2, 14}), 0.5f) << "it came along";
  for (Key key{-20, -60, -20}; key.i < 60; ++key.i)
    for (key.j = -60; key.j < 20; ++key.j)
      for (key.k = -20; key.k < 60; ++key.k) ASSERT_EQ(a.value(key), b.value(key)) << toText(key);
}

// The automaton pulls too: behind the grip a bar grows thinner, as a column grows thicker under a
// plate.
TEST(Promises, TheAutomatonPulls) {
  const auto section = [](const Clay& clay, int i) {
    double sum = 0;
    for (int n = 0; n < 17 * 17; ++n) sum += clay.value({i, n / 17 - 8, n % 17 - 8});
    return sum;
  };
  const auto beyond = [&](const Clay& clay, int i) {
    double sum = 0;
    for (int n = i; n < 40; ++n) sum += section(clay, n);
    return sum;
  };
  for (const double way : {3.0, 10.0}) {
    Clay clay;
    addSolid(clay, Shape::box, {0, 0, 0}, {20, 6, 6});
    holdBox(clay, {-30, -9, -9}, {-14, 9, 9});
    const Measures before = measure(clay);
    const double whole = section(clay, 0), held = beyond(clay, 15);
    Push push = pushOf(Shape::box, {4, 9, 9}, 1);
    push.role = Role::grip;
    push.setup.settings.layers = {LayerKind::automaton, LayerKind::tension};
    push.stroke.points = {{{17, 0, 0}, 1}, {{17 + way, 0, 0}, 1}};
    run(clay, push);
    const Measures after = measure(clay);
    const int behind = 12 + static_cast<int>(way / 3);
    EXPECT_NEAR(after.mass / before.mass, 1, 1e-7);
    EXPECT_LT(section(clay, behind), 0.95 * whole);
    EXPECT_GT(section(clay, behind), 0.3 * whole);
    EXPECT_NEAR(beyond(clay, 15 + static_cast<int>(way)), held, 0.02 * held)
        << "what is held comes along";
    EXPECT_EQ(section(clay, -14), whole) << "what is held stays";
    if (way < 5) {
      EXPECT_EQ(after.pieces, 1);
    }
  }
}

// A plate four, and one two cells thick, through a sheet: all the clay it meets stays ahead of it.
TEST(Promises, NothingTunnelsThroughTwoCells) {
  for (const double half : {1.0, 2.0}) {
    Clay clay;
    addSolid(clay, Shape::box, {0, 0, 0}, {16, 3, 16});
    Push push = pushOf(Shape::box, {11, half, 11}, 0.3);
    push.stroke.points = {{{0, 7, 0}, 1}, {{0, -7, 0}, 1}};
    run(clay, push);
    const int top = -7 + static_cast<int>(half);
    double behind = 0;
    for (int n = 0; n < 17 * 20 * 17; ++n)
      behind += clay.value({n / (20 * 17) - 8, n / 17 % 20 + top + 1, n % 17 - 8});
    EXPECT_LT(behind, 1) << 2 * half << " cells";
  }
}

// 200 pushes at random leave no crumb and no dust.
// Pushes of a ball, from somewhere round it to 12 cells from where its middle was.
void pushAbout(Clay& clay, double from, int pushes, const Settings& settings) {
  std::uint32_t state = 11;
  const auto random = [&] {
    state = state * 1664525u + 1013904223u;
    return static_cast<double>(state >> 8) / (1 << 24) * 2 - 1;
  };
  for (int n = 0; n < pushes; ++n) {
    Push push = pushOf(Shape::ellipsoid, {3, 3, 3}, 0.3);
    push.setup.settings = settings;
    glm::dvec3 way(random(), random(), random());
    way *= 1 / std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z + 1e-9);
    push.stroke.points = {{way * from, 1}, {way * 12.0, 1}};
    run(clay, push);
  }
}

void pushAbout(Clay& clay, double from) {
  pushAbout(clay, from, 200, pushOf(Shape::ellipsoid, {3, 3, 3}, 0.3).setup.settings);
}

void expectNoCrumbAndNoDust(const Clay& clay, const Measures& before) {
  const Measures after = measure(clay);
  EXPECT_NEAR(after.mass / before.mass, 1, 1e-6);
  EXPECT_EQ(after.pieces, 1);
  // Beside a clean body of the shape that has come out: its field with sharp edges.
  EXPECT_LT(static_cast<double>(after.stored), 1.5 * static_cast<double>(cleanCorners(clay)));
}

TEST(Promises, SlowTwoHundredPushesLeaveNoCrumbAndNoDust) {
  Clay clay;
  addSolid(clay, Shape::ellipsoid, {0, 0, 0}, {11, 11, 11});
  holdBox(clay, {-3, -3, -3}, {3, 3, 3});
  const Measures before = measure(clay);
  pushAbout(clay, 15);
  expectNoCrumbAndNoDust(clay, before);
}

// Sixty pushes from all sides with one layer that sends matter far leave one piece.
TEST(Promises, SlowLayersThatSendMatterFarLeaveNoCrumbs) {
  for (const LayerKind layer : {LayerKind::diffusion, LayerKind::automaton}) {
    Clay clay;
    addSolid(clay, Shape::ellipsoid, {0, 0, 0}, {11, 11, 11});
    const Measures before = measure(clay);
    pushAbout(clay, 15, 60, running({layer}));
    const Measures after = measure(clay);
    EXPECT_NEAR(after.mass / before.mass, 1, 1e-6) << toText(layer);
    EXPECT_EQ(piecesBelow(clay, Settings{}.crumb), 0) << toText(layer);
    EXPECT_LT(after.densest, 2) << toText(layer);
  }
}

// A free ball that is pushed about stays the ball it was.
TEST(Promises, SlowTwoHundredPushesCarryAFreeBallUnchanged) {
  Clay clay;
  addSolid(clay, Shape::ellipsoid, {0, 0, 0}, {11, 11, 11});
  Push first = pushOf(Shape::ellipsoid, {3, 3, 3}, 0.3);
  first.stroke.points = {{{40, 0, 0}, 1}, {{12, 0, 0}, 1}};
  run(clay, first);  // what was dust in the ball as it was made joins the rest
  const Measures before = measure(clay);
  pushAbout(clay, 40);
  expectNoCrumbAndNoDust(clay, before);
  const Measures after = measure(clay);
  EXPECT_NEAR(after.volume, before.volume, 1e-3);
  EXPECT_NEAR(after.thickness, before.thickness, 1e-3);
  EXPECT_GT(glm::length(after.centre - before.centre), 1);
}

}  // namespace
}  // namespace bozzetto::clay::testing
