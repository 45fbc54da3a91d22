// Strokes: sampling, pressure, symmetry, widening, refusals.
#include "tool/tool_fixture.hpp"

namespace bozzetto {
namespace {

using namespace testing;

constexpr double kHalf = 0.70710678118654752;

std::int64_t dabsOf(const Stroke& path, double radius = 8) {
  Clay clay;
  return stroke(clay, ball(radius), {}, path).report.dabs;
}

TEST(Stroke, resamplesByArcLength) {
  EXPECT_EQ(dabsOf(dabAt({1, 2, 3})), 1);
  EXPECT_EQ(dabsOf(lineOf({0, 0, 0}, {10, 0, 0})), 6);  // every 2, the end met exactly
  EXPECT_EQ(dabsOf(lineOf({0, 0, 0}, {9.9, 0, 0})), 5);
  EXPECT_EQ(dabsOf(lineOf({0, 0, 0}, {0, 0, 0})), 1);
  Stroke corner;
  corner.points = {{{0, 0, 0}, 1}, {{3, 0, 0}, 1}, {{3, 0, 0}, 1}, {{3, 5, 0}, 1}};
  EXPECT_EQ(dabsOf(corner), 5);  // 8 long: the rest of 1 carries on round the corner
}

TEST(Stroke, samplesLieOnTheLine) {
  const StrokePath path({{{0, 0, 0}, 1}, {{3, 0, 0}, 0.4}, {{3, 5, 0}, 0.9}}, 2);
  EXPECT_EQ(path.count(), 5);
  EXPECT_NEAR(glm::length(path.at(1).position - glm::dvec3(2, 0, 0)), 0, 1e-12);
  EXPECT_NEAR(path.at(1).pressure, 0.6, 1e-12);
  EXPECT_NEAR(glm::length(path.at(2).position - glm::dvec3(3, 1, 0)), 0, 1e-12);
  EXPECT_NEAR(path.at(2).pressure, 0.5, 1e-12);
  EXPECT_NEAR(glm::length(path.at(4).position - glm::dvec3(3, 5, 0)), 0, 1e-12);
}

TEST(Stroke, extraPointsOnTheLineChangeLittle) {
  Clay direct, detour;
  stroke(direct, ball(8), {}, lineOf({-20, 0, 0}, {20, 0, 0}));
  Stroke path;
  for (int n = 0; n <= 40; ++n) path.points.push_back({{n - 20.0, 0, 0}, 1});
  stroke(detour, ball(8), {}, path);
  EXPECT_EQ(fieldHash(direct), fieldHash(detour));
}

TEST(Stroke, pressureScalesStrengthAndSize) {
  Stroke half = dabAt({0, 0, 0});
  half.points[0].pressure = 0.5;
  half.pressure = {true, false};
  Clay pressed, weaker;
  stroke(pressed, ball(8), {ActionKind::add, 0.8, kToolColour}, half);
  stroke(weaker, ball(8), {ActionKind::add, 0.4, kToolColour}, dabAt({0, 0, 0}));
  EXPECT_EQ(fieldHash(pressed), fieldHash(weaker));

  half.pressure = {false, true};
  Clay small, smaller;
  stroke(small, ball(8), {ActionKind::add, 0.8, kToolColour}, half);
  stroke(smaller, ball(4), {ActionKind::add, 0.8, kToolColour}, dabAt({0, 0, 0}));
  EXPECT_EQ(fieldHash(small), fieldHash(smaller));

  half.points[0].pressure = 0;
  Clay none;
  stroke(none, ball(8), {}, half);
  EXPECT_TRUE(none.tree.empty());
}

// Every corner and its mirror image agree; to the bit where dabs do not overlap theirs.
void expectMirrored(const Clay& clay, int axis, float tolerance) {
  ASSERT_FALSE(clay.tree.empty());
  for (const auto& [key, sample] : samplesOf(clay)) {
    Key twin = key;
    twin[kAxes[static_cast<std::size_t>(axis)]] *= -1;
    ASSERT_NEAR(clay.value(twin), sample.value, tolerance) << toText(key);
  }
}

TEST(Stroke, mirrorsToTheBit) {
  for (int shape = 0; shape < 4; ++shape) {
    for (int axis = 0; axis < 3; ++axis) {
      Clay clay;
      Stroke path = lineOf({20.3, 20.1, 20.7}, {31, 29, 24});
      path.symmetry.mirror[static_cast<std::size_t>(axis)] = true;
      const auto made = stroke(clay, oblique(static_cast<Shape>(shape)),
                               {ActionKind::add, 0.5, kToolColour}, path);
      EXPECT_GT(made.report.dabs, 5);
      expectMirrored(clay, axis, 0);
    }
  }
}

TEST(Stroke, overlappingMirrorsAgreeUpToRounding) {
  Clay clay;
  Stroke path = lineOf({-5, 3, 0}, {6, 1, 4});
  path.symmetry.mirror = {true, false, true};
  stroke(clay, oblique(Shape::capsule), {ActionKind::add, 0.3, kToolColour}, path);
  expectMirrored(clay, 0, 1e-6f);
  expectMirrored(clay, 2, 1e-6f);
}

TEST(Stroke, dabsOnTheMirrorAreMadeOnce) {
  Clay once, mirrored;
  stroke(once, ball(6), {}, dabAt({0, 3, 1}));
  Stroke path = dabAt({0, 3, 1});
  path.symmetry.mirror = {true, false, false};
  stroke(mirrored, ball(6), {}, path);
  EXPECT_EQ(fieldHash(once), fieldHash(mirrored));
  // An oblique tool is not its own image: both are made.
  Clay slanted;
  const auto made = stroke(slanted, oblique(Shape::box), {}, path);
  Clay alone;
  EXPECT_EQ(made.report.total.visited,
            2 * stroke(alone, oblique(Shape::box), {}, dabAt({0, 3, 1})).report.total.visited);
  expectMirrored(slanted, 0, 1e-6f);
}

TEST(Stroke, radialCopiesAreTurned) {
  Clay clay;
  Stroke path = dabAt({24, 5, 3});
  path.symmetry.radialCount = 4;
  stroke(clay, oblique(Shape::cylinder), {}, path);
  for (const auto& [key, sample] : samplesOf(clay))
    ASSERT_NEAR(clay.value({key.k, key.j, -key.i}), sample.value, 1e-6);

  // On the axis a round tool is its own image, however often it is turned.
  Clay turned, once;
  path = dabAt({0, 5, 0});
  path.symmetry.radialCount = 7;
  ToolShape tool = ball(9);
  tool.shape = Shape::cylinder;
  stroke(turned, tool, {}, path);
  stroke(once, tool, {}, dabAt({0, 5, 0}));
  EXPECT_EQ(fieldHash(turned), fieldHash(once));
}

TEST(Stroke, imagesOfAllSymmetriesAreDistinct) {
  Symmetry all;
  all.mirror = {true, true, true};
  EXPECT_EQ(imagesOf(all).size(), 8u);
  all.radialCount = 2;  // a half turn about y is the mirrors in x and z together
  EXPECT_EQ(imagesOf(all).size(), 8u);
  all.radialCount = 3;
  EXPECT_EQ(imagesOf(all).size(), 24u);
}

TEST(Stroke, quarterTurnIsSwappedRadii) {
  Clay turned, swapped;
  ToolShape tool;
  tool.shape = Shape::box;
  tool.radii = {12, 5, 8};
  tool.rotation = glm::dquat(kHalf, 0, 0, kHalf);  // about z
  stroke(turned, tool, {}, dabAt({1.5, 2, 3.25}));
  tool.radii = {5, 12, 8};
  tool.rotation = glm::dquat(1, 0, 0, 0);
  stroke(swapped, tool, {}, dabAt({1.5, 2, 3.25}));
  EXPECT_EQ(fieldHash(turned), fieldHash(swapped));
}

TEST(Stroke, countsOfAnAlignedBall) {
  Clay clay;
  const auto total = stroke(clay, ball(8), {}, dabAt({0, 0, 0})).report.total;
  EXPECT_EQ(total.visited, 17 * 17 * 17);
  EXPECT_EQ(total.computed, 17 * 17 * 17);
  EXPECT_EQ(total.dirty, statistics(clay).corners);
}

TEST(Stroke, countsOfATurnedBox) {
  ToolShape tool = oblique(Shape::box);
  Clay clay;
  const auto total = stroke(clay, tool, {}, dabAt({0.5, 0, 0})).report.total;
  std::int64_t computed = 0;
  const glm::dquat back = glm::inverse(glm::normalize(tool.rotation));
  for (int i = -16; i <= 16; ++i)
    for (int j = -16; j <= 16; ++j)
      for (int k = -16; k <= 16; ++k) {
        const glm::dvec3 p = glm::abs(back * (glm::dvec3(i, j, k) - glm::dvec3(0.5, 0, 0)));
        computed += p.x <= tool.radii.x && p.y <= tool.radii.y && p.z <= tool.radii.z;
      }
  EXPECT_EQ(total.computed, computed);
}

TEST(Stroke, narrowToolsAreWidenedAndSaySo) {
  Clay widened, two;
  ToolShape tool = ball(2);
  tool.radii = {0.5, 6, 1};
  const auto made = stroke(widened, tool, {}, dabAt({0, 0, 0}));
  EXPECT_NE(made.report.notice.find("widened to 2"), std::string::npos);
  tool.radii = {2, 6, 2};
  EXPECT_EQ(stroke(two, tool, {}, dabAt({0, 0, 0})).report.notice, "");
  EXPECT_EQ(fieldHash(widened), fieldHash(two));
}

TEST(Stroke, limitOfInfluenceIsTheShape) {
  for (int n = 0; n < 4; ++n) {
    ToolShape tool;
    tool.shape = static_cast<Shape>(n);
    tool.radii = {20, 30, 10};
    Clay clay;
    stroke(clay, tool, {ActionKind::add, 1, {}}, dabAt({0, 0, 0}));
    const KeyBox bounds = statistics(clay).bounds;
    EXPECT_EQ(bounds.high, (Key{19, 29, 9})) << n;  // the potential is 0 on the limit itself
    EXPECT_EQ(bounds.low, (Key{-19, -29, -9})) << n;
    const bool edge = clay.value({19, 29, 0}) > 0, corner = clay.value({17, 27, 7}) > 0;
    const bool side = clay.value({19, 15, 0}) > 0;
    EXPECT_EQ(edge, tool.shape == Shape::cylinder || tool.shape == Shape::box) << n;
    EXPECT_EQ(corner, tool.shape == Shape::box) << n;
    EXPECT_EQ(side, tool.shape != Shape::ellipsoid) << n;
  }
}

TEST(Stroke, refusesBadInput) {
  const double nan = std::nan(""), infinite = HUGE_VAL;
  const auto refuses = [](const ToolShape& tool, const ActionOptions& action, const Stroke& path) {
    Clay clay;
    EXPECT_THROW(stroke(clay, tool, action, path), Error);
    EXPECT_TRUE(clay.tree.empty());
  };
  for (const double bad : {0.0, -3.0, nan, infinite, 4097.0}) refuses(ball(bad), {}, dabAt({}));
  ToolShape tool = ball(8);
  for (const double bad : {0.0, nan, infinite}) {
    tool.rotation = glm::dquat(bad, 0, 0, 0);
    refuses(tool, {}, dabAt({}));
  }
  for (const double bad : {-0.1, 1.5, nan}) refuses(ball(8), {ActionKind::add, bad, {}}, dabAt({}));
  for (const double bad : {nan, infinite, -2e9, 0x1p30}) refuses(ball(8), {}, dabAt({0, 0, bad}));
  refuses(ball(8), {}, lineOf({0, 0, 0}, {0, 0x1p30 - 4, 0}));  // too many dabs, and no room
  refuses(ball(8), {}, lineOf({0, -9e8, 0}, {0, 9e8, 0}));
  refuses(ball(8), {}, {});
  Stroke path = lineOf({0, 0, 0}, {9, 0, 0});
  for (const double bad : {0.0, -1.0, nan, infinite}) {
    path.spacing = bad;
    refuses(ball(8), {}, path);
  }
  path = dabAt({});
  for (const double bad : {-0.5, 1.5, nan}) {
    path.points[0].pressure = bad;
    refuses(ball(8), {}, path);
  }
  path = dabAt({});
  for (const int bad : {0, -1, 100000}) {
    path.symmetry.radialCount = bad;
    refuses(ball(8), {}, path);
  }
  path = dabAt({0x1p29, 0, 0});
  path.symmetry.mirror = {true, false, false};
  path.symmetry.centre = {-0x1p29, 0, 0};  // the image is outside
  refuses(ball(8), {}, path);
}

struct StopAt : Progress {
  double limit;
  explicit StopAt(double at) : limit(at) {}
  bool report(std::string_view, double done) override { return done < limit; }
};

TEST(Stroke, cancellingLeavesTheClayAlone) {
  Clay clay = clayBall<8>(20);
  const auto hash = fieldHash(clay);
  Edit<CornerBlock<8>> edit(clay.tree);
  StrokeRunner<8> runner(edit, clay.scale, ball(9), {}, lineOf({-30, 0, 0}, {30, 5, 0}));
  StopAt half(0.5);
  EXPECT_THROW(applyStroke(runner, half), Cancelled);
  EXPECT_TRUE(edit.commit().empty());
  EXPECT_EQ(fieldHash(clay), hash);
}

TEST(Names, readBack) {
  for (int n = 0; n < 6; ++n) {
    const auto kind = static_cast<ActionKind>(n);
    EXPECT_EQ(actionNamed(toText(kind)), kind);
  }
  for (int n = 0; n < 4; ++n) {
    const auto shape = static_cast<Shape>(n);
    EXPECT_EQ(shapeNamed(toText(shape)), shape);
  }
  EXPECT_EQ(profileNamed("box"), Profile::box);
  EXPECT_EQ(actionNamed("paint_soft"), ActionKind::paintSoft);
  EXPECT_EQ(shapeNamed("cone"), std::nullopt);
}

}  // namespace
}  // namespace bozzetto
