// Tools that are sculptures: what they reproduce, keep symmetric and cost.
#include <chrono>

#include "bozzetto/field/sampler.hpp"
#include "bozzetto/tool/combine.hpp"
#include "bozzetto/tool/sculpture.hpp"
#include "tool/tool_fixture.hpp"

namespace bozzetto {
namespace {

using namespace testing;

ToolShape toolOf(const Clay& clay, const SculptureOptions& options = {}) {
  ToolShape tool;
  tool.shape = Shape::freeform;
  tool.sculpture = std::make_shared<Sculpture>(clay, options);
  return tool;
}

Clay twoColoured() {
  Clay clay = clayBall<8>(9.3, {3, -2, 5});
  fillInto(clay, Primitive{Shape::box, {6, 2, 1}, {4, 7, 3.5}, {0.9, 0.2, 0.1, 0.3}, {9, 200, 70}});
  return clay;
}

glm::dvec3 pivotOf(const Clay& clay) {
  const KeyBox box = boundsOf(clay);
  return 0.5 * (glm::dvec3(box.low.i, box.low.j, box.low.k) +
                glm::dvec3(box.high.i, box.high.j, box.high.k));
}

ActionOptions addAll() {
  ActionOptions action{ActionKind::add, 1, kToolColour};
  action.ownColours = true;
  return action;
}

template <int Side>
Field<Side> stamped(const ToolShape& tool, glm::dvec3 at) {
  Field<Side> field;
  stroke<Side>(field, tool, addAll(), dabAt(at));
  return field;
}

TEST(Freeform, scaleOneWithoutRotationIsItsSource) {
  const Clay source = twoColoured();
  EXPECT_EQ(fieldHash(stamped<8>(toolOf(source), pivotOf(source))), fieldHash(source));
  EXPECT_EQ(fieldHash(stamped<1>(toolOf(source), pivotOf(source))), fieldHash(source));
}

TEST(Freeform, movedByWholeCellsItIsItsSourceMoved) {
  const Clay source = twoColoured();
  const Clay made = stamped<8>(toolOf(source), pivotOf(source) + glm::dvec3(100, -37, 12));
  const auto before = samplesOf(source), after = samplesOf(made);
  ASSERT_EQ(before.size(), after.size());
  for (const auto& [key, sample] : before) {
    const auto twin = after.find(key + Key{100, -37, 12});
    ASSERT_NE(twin, after.end());
    EXPECT_EQ(twin->second.value, sample.value);
    EXPECT_EQ(twin->second.attributes, sample.attributes);
  }
}

TEST(Freeform, otherSpacingsReproduceToo) {
  Clay source = twoColoured();
  source.scale.spacing = 0.3;  // world units are no multiples of anything
  ToolShape tool = toolOf(source, {.pivot = glm::dvec3(0)});
  Clay made;
  made.scale = source.scale;
  stroke(made, tool, addAll(), dabAt({0, 0, 0}));
  EXPECT_EQ(fieldHash(made), fieldHash(source));
}

TEST(Freeform, quarterTurnsMoveCornersToCorners) {
  const Clay source = twoColoured();
  ToolShape tool = toolOf(source, {.pivot = glm::dvec3(0)});
  const double half = std::sqrt(0.5);
  tool.rotation = glm::dquat(half, 0, 0, half);  // x to y, y to −x
  const Clay made = stamped<8>(tool, {0, 0, 0});
  const auto before = samplesOf(source), after = samplesOf(made);
  ASSERT_EQ(before.size(), after.size());
  for (const auto& [key, sample] : before) {
    const auto twin = after.find({-key.j, key.i, key.k});
    ASSERT_NE(twin, after.end());
    EXPECT_EQ(twin->second.value, sample.value);
    EXPECT_EQ(twin->second.attributes, sample.attributes);
  }
}

// Straight from the formula: v(M⁻¹(p − pivot)) by trilinear interpolation.
TEST(Freeform, turnedAndScaledItIsTheTrilinearReconstruction) {
  const Clay source = twoColoured();
  ToolShape tool = toolOf(source, {.pivot = glm::dvec3(0)});
  tool.scale = {1.3, 0.9, 2};
  tool.rotation = glm::normalize(glm::dquat(0.8, 0.3, -0.4, 0.2));
  const glm::dvec3 at(0.37, -1.21, 2.5);
  const Clay made = stamped<8>(tool, at);
  EXPECT_EQ(validate(made), std::nullopt);
  FieldSampler<8> sampler(source);
  const auto samples = samplesOf(made);
  int looked = 0;
  for (int i = -20; i <= 20; i += 3)
    for (int j = -20; j <= 20; j += 2)
      for (int k = -20; k <= 20; ++k) {
        const glm::dvec3 local =
            (glm::inverse(tool.rotation) * (glm::dvec3(i, j, k) - at)) / tool.scale;
        const float expected = sampler.value(cellPoint({}, local));
        const auto found = samples.find({i, j, k});
        EXPECT_NEAR(found == samples.end() ? 0 : found->second.value, expected, 5e-4);
        looked += expected > 0;
      }
  EXPECT_GT(looked, 1000);
}

TEST(Freeform, sidesAndInstructionSetsAgreeToTheBit) {
  const Clay source = twoColoured();
  const auto session = [&]<int Side>() {
    Field<Side> field = clayBall<Side>(14);
    ToolShape tool = toolOf(source);
    for (int n = 0; n < 7; ++n) {
      tool.scale = glm::dvec3(1.1, 0.8, 0.3 + 0.2 * n);
      tool.rotation = n % 2 == 0 ? glm::dquat(1, 0, 0, 0) : glm::dquat(0.8, 0.3, -0.4, 0.2 * n);
      ActionOptions action{static_cast<ActionKind>(n % 6), 0.6, kToolColour};
      action.ownColours = n % 3 != 1;
      Stroke path = lineOf({-9.25, 3, n - 4.0}, {11, 2.125, 3});
      path.pressure.size = n == 3;
      path.points[0].pressure = 0.4;
      stroke(field, tool, action, path);
    }
    EXPECT_EQ(validate(field), std::nullopt);
    return fieldHash(field);
  };
  expectSameBits(session);
}

// Tools with an inside and an outside that nobody reads, straight, scaled and turned.
TEST(Freeform, insidesOfLargeToolsAgreeToTheBit) {
  Clay hollow = clayBall<8>(27);
  Edit<CornerBlock<8>> edit(hollow.tree);
  clear<8>(edit, KeyBox{{-2, -9, -30}, {7, 4, 3}});
  edit.commit();
  const auto session = [&]<int Side>() {
    Field<Side> field = clayBall<Side>(20);
    ToolShape tool = toolOf(hollow);
    for (int n = 0; n < 6; ++n) {
      tool.scale = glm::dvec3(1, 0.8 + 0.2 * n, n < 3 ? 1 : 0.71);
      tool.rotation = n % 2 == 0 ? glm::dquat(1, 0, 0, 0) : glm::dquat(0.8, 0.3, -0.4, 0.2 * n);
      const auto kind = n % 3 == 0 ? ActionKind::remove : ActionKind::add;
      stroke(field, tool, {kind, 0.4, kToolColour}, lineOf({-9.25, 3, n - 4.0}, {11, 12.1, 3}));
    }
    EXPECT_EQ(validate(field), std::nullopt);
    return fieldHash(field);
  };
  expectSameBits(session);
}

TEST(Freeform, symmetricToolsLeaveSymmetricClay) {
  Clay source = clayBall<8>(7);
  fillInto(source, ballOf(4, {9, 2, 0}));
  fillInto(source, ballOf(4, {-9, 2, 0}));
  ToolShape tool = toolOf(source, {.pivot = glm::dvec3(0)});
  tool.scale = glm::dvec3(1.37);
  tool.rotation = glm::angleAxis(0.6, glm::dvec3(1, 0, 0));  // keeps the plane x = 0
  const auto samples = samplesOf(stamped<8>(tool, {0, 0.3, -1.7}));
  ASSERT_GT(samples.size(), 1000U);
  for (const auto& [key, sample] : samples) {
    const auto twin = samples.find({-key.i, key.j, key.k});
    ASSERT_NE(twin, samples.end()) << toText(key);
    EXPECT_EQ(twin->second.value, sample.value) << toText(key);
  }
}

TEST(Freeform, aToolOfAToolIsTheTool) {
  const Clay source = twoColoured();
  const Clay once = stamped<8>(toolOf(source), pivotOf(source));
  const Clay twice = stamped<8>(toolOf(once), pivotOf(once));
  EXPECT_EQ(fieldHash(twice), fieldHash(source));
}

TEST(Freeform, minifiedStripesDoNotAlias) {
  Clay comb;  // stripes of two cells, two cells apart: half full at any size that blurs them
  for (int n = -10; n < 10; ++n)
    fillInto(comb, Primitive{Shape::box, {4.0 * n, 0, 0}, {1, 40, 40}, {1, 0, 0, 0}, {}});
  ToolShape tool = toolOf(comb);
  tool.scale = glm::dvec3(0.125);
  const Clay made = stamped<8>(tool, {0.3, 0, 0});
  for (int i = -3; i <= 3; ++i) EXPECT_NEAR(made.value({i, 0, 0}), 0.5, 0.02) << i;
}

TEST(Freeform, minifiedMassFollowsItsScale) {
  const Clay source = clayBall<8>(40);
  const double mass = double(massUnits(source));
  for (const double scale : {0.5, 0.25, 0.1}) {
    ToolShape tool = toolOf(source);
    tool.scale = glm::dvec3(scale);
    const Clay made = stamped<8>(tool, {0.2, 0.4, -0.1});
    EXPECT_NEAR(double(massUnits(made)) / (mass * std::pow(scale, 3)), 1, 0.05) << scale;
  }
}

TEST(Freeform, erasesAndPaintsWithinItsShape) {
  Clay clay = clayBall<8>(30);
  Clay bar;
  fillInto(bar, Primitive{Shape::box, {0, 0, 0}, {3, 3, 50}, {1, 0, 0, 0}, {}});
  stroke(clay, toolOf(bar), {ActionKind::erase, 1, {}}, dabAt({0, 0, 0}));
  EXPECT_EQ(clay.value({0, 0, 20}), 0);
  EXPECT_EQ(clay.value({8, 0, 20}), 1);
  stroke(clay, toolOf(bar), {ActionKind::paint, 1, kToolColour}, dabAt({10, 0, 0}));
  EXPECT_EQ(clay.attributes({10, 1, 3}), packAttributes(kToolColour));
  EXPECT_EQ(clay.attributes({16, 1, 3}), packAttributes(kBallColour));
}

// The wall that is left lies where the tool's density is a quarter, between its corners too.
TEST(Freeform, erasingLeavesASmoothWall) {
  Clay clay = clayBall<8>(30);
  const Clay before = clay, cutter = clayBall<8>(12);
  const glm::dvec3 at(8.3, 2.6, -4.1);
  stroke(clay, toolOf(cutter), {ActionKind::erase, 1, {}}, dabAt(at));
  const Clay there = stamped<8>(toolOf(cutter), at);
  int sloping = 0;
  for (const auto& [key, sample] : samplesOf(before)) {
    const float left = std::min(sample.value, std::max(0.0f, 1 - 2 * there.value(key)));
    ASSERT_EQ(clay.value(key), left) << toText(key);
    sloping += left > 0 && left < sample.value;
  }
  EXPECT_GT(sloping, 1000);
  EXPECT_EQ(validate(clay), std::nullopt);
}

TEST(Freeform, partsOfClayShareItsBlocks) {
  const Clay clay = clayBall<8>(40);
  const KeyBox box{{-11, -50, 3}, {17, 30, 28}};
  const Clay part = partOf(clay, box);
  EXPECT_EQ(validate(part), std::nullopt);
  Samples expected = samplesOf(clay);
  std::erase_if(expected, [&](const auto& each) { return !box.contains(each.first); });
  const Samples found = samplesOf(part);
  ASSERT_EQ(found.size(), expected.size());
  for (const auto& [key, sample] : expected) EXPECT_EQ(found.at(key).value, sample.value);
  EXPECT_EQ(part.tree.find({0, 0, 1}), clay.tree.find({0, 0, 1}));
  EXPECT_EQ(boundsOf(part), (KeyBox{{-11, -40, 3}, {17, 30, 28}}));
}

// What a lasso holds, against every corner asked by itself; seen from an eye and by parallel rays.
TEST(Freeform, lassosTakeWhatTheyHold) {
  const Clay clay = clayBall<8>(30);
  Lasso lasso;
  lasso.worldFromView = glm::angleAxis(0.7, glm::normalize(glm::dvec3(1, 2, 0.5)));
  const KeyBox everywhere{{-99, -99, -99}, {99, 99, 99}};
  for (const LassoRays rays : {LassoRays::fromEye, LassoRays::parallel}) {
    lasso.rays = rays;
    const double size = rays == LassoRays::fromEye ? 0.15 : 15;
    lasso.eye = rays == LassoRays::fromEye ? lasso.worldFromView * glm::dvec3(5, 0, 100)
                                           : glm::dvec3(5, 0, 0);
    lasso.outline = {{-size, -size}, {size, -0.5 * size}, {0.2 * size, 0}, {size, size}};
    const Clay part = partOf(clay, everywhere, lasso);
    EXPECT_EQ(validate(part), std::nullopt);
    // And what clearing it leaves is the rest.
    Clay rest = clay;
    Edit<CornerBlock<8>> edit(rest.tree);
    clear<8>(edit, rest.scale, everywhere, lasso);
    edit.commit();
    const Samples all = samplesOf(clay), taken = samplesOf(part);
    EXPECT_GT(taken.size(), 1000u);
    EXPECT_LT(taken.size(), all.size() / 2);
    int between = 0;
    for (const auto& [key, sample] : all) {
      const float held = part.value(key), stays = rest.value(key);
      const double share = lasso.share({key.i, key.j, key.k}, 1);
      EXPECT_NEAR(held, sample.value * share, 1e-6);
      EXPECT_EQ(held + stays, sample.value) << "to the bit";
      between += share > 0 && share < 1;
    }
    EXPECT_GT(between, 1000) << "the wall is two cells thick";
  }
  lasso.outline.resize(2);
  EXPECT_THROW(partOf(clay, everywhere, lasso), Error);
}

TEST(Freeform, duplicatingCopiesPointersOnly) {
  Clay clay;
  for (int n = 0; n < 100'000; ++n) {
    Ref<CornerBlock<8>> block(new CornerBlock<8>);
    block->value.fill(0.5f);
    block->attributes.fill(Attributes(n % 7));
    block->value[7] = 0.25f;
    clay.tree.put({n / 2500, n / 50 % 50, n % 50}, CornerBlock<8>::canonical(block));
  }
  double best = 1e9;
  for (int n = 0; n < 5; ++n) {
    const auto start = std::chrono::steady_clock::now();
    const Sculpture tool(clay);
    const auto passed = std::chrono::steady_clock::now() - start;
    best = std::min(best, std::chrono::duration<double, std::milli>(passed).count());
    EXPECT_EQ(tool.clay().tree.find({3, 4, 5}), clay.tree.find({3, 4, 5}));
  }
  RecordProperty("milliseconds", std::to_string(best));
  EXPECT_LT(best, 200);  // 10 ms is the aim on an idle machine; others take their share of this one
}

TEST(Freeform, refusesWhatIsNoTool) {
  EXPECT_THROW(Sculpture(Clay{}), Error);
  EXPECT_THROW(Sculpture(clayBall<8>(5), {.pivot = {}, .contact = {0, 0, 0}}), Error);
  ToolShape tool = toolOf(clayBall<8>(5));
  tool.scale = {1, 0, 1};
  EXPECT_THROW(fitTool(tool, 1), Error);
  tool.scale = glm::dvec3(1.0 / 300);
  EXPECT_THROW(fitTool(tool, 1), Error);
  tool.scale = glm::dvec3(5000);
  EXPECT_THROW(fitTool(tool, 1), Error);
}

}  // namespace
}  // namespace bozzetto
