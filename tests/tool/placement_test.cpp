// How dabs stand: turned, scattered, rolled, repeated, snapped, anchored.
#include "bozzetto/tool/sculpture.hpp"
#include "tool/tool_fixture.hpp"

namespace bozzetto {
namespace {

using namespace testing;

// A needle along the tool's z with its tip at the pivot, the contact side.
ToolShape needle() {
  Clay clay;
  fillInto(clay, Primitive{Shape::box, {0, 0, 10}, {2, 2, 10}, {1, 0, 0, 0}, {}});
  ToolShape tool;
  tool.shape = Shape::freeform;
  tool.sculpture = std::make_shared<Sculpture>(clay, SculptureOptions{.pivot = glm::dvec3(0)});
  return tool;
}

ActionOptions addAll() { return {ActionKind::add, 1, kToolColour}; }

Clay drawn(const ToolShape& tool, const Stroke& path, const Clay& from = {}) {
  Clay clay = from;
  stroke(clay, tool, addAll(), path);
  return clay;
}

TEST(Placement, standsOnTheSurface) {
  const Clay body = clayBall<8>(20);
  Stroke path = dabAt({20, 0, 0});
  path.placement.toNormal = true;
  EXPECT_GT(drawn(needle(), path, body).value({36, 0, 0}), 0.9f);
  path = dabAt({0, -20, 0});
  path.placement.toNormal = true;
  EXPECT_GT(drawn(needle(), path, body).value({0, -36, 0}), 0.9f);
}

TEST(Placement, pointsWhereTheStrokeGoes) {
  Clay leaf;  // long along y, thin along z
  fillInto(leaf, Primitive{Shape::box, {0, 0, 0}, {3, 12, 1.5}, {1, 0, 0, 0}, {}});
  ToolShape tool;
  tool.shape = Shape::freeform;
  tool.sculpture = std::make_shared<Sculpture>(leaf);
  Stroke path = lineOf({0, 0, 0}, {0.5, 0, 0});
  path.placement.alongStroke = true;
  path.spacing = 0.1;
  const Clay clay = drawn(tool, path);
  EXPECT_GT(clay.value({10, 0, 0}), 0.9f);
  EXPECT_EQ(clay.value({0, 10, 0}), 0);
}

TEST(Placement, jitterIsTheSeeds) {
  const auto hash = [](std::uint64_t seed) {
    Stroke path = lineOf({0, 0, 0}, {60, 0, 0});
    path.placement.jitter = {0.8, 0.5, 180, seed};
    const Clay clay = drawn(needle(), path);
    EXPECT_EQ(validate(clay), std::nullopt);
    return fieldHash(clay);
  };
  EXPECT_EQ(hash(3), hash(3));
  EXPECT_NE(hash(3), hash(4));
}

TEST(Placement, rollsWithoutSliding) {
  Clay wheel;  // a gear's tooth: the end of a spoke that points along the contact direction
  fillInto(wheel, Primitive{Shape::box, {0, 0, -7}, {1.5, 1.5, 1.5}, {1, 0, 0, 0}, {}});
  fillInto(wheel, Primitive{Shape::box, {0, 0, 7}, {1.5, 1.5, 1.5}, {1, 0, 0, 0}, {}});
  ToolShape tool;
  tool.shape = Shape::freeform;
  tool.sculpture = std::make_shared<Sculpture>(wheel);
  const double radius = tool.sculpture->halfExtents().z;
  const double quarter = radius * 3.14159265358979 / 2;  // of a turn
  Stroke path = lineOf({0, 0, 0}, {quarter, 0, 0});
  path.placement.roll = 1;
  path.spacing = quarter / tool.sculpture->halfExtents().x;
  const Clay clay = drawn(tool, path);
  const int end = int(std::lround(quarter));
  EXPECT_GT(clay.value({0, 0, -7}), 0.9f);
  EXPECT_GT(clay.value({end + 7, 0, 0}), 0.5f);  // the spoke lies now
  EXPECT_EQ(clay.value({end, 0, 7}), 0);
}

TEST(Placement, copiesAndGrid) {
  Stroke path = lineOf({0.4, 0, 0}, {21, 0, 0});
  path.placement.grid = 10;
  path.spacing = 0.5;
  const Clay snapped = drawn(ball(4), path);
  for (const int x : {0, 10, 20}) EXPECT_EQ(snapped.value({x, 0, 0}), 1) << x;
  EXPECT_EQ(snapped.value({5, 0, 0}), 0);

  Stroke one = dabAt({0, 0, 0});
  one.placement.copies = {3, 1, 2};
  one.placement.copyStep = {12, 0, 20};
  const Clay copies = drawn(ball(4), one);
  for (const int x : {0, 12, 24})
    for (const int z : {0, 20}) EXPECT_EQ(copies.value({x, 0, z}), 1);
  Stroke far = lineOf({0, 0, 0}, {24, 0, 0});
  far.placement.copies[2] = 5000;
  Clay clay;
  EXPECT_THROW(stroke(clay, ball(4), addAll(), far), Error);
}

// The first needle stands on a ball of radius 20 at (12, 16, 0), another at (12, −16, 0).
Stroke twoNeedles() {
  Stroke path = dabAt({12, 16, 0});
  path.placement.toNormal = true;
  return path;
}

void expectBothStandUp(const Clay& clay) {
  EXPECT_GT(clay.value({21, 28, 0}), 0.9f);
  EXPECT_GT(clay.value({21, -28, 0}), 0.9f);
  EXPECT_EQ(clay.value({3, -28, 0}), 0);  // as the first, turned
  EXPECT_EQ(clay.value({21, -4, 0}), 0);  // as the first, moved
}

TEST(Placement, copiesFaceTheClayWhereTheyStand) {
  Stroke path = twoNeedles();
  path.placement.copies[1] = 2;
  path.placement.copyStep = {0, -32, 0};
  expectBothStandUp(drawn(needle(), path, clayBall<8>(20)));
}

TEST(Placement, radialCopiesFaceTheClayWhereTheyStand) {
  Stroke path = twoNeedles();
  path.symmetry.centre = {12, 0, 0};
  path.symmetry.radialAxis = Axis::z;
  path.symmetry.radialCount = 2;
  expectBothStandUp(drawn(needle(), path, clayBall<8>(20)));
}

// What mirrors is the mirror of what it mirrors, in all four quarters.
TEST(Placement, mirroredRadialCopiesAreMirrors) {
  Stroke path = dabAt({8, 14, 5});
  path.placement.toNormal = true;
  path.symmetry.centre = {4, 0, 0};
  path.symmetry.radialAxis = Axis::z;
  path.symmetry.radialCount = 2;
  path.symmetry.mirror[1] = true;
  const Clay clay = drawn(needle(), path, clayBall<8>(20));
  for (const auto& [at, sample] : samplesOf(clay))
    ASSERT_EQ(sample.value, clay.value({at.i, -at.j, at.k}));
}

// On symmetric clay they are images of the first, to the bit.
TEST(Placement, onSymmetricClayRadialCopiesAreAlike) {
  Stroke path = dabAt({13, 16, 3});
  path.placement.toNormal = true;
  path.symmetry.radialAxis = Axis::z;
  path.symmetry.radialCount = 4;
  const Clay clay = drawn(needle(), path, clayBall<8>(20));
  for (const auto& [at, sample] : samplesOf(clay))
    ASSERT_EQ(sample.value, clay.value({-at.i, -at.j, at.k}));
}

TEST(Placement, anchoredDabsTakeTheirSizeFromTheDrag) {
  Stroke path = lineOf({0, 0, 0}, {20, 0, 0});
  path.placement.anchored = true;
  const Clay clay = drawn(ball(5), path);
  EXPECT_GT(clay.value({12, 0, 0}), 0.1f);  // a ball of radius 20, one dab
  EXPECT_GT(clay.value({-12, 0, 0}), 0.1f);
  EXPECT_EQ(clay.value({21, 0, 0}), 0);
}

TEST(Placement, anchoredDabsEndWhereToolsDo) {
  Stroke path = lineOf({0, 0, 0}, {1e6, 0, 0});
  path.placement.anchored = true;
  ToolShape thin = ball(5);
  thin.radii = {2000, 2, 2};  // may grow to 4096 cells only
  const Clay clay = drawn(thin, path);
  EXPECT_GT(clay.value({4000, 0, 0}), 0);
  EXPECT_EQ(clay.value({4097, 0, 0}), 0);
}

}  // namespace
}  // namespace bozzetto
