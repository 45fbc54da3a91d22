// Laws: what holds whatever is done to the clay.
#include "bozzetto/base/parallel.hpp"
#include "bozzetto/clay/hold.hpp"
#include "bozzetto/tool/shape.hpp"
#include "bozzetto/tool/solid.hpp"
#include "clay/clay_fixture.hpp"

namespace bozzetto::clay::testing {
namespace {

Clay slab() {
  Clay clay;
  addSolid(clay, Shape::box, {0, 0, 0}, {18, 7, 14});
  return clay;
}

// A press that slides and turns.
Push press(double stiffness = 0.6) {
  Push push{toolOf(Shape::capsule, {5, 9, 4}), Role::push, {}, {}};
  push.stroke.points = {{{-6, 17, 0}, 1}, {{-6, 11, 0}, 1}, {{4, 9.5, 2}, 1}};
  push.stroke.rotations = {{1, 0, 0, 0}, {0.9, 0, 0.2, 0.1}, {0.8, 0.2, 0.3, 0}};
  push.setup.settings.stiffness = stiffness;
  return push;
}

std::uint64_t after(Clay clay, const Push& push) {
  run(clay, push);
  EXPECT_EQ(validate(clay), std::nullopt);
  return fieldHash(clay);
}

Settings layersOf(std::vector<LayerKind> layers, Scheme scheme = Scheme::projected) {
  Settings settings;
  settings.layers = std::move(layers);
  settings.scheme = scheme;
  return settings;
}

const std::vector<Settings>& everyKind() {
  using enum LayerKind;
  static const std::vector<Settings> all = [] {
    std::vector<Settings> kinds{
        layersOf({displacement, conservation, tension}),
        layersOf({displacement, conservation, tension}, Scheme::paper),
        layersOf({displacement, conservation, tension}, Scheme::paperSweeps),
        layersOf({displacement}),
        layersOf({tension, conservation}),
        layersOf({diffusion}),
        layersOf({automaton}),
        layersOf({displacement, automaton, tension, diffusion})};
    Settings viscous = layersOf({diffusion});
    viscous.viscosity = 4;
    viscous.profile = kGaussian;
    kinds.push_back(viscous);
    return kinds;
  }();
  return all;
}

TEST(Laws, SlowMatterIsKeptByEveryLayer) {
  for (const Settings& settings : everyKind()) {
    Clay clay = slab();
    const double before = statistics(clay).mass;
    Push push = press();
    push.setup.settings = settings;
    run(clay, push);
    EXPECT_NEAR(statistics(clay).mass / before, 1, 1e-7) << toText(settings.layers.front());
    EXPECT_EQ(validate(clay), std::nullopt);
  }
}

TEST(Laws, SlowThreadsDoNotShow) {
  for (const Settings& settings : everyKind()) {
    Push push = press();
    push.setup.settings = settings;
    setThreadCount(1);
    const std::uint64_t one = after(slab(), push);
    setThreadCount(3);
    const std::uint64_t three = after(slab(), push);
    setThreadCount(0);
    EXPECT_EQ(one, three) << toText(settings.layers.front());
  }
}

TEST(Laws, SlowBlocksOfOneCornerGiveTheSame) {
  Field<1> single = withSide<1>(slab());
  const Push push = press();
  Edit<CornerBlock<1>> edit(single.tree);
  ClayStroke<1> stroke(edit, single.scale, push.tool, {push.role, 0.5}, push.stroke, push.setup);
  for (std::int64_t n = 0; n < stroke.stepCount(); ++n) stroke.step(n);
  stroke.finish();
  stroke.store();
  edit.commit();
  EXPECT_EQ(fieldHash(single), after(slab(), push));
}

// The same way, asked four times as often (30 or 120 points a second).
TEST(Laws, SamplingDoesNotShow) {
  Push rare = press(), dense = press();
  rare.stroke.rotations.clear();
  dense.stroke.rotations.clear();
  dense.stroke.points.clear();
  for (std::size_t n = 0; n + 1 < rare.stroke.points.size(); ++n)
    for (int k = 0; k < 4; ++k)
      dense.stroke.points.push_back(
          {glm::mix(rare.stroke.points[n].position, rare.stroke.points[n + 1].position, k / 4.0),
           1});
  dense.stroke.points.push_back(rare.stroke.points.back());
  EXPECT_EQ(after(slab(), rare), after(slab(), dense));
}

TEST(Laws, PointsThatComeLaterGiveTheSameStroke) {
  Push push = press();
  push.stroke.rotations.clear();
  Clay clay = slab();
  Edit<CornerBlock<8>> edit(clay.tree);
  Stroke begin = push.stroke;
  begin.points.resize(1);
  ClayStroke<8> stroke(edit, clay.scale, push.tool, {push.role, 0.5}, begin, push.setup);
  std::int64_t made = 0;
  for (std::size_t n = 1; n < push.stroke.points.size(); ++n) {
    stroke.extend({&push.stroke.points[n], 1});
    while (made < stroke.sureSteps()) stroke.step(made++);
    stroke.store();
  }
  while (made < stroke.stepCount()) stroke.step(made++);
  stroke.finish();
  stroke.store();
  edit.commit();
  EXPECT_EQ(fieldHash(clay), after(slab(), push));
}

TEST(Laws, SlowStrokesMoveWithTheGrid) {
  Clay far;
  const glm::dvec3 way(1 << 20, -(1 << 20), 1 << 18);
  addSolid(far, Shape::box, way, {18, 7, 14});
  Push push = press();
  for (StrokePoint& point : push.stroke.points) point.position += way;
  run(far, push);
  Clay near = slab();
  run(near, press());
  const Key moved{1 << 20, -(1 << 20), 1 << 18};
  for (int n = 0; n < 40 * 24 * 32; n += 7) {
    const Key key{n / (24 * 32) - 20, n / 32 % 24 - 12, n % 32 - 16};
    ASSERT_EQ(near.value(key), far.value(key + moved)) << toText(key);
  }
}

TEST(Laws, SlowHeldClayStays) {
  for (const Settings& settings : everyKind()) {
    Clay clay = slab();
    {
      Edit<CornerBlock<8>> edit(clay.tree);
      holdClay<8>(edit, {{-30, -30, -30}, {-2, 30, 30}}, 1);
      edit.commit();
    }
    const Clay before = clay;
    Push push = press();
    push.setup.settings = settings;
    run(clay, push);
    for (int n = 0; n < 16 * 24 * 32; ++n) {
      const Key key{n / (24 * 32) - 18, n / 32 % 24 - 12, n % 32 - 16};
      if (before.value(key) > 0) {
        ASSERT_EQ(before.value(key), clay.value(key)) << toText(key);
      }
    }
  }
}

// Hold between 0 and 1 is painted stiffness: α(1 − hold), cell by cell (Dewaele §3.1.3).
TEST(Laws, PaintedStiffnessTakesFromTheGlobalOne) {
  const auto movedBy = [](double stiffness, double hold) {
    Clay clay;
    addSolid(clay, Shape::box, {0, 0, 0}, {20, 5, 5});
    holdBox(clay, {-30, -9, -9}, {-12, 9, 9});
    Edit<CornerBlock<8>> edit(clay.tree);
    holdClay<8>(edit, {{-11, -9, -9}, {30, 9, 9}}, hold);
    edit.commit();
    Push push{toolOf(Shape::box, {3, 8, 8}), Role::push, {}, {}};
    push.setup.settings.stiffness = stiffness;
    push.setup.settings.layers = {LayerKind::displacement};
    push.stroke.points = {{{18, 0, 0}, 1}, {{18, 6, 0}, 1}};
    const double before = measure(clay).centre.y;
    run(clay, push);
    return measure(clay).centre.y - before;
  };
  const double whole = movedBy(1, 0);
  EXPECT_GT(whole, 0.5);
  EXPECT_NEAR(movedBy(1, 0.6) / whole, movedBy(0.4, 0) / whole, 0.03);
  EXPECT_LT(movedBy(1, 0.6), 0.6 * whole);
}

TEST(Laws, ReleasedClayIsAsItWas) {
  Clay clay = slab();
  const std::uint64_t before = fieldHash(clay);
  Edit<CornerBlock<8>> edit(clay.tree);
  holdClay<8>(edit, {{-9, -9, -9}, {5, 5, 5}}, 0.5);
  edit.commit();
  EXPECT_EQ(holdOf(clay.attributes({0, 0, 0})), 128);
  EXPECT_EQ(holdOf(clay.attributes({6, 0, 0})), 0);
  releaseClay<8>(edit);
  edit.commit();
  EXPECT_EQ(fieldHash(clay), before);
  EXPECT_THROW(holdClay<8>(edit, {}, 2), Error);
}

// What the tool covers wholly is empty where the clay has room to go.
TEST(Laws, SlowToolsLeaveNoRoom) {
  for (const double stiffness : {0.0, 0.5, 1.0}) {
    Clay clay;
    addSolid(clay, Shape::ellipsoid, {0, 0, 0}, {20, 20, 20});
    holdBox(clay, {-30, -30, -30}, {30, -12, 30});
    Push push{toolOf(Shape::ellipsoid, {7, 7, 7}), Role::push, {}, {}};
    push.setup.settings.stiffness = stiffness;
    push.stroke.points = {{{0, 30, 0}, 1}, {{0, 20, 3}, 1}};
    run(clay, push);
    for (int n = 0; n < 9 * 9 * 9; ++n) {
      const Key key{n / 81 - 4, n / 9 % 9 + 16, n % 9 - 1};
      const double i = key.i, j = key.j - 20, k = key.k - 3;
      if (i * i + j * j + k * k > 6 * 6) continue;
      EXPECT_LT(clay.value(key), 0.01) << toText(key) << " stiffness " << stiffness;
    }
  }
}

TEST(Laws, NothingTunnelsThroughThinTools) {
  Clay clay;
  addSolid(clay, Shape::box, {0, 0, 0}, {14, 3, 14});
  Push push{toolOf(Shape::box, {9, 2, 9}), Role::push, {}, {}};
  push.setup.settings.stiffness = 0.3;
  push.stroke.points = {{{0, 8, 0}, 1}, {{0, -8, 0}, 1}};
  run(clay, push);
  double above = 0;
  for (int n = 0; n < 13 * 8 * 13; ++n)
    above += clay.value({n / (8 * 13) - 6, n / 13 % 8 - 5, n % 13 - 6});
  EXPECT_LT(above, 1);
}

template <class Callback>
void forCorners(const Clay& clay, const Callback& callback) {
  for (const auto& [key, run] : clay.tree)
    for (std::int32_t n = 0; n < run.length * 512; ++n)
      callback(key * 8 + Key{n / 64 % 8, n / 8 % 8, n % 8 + n / 512 * 8},
               run.block->value[std::size_t(n % 512)]);
}

// Both ends of a carried ball stay as smooth as it began: no row of cells takes from its
// neighbours.
TEST(Laws, SlowWhatAGripCarriesGrowsNoThorns) {
  Clay clay;
  addSolid(clay, Shape::ellipsoid, {0, 0, 0}, {13, 13, 13});
  Push push{toolOf(Shape::ellipsoid, {20, 20, 20}), Role::grip, {}, {}};
  push.setup.settings.stiffness = 1;
  push.stroke.points = {{{0, 0, 0}, 1}, {{80, 0, 0}, 1}};
  run(clay, push);
  double farthest = 0, nearest = 100;
  forCorners(clay, [&](Key key, float value) {
    const double distance = glm::length(glm::dvec3(key.i - 80, key.j, key.k));
    if (value >= 0.5f) farthest = std::max(farthest, distance);
    if (value < 0.5f) nearest = std::min(nearest, distance);
  });
  EXPECT_LT(farthest, 14);
  EXPECT_GT(nearest, 12);
}

// An angle, turned and half as large again, that a ball is pushed against.
Push againstAnAngle() {
  Clay angle;
  addSolid(angle, Shape::box, {0, -8, 0}, {12, 4, 9});
  addSolid(angle, Shape::box, {8, 2, 0}, {4, 12, 9});
  Support support{Shape::freeform, {12, -16, 0}, {}, {0.96, 0.1, 0, 0.2}};
  support.sculpture = std::make_shared<const Sculpture>(std::move(angle));
  support.radii = freeformRadii(*support.sculpture, glm::dvec3(1.5));
  Push push{toolOf(Shape::ellipsoid, {9, 9, 9}), Role::push, {}, {}};
  push.setup.supports = {support};
  push.stroke.points = {{{-22, 18, 0}, 1}, {{-8, 8, 2}, 1}};
  return push;
}

TEST(Laws, SlowClayDoesNotEnterSculptedSupports) {
  const Push push = againstAnAngle();
  const Support& support = push.setup.supports[0];
  DabPose pose;
  pose.position = support.centre;
  pose.orientation = glm::mat3_cast(normalisedRotation(support.rotation));
  pose.radii = support.radii;
  const auto solid = makeSolid(support.sculpture, pose);
  const auto standing = [&](const Clay& clay, double depth) {
    double found = 0;
    forCorners(clay, [&](Key key, float value) {
      const Key local = key - solid->cell;
      if (solid->distance({local.i, local.j, local.k}) < depth) found += double(value);
    });
    return found;
  };
  for (const double stiffness : {0.0, 0.7}) {
    Clay clay;
    addSolid(clay, Shape::ellipsoid, {-4, 4, 0}, {11, 11, 11});
    const Measures before = measure(clay);
    const double touching = standing(clay, 2);
    Push each = push;
    each.setup.settings.stiffness = stiffness;
    run(clay, each);
    EXPECT_LT(standing(clay, -1), 0.5) << stiffness;
    if (stiffness > 0) {
      EXPECT_GT(standing(clay, 2), 1.5 * touching + 50) << "clay has been pressed against it";
    }
    EXPECT_NEAR(measure(clay).volume / before.volume, 1, 0.03) << stiffness;
    EXPECT_NEAR(measure(clay).mass / before.mass, 1, 1e-7);
  }
}

TEST(Laws, SlowThreadsDoNotShowAtSculptedSupports) {
  std::uint64_t one = 0;
  for (const int threads : {1, 2, 3, 4}) {
    setThreadCount(threads);
    Clay clay;
    addSolid(clay, Shape::ellipsoid, {-4, 4, 0}, {11, 11, 11});
    const std::uint64_t hash = after(clay, againstAnAngle());
    if (threads == 1) one = hash;
    EXPECT_EQ(hash, one) << threads;
  }
  setThreadCount(0);
}

TEST(Laws, ColoursTravelWithTheClay) {
  Clay clay;
  addSolid(clay, Shape::box, {0, 0, 0}, {10, 6, 6}, {200, 0, 0});
  addSolid(clay, Shape::box, {20, 0, 0}, {10.5, 6, 6}, {0, 0, 200});
  Push push{toolOf(Shape::box, {40, 10, 10}), Role::grip, {}, {}};
  push.setup.settings.stiffness = 1;
  push.stroke.points = {{{10, 0, 0}, 1}, {{10, 0, 15}, 1}};
  run(clay, push);
  EXPECT_EQ(colourOf(clay.attributes({0, 0, 15})), (Colour{200, 0, 0}));
  EXPECT_EQ(colourOf(clay.attributes({20, 0, 15})), (Colour{0, 0, 200}));
  EXPECT_LT(measure(clay).thickness, 2.6);
}

TEST(Laws, FreePiecesMoveRigidly) {
  Clay clay;
  addSolid(clay, Shape::ellipsoid, {0, 0, 0}, {13, 13, 13});
  const Measures before = measure(clay);
  Push push{toolOf(Shape::box, {20, 20, 20}), Role::grip, {}, {}};
  push.setup.settings.stiffness = 0.5;
  push.stroke.points = {{{0, 0, 0}, 1}, {{16, 12, 0}, 1}};
  run(clay, push);
  const Measures after = measure(clay);
  EXPECT_NEAR(after.volume / before.volume, 1, 0.01);
  EXPECT_LT(after.thickness, 2.3);
  EXPECT_NEAR(after.centre.x - before.centre.x, 16, 0.05);
  EXPECT_NEAR(after.centre.y - before.centre.y, 12, 0.05);
}

// The largest difference between a cell and its mirror image.
double asymmetryUnder(const Settings& settings) {
  Clay clay = slab();
  Push push{toolOf(Shape::ellipsoid, {5, 5, 5}), Role::push, {}, {}};
  push.stroke.points = {{{9, 16, 0}, 1}, {{9, 8, 0}, 1}};
  push.stroke.symmetry.mirror[0] = true;
  push.setup.settings = settings;
  run(clay, push);
  double worst = 0;
  for (int n = 0; n < 26 * 32 * 36; ++n) {
    const Key key{n / (32 * 36), n / 36 % 32 - 12, n % 36 - 18};
    worst = std::max(
        worst, std::abs(static_cast<double>(clay.value(key)) - clay.value({-key.i, key.j, key.k})));
  }
  return worst;
}

TEST(Laws, MirroredStrokesGiveMirroredClay) {
  using enum LayerKind;
  EXPECT_LT(asymmetryUnder({}), 0.05);
  EXPECT_EQ(asymmetryUnder(layersOf({conservation}, Scheme::paperSweeps)), 0);
  EXPECT_GT(asymmetryUnder(layersOf({conservation}, Scheme::paper)), 0.01) << "the queue's order";
}

TEST(Laws, RefusesWhatMakesNoSense) {
  Clay clay = slab();
  Edit<CornerBlock<8>> edit(clay.tree);
  Push push = press();
  push.stroke.rotations.pop_back();
  const auto begin = [&] {
    ClayStroke<8>(edit, clay.scale, push.tool, {push.role, 0.5}, push.stroke, push.setup);
  };
  EXPECT_THROW(begin(), Error);
  push = press();
  push.setup.settings.stiffness = 2;
  EXPECT_THROW(begin(), Error);
  push = press();
  push.setup.supports = {{Shape::box, {0, 0, 0}, {0, 1, 1}, {1, 0, 0, 0}}};
  EXPECT_THROW(begin(), Error);
  push = press();
  push.stroke.points.clear();
  push.stroke.rotations.clear();
  EXPECT_THROW(begin(), Error);
}

TEST(Laws, RefusesSurroundingsBeyondItsCounts) {
  Clay clay = slab();
  Push push{toolOf(Shape::ellipsoid, {380, 380, 380}), Role::push, {}, {}};
  push.setup.settings.stiffness = 0;
  push.stroke.points = {{{0, 380, 0}, 1}};
  std::string told;
  try {
    run(clay, push);
  } catch (const Error& error) {
    told = error.what();
  }
  EXPECT_NE(told.find("cells found round the tool"), std::string::npos) << told;
  EXPECT_EQ(fieldHash(clay), fieldHash(slab()));
}

}  // namespace
}  // namespace bozzetto::clay::testing
