// Where the tool of a stroke goes, its stamps leave a trench: nothing rises in it again. And rims
// of conserving stamps are as smooth as others.
#include "bozzetto/tool/sculpture.hpp"
#include "tool/swept.hpp"
#include "tool/tool_fixture.hpp"

namespace bozzetto {
namespace {

using namespace testing;

// A block of clay whose top is the plane y = 0.
Clay slab() {
  Clay field;
  fillInto(field, {Shape::box, {0, -24, 0}, {60, 24, 40}, {1, 0, 0, 0}, kBallColour});
  return field;
}

ActionOptions stamp(bool conserving = false) {
  ActionOptions action{ActionKind::stamp, 1, kToolColour};
  action.stamp.conserving = conserving;
  return action;
}

// Two feet one behind the other, as of a letter that is led along x.
ToolShape feet() {
  Clay clay;
  for (const double x : {-10.0, 10.0})
    fillInto(clay, {Shape::box, {x, 0, 0}, {3, 8, 6}, {1, 0, 0, 0}, kBallColour});
  ToolShape tool;
  tool.shape = Shape::freeform;
  tool.sculpture = std::make_shared<Sculpture>(clay);
  return tool;
}

// Where the surface is above (x, z), in cells.
double heightAt(const Clay& clay, int x, int z) {
  for (int y = 30; y > -47; --y) {
    const double below = clay.value({x, y, z}), above = clay.value({x, y + 1, z});
    if (below >= 0.5 && above < 0.5) return y + (below - 0.5) / (below - above);
  }
  return -47;
}

TEST(Trench, nothingRisesBetweenTheFeetOfTheTool) {
  for (const bool conserving : {false, true}) {
    Clay clay = slab();
    stroke(clay, feet(), stamp(conserving), lineOf({-25, 3, 0}, {25, 3, 0}));
    for (int x = -30; x <= 30; ++x)
      for (int z = -4; z <= 4; ++z)
        ASSERT_NEAR(heightAt(clay, x, z), -5, 0.3) << conserving << ' ' << x << ' ' << z;
    EXPECT_GT(heightAt(clay, 0, 9), 0.3) << conserving;
  }
}

// The feet, so low that their top is a cell above the clay, held by a handle.
ToolShape lowFeet() {
  ToolShape tool = feet();
  Clay clay;
  for (const double x : {-10.0, 10.0})
    fillInto(clay, {Shape::box, {x, 0, 0}, {3, 4, 6}, {1, 0, 0, 0}, kBallColour});
  const SculptureOptions held{.pivot = glm::dvec3(0, 3, 0), .contact = {0, -1, 0}};
  tool.sculpture = std::make_shared<Sculpture>(clay, held);
  return tool;
}

Stroke facing(Stroke path) {
  path.placement.toNormal = true;
  return path;
}

// What the front foot raises does not lean over the trench, nor stay above it.
TEST(Trench, nothingRisesWhereTheHandleOfALowToolGoes) {
  for (const bool conserving : {false, true}) {
    Clay clay = slab();
    stroke(clay, lowFeet(), stamp(conserving), facing(lineOf({-25, 0, 0}, {25, 0, 0})));
    for (int x = -30; x <= 30; ++x)
      for (int z = -4; z <= 4; ++z)
        ASSERT_NEAR(heightAt(clay, x, z), -7, 0.3) << conserving << ' ' << x << ' ' << z;
    EXPECT_GT(heightAt(clay, 0, 9), 0.3) << conserving;
  }
}

// Only what the stroke raised goes: a tool that is led below the surface leaves it there.
TEST(Trench, theHandleTakesNoClayThatWasThere) {
  Clay clay = slab();
  const ActionOptions flat{ActionKind::stamp, 1, kToolColour, false, {.height = 0}};
  stroke(clay, lowFeet(), flat, facing(lineOf({-15, -6, 0}, {15, -6, 0})));
  for (int x = -24; x <= 24; ++x)
    for (int z = -4; z <= 4; ++z) {
      ASSERT_NEAR(heightAt(clay, x, z), 0, 0.01) << x << ' ' << z;
      ASSERT_LT(clay.value({x, -10, z}), 0.01) << x << ' ' << z;
    }
}

TEST(Trench, handledStampsKeepTheMass) {
  Clay clay = slab();
  const double before = double(massUnits(clay));
  stroke(clay, lowFeet(), stamp(true), facing(lineOf({-25, 0, 0}, {25, 0, 0})));
  EXPECT_NEAR(double(massUnits(clay)) / before, 1, 1e-9);
}

TEST(Trench, handledStampsAreTheSameWhateverTheBlockSide) {
  const auto made = [](auto field) {
    fillInto(field, {Shape::ellipsoid, {0, 0, 0}, {24, 15, 24}, {1, 0, 0, 0}, kBallColour});
    ToolShape tool = lowFeet();
    tool.rotation = glm::angleAxis(0.4, glm::dvec3(0, 1, 0));
    stroke(field, tool, stamp(), facing(lineOf({-6, 13, 2}, {6, 13.5, 1})));
    return fieldHash(field);
  };
  EXPECT_EQ(made(Field<1>()), made(Field<8>()));
}

TEST(Trench, aStrokeThatCrossesItselfLeavesItsTrenchOpen) {
  Clay clay = slab();
  Stroke path;
  path.points = {
      {{-30, 2, 0}, 1}, {{30, 2, 0}, 1}, {{30, 2, 25}, 1}, {{0, 2, 25}, 1}, {{0, 2, -25}, 1}};
  stroke(clay, ball(12), stamp(), path);
  const double alone = heightAt(clay, -20, 0);
  for (int x = -20; x < 20; ++x) EXPECT_LT(heightAt(clay, x, 0), alone + 0.5) << x;
  EXPECT_LT(alone, -2);
}

TEST(Trench, anotherStrokeRaisesItsRimThere) {
  Clay clay = slab();
  stroke(clay, ball(12), stamp(), lineOf({-30, 2, 0}, {30, 2, 0}));
  const double before = heightAt(clay, 8, 0);
  stroke(clay, ball(12), stamp(), lineOf({0, 2, -25}, {0, 2, 25}));
  EXPECT_GT(heightAt(clay, 8, 0), before + 0.3);
}

TEST(Trench, drawnLiveOrAtOnceItIsTheSame) {
  const auto drawn = [](bool live) {
    Clay clay = slab();
    Edit<CornerBlock<8>> edit(clay.tree);
    Stroke path = lineOf({-20, 2, 0}, {12, 1, 6});
    if (live) path.points.pop_back();
    StrokeRunner<8> runner(edit, clay.scale, feet(), stamp(true), path);
    const std::vector<StrokePoint> rest{{{12, 1, 6}, 1}};
    if (live) runner.extend(rest);
    for (std::int64_t n = 0; n < runner.dabCount(); ++n) runner.dab(n);
    edit.commit();
    return fieldHash(clay);
  };
  EXPECT_EQ(drawn(true), drawn(false));
}

// A relief lies with its root on the clay: to print it sinks in, once and whole.
TEST(Trench, whatOnlyTouchesSinksInToPrint) {
  Clay relief;
  fillInto(relief, {Shape::box, {0, 4, 0}, {9, 4, 7}, {1, 0, 0, 0}, kBallColour});
  const auto pressed = [&](const glm::dvec3& pivot) {
    ToolShape tool = feet();
    tool.sculpture = std::make_shared<Sculpture>(
        relief, SculptureOptions{.pivot = pivot, .contact = {0, -1, 0}});
    Clay clay = slab();
    stroke(clay, tool, stamp(), facing(dabAt({0, 0, 0})));
    return heightAt(clay, 0, 0);
  };
  EXPECT_NEAR(pressed({0, 0, 0}), -3.5, 0.6);
  EXPECT_NEAR(pressed({0, 5, 0}), -5, 0.1) << "as deep as its pivot says";
}

// Where the paper's potential ends, wider rims stood as a plateau in the box of influence.
TEST(Trench, conservingRimsByPotentialFadeOut) {
  Clay clay = slab();
  ActionOptions action = stamp(true);
  action.stamp.profile = StampProfile::paper;
  stroke(clay, ball(14), action, lineOf({0, 10, 0}, {0, -2, 0}));
  const auto crest = [&](int x, int z) {
    double highest = 0;
    for (int n = 4; n < 18; ++n) highest = std::max(highest, heightAt(clay, n * x, n * z));
    return highest;
  };
  EXPECT_GT(crest(1, 0), 0.2);
  EXPECT_NEAR(crest(1, 0), crest(1, 1), 0.2);
  for (int n = 14; n < 30; ++n)
    EXPECT_LT(std::abs(heightAt(clay, n, 0) - heightAt(clay, n + 1, 0)), 0.08) << n;
}

// Density raised as such ended on the cells: a terrace with an edge of teeth.
TEST(Trench, conservingRimsOfSculpturesHaveNoTerraces) {
  Clay clay = slab();
  stroke(clay, feet(), stamp(true), lineOf({0, 8, 0}, {0, 2, 0}));
  double highest = 0;
  for (int z = 11; z < 30; ++z) {
    for (int x = -34; x < 34; ++x) {
      const double here = heightAt(clay, x, z), next = heightAt(clay, x, z + 1);
      highest = std::max(highest, here);
      EXPECT_LT(std::abs(here - next), 0.75) << x << ' ' << z;
    }
  }
  EXPECT_GT(highest, 0.5);
}

TEST(SweptBlock, keepsTheMostOfEveryCorner) {
  SweptBlock<8> block;
  EXPECT_EQ(block.shares()[5], 0);
  std::array<float, 512> body{};
  body[5] = 0.75f;
  block.add(body.data());
  body[5] = 0.25f;
  body[6] = 0.5f;
  block.add(body.data());
  EXPECT_EQ(block.shares()[5], 0.75f);
  EXPECT_EQ(block.shares()[6], 0.5f);
  EXPECT_EQ(block.shares()[7], 0);
  body.fill(1);
  block.add(body.data());
  for (int n = 0; n < 512; ++n) EXPECT_EQ(block.shares()[n], 1);
}

}  // namespace
}  // namespace bozzetto
