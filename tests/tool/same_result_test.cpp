// The same clay to the bit: block sides, instruction sets, thread counts, places.
#include "bozzetto/base/parallel.hpp"
#include "bozzetto/base/simd.hpp"
#include "bozzetto/tool/sculpture.hpp"
#include "tool/tool_fixture.hpp"

namespace bozzetto {
namespace {

using namespace testing;

constexpr Shape kShapes[] = {Shape::ellipsoid, Shape::box, Shape::cylinder, Shape::capsule};

Stroke wander() {
  Stroke path;
  path.points = {{{-9.125, 1.5, 3}, 1}, {{4.5, 6.75, -2}, 0.5}, {{9, -7.25, 1.125}, 0.9}};
  path.spacing = 0.5;
  path.pressure = {true, true};
  path.symmetry.mirror = {true, false, false};
  path.symmetry.centre = {1.5, 0, 0};
  return path;
}

// Every shape, profile and action on a filled body.
template <int Side>
Field<Side> session(Key moved = {}) {
  const glm::dvec3 by(moved.i, moved.j, moved.k);
  Field<Side> field;
  fillInto(field, ballOf(10.5, by + 0.25));
  Primitive bar{Shape::capsule, by + glm::dvec3(6, 3, 0), {3, 12, 5}, {0.9, 0.1, 0.3, 0.2}, {}};
  fillInto(field, bar);
  Stroke path = wander();
  for (StrokePoint& point : path.points) point.position += by;
  path.symmetry.centre += by;
  for (int n = 0; n < 24; ++n) {
    const ToolShape tool = oblique(kShapes[n % 4], static_cast<Profile>(n / 4 % 2));
    stroke(field, tool, {static_cast<ActionKind>(n % 6), 0.45, kToolColour}, path);
  }
  return field;
}

TEST(SameResult, sideOneAndEight) {
  const auto one = session<1>();
  const auto eight = session<8>();
  EXPECT_EQ(validate(one), std::nullopt);
  EXPECT_EQ(validate(eight), std::nullopt);
  EXPECT_EQ(fieldHash(one), fieldHash(eight));
  EXPECT_GT(statistics(eight).corners, 1000);
}

TEST(SameResult, scalarAndVector) {
  const auto fast = fieldHash(session<8>());
  forbidSimd(true);
  const auto plain = fieldHash(session<8>());
  forbidSimd(false);
  EXPECT_EQ(fast, plain);
}

TEST(SameResult, anyThreadCount) {
  const auto run = [](int threads) {
    setThreadCount(threads);
    Clay clay = clayBall<8>(40);
    for (int kind = 0; kind < 6; ++kind) {
      stroke(clay, ball(36), {static_cast<ActionKind>(kind), 0.6, kToolColour},
             lineOf({30.0 - 9 * kind, 0, 30}, {40, 3, 20}));
    }
    setThreadCount(0);
    return fieldHash(clay);
  };
  const auto one = run(1);
  for (int threads = 2; threads <= 4; ++threads) EXPECT_EQ(run(threads), one) << threads;
}

// Threads look for the corners that rise; wide rims keep several busy.
TEST(SameResult, conservingStampsOnAnyThreadCount) {
  ToolShape sculpted;
  sculpted.shape = Shape::freeform;
  sculpted.sculpture = std::make_shared<Sculpture>(clayBall<8>(11));
  ActionOptions stamp{ActionKind::stamp, 0.8, kToolColour};
  stamp.stamp.conserving = true;
  const auto run = [&](int threads, const ToolShape& tool) {
    setThreadCount(threads);
    Clay clay = clayBall<8>(48);
    stroke(clay, tool, stamp, lineOf({44.0, 0, 3.5}, {40, 20, 3}));
    setThreadCount(0);
    return fieldHash(clay);
  };
  for (const ToolShape& tool : {ball(15), sculpted}) {
    const auto one = run(1, tool);
    for (int threads = 2; threads <= 4; ++threads) EXPECT_EQ(run(threads, tool), one) << threads;
  }
}

TEST(SameResult, farAway) {
  const Key far{1 << 29, -(1 << 29), 1 << 29};
  const auto here = samplesOf(session<8>());
  const auto there = samplesOf(session<8>(far));
  ASSERT_EQ(here.size(), there.size());
  for (const auto& [key, sample] : here) {
    const auto twin = there.find(key + far);
    ASSERT_NE(twin, there.end());
    ASSERT_EQ(twin->second.value, sample.value);
    ASSERT_EQ(twin->second.attributes, sample.attributes);
  }
}

TEST(SameResult, countsDoNotDependOnTheSide) {
  Field<1> one = clayBall<1>(9);
  Field<8> eight = clayBall<8>(9);
  for (const Shape shape : kShapes) {
    const auto a = stroke(one, oblique(shape), {}, wander()).report.total;
    const auto b = stroke(eight, oblique(shape), {}, wander()).report.total;
    EXPECT_EQ(a.visited, b.visited);
    EXPECT_EQ(a.computed, b.computed);
    EXPECT_EQ(a.dirty, b.dirty);
    EXPECT_GT(a.visited, a.computed);
    EXPECT_GT(a.computed, a.dirty);
  }
}

TEST(SameResult, undoAndRedo) {
  Clay clay = clayBall<8>(12);
  const auto before = fieldHash(clay);
  for (int kind = 0; kind < 6; ++kind) {
    const auto made = stroke(clay, ball(7), {static_cast<ActionKind>(kind), 0.5, kToolColour},
                             lineOf({-14, 2, 3}, {10, 4, 8}));
    const auto after = fieldHash(clay);
    EXPECT_NE(before, after) << kind;
    made.delta.apply(clay.tree, Direction::backward);
    EXPECT_EQ(fieldHash(clay), before) << kind;
    EXPECT_EQ(validate(clay), std::nullopt);
    made.delta.apply(clay.tree, Direction::forward);
    EXPECT_EQ(fieldHash(clay), after) << kind;
    made.delta.apply(clay.tree, Direction::backward);
  }
}

// Bit j · 8 + k of slice i, from the corners themselves.
CornerBits differing(const Change<CornerBlock<8>>& change) {
  CornerBits corners{};
  for (int n = 0; n < 512; ++n) {
    const float before = change.before ? change.before->value[n] : 0;
    const float after = change.after ? change.after->value[n] : 0;
    const Attributes colourBefore = change.before ? change.before->attributes[n] : 0;
    const Attributes colourAfter = change.after ? change.after->attributes[n] : 0;
    const bool differs = before != after || colourBefore != colourAfter;
    corners[n / 64] |= std::uint64_t{differs} << n % 64;
  }
  return corners;
}

TEST(SameResult, aDabKnowsWhichCornersItChanged) {
  for (const bool scalar : {false, true}) {
    forbidSimd(scalar);
    for (int kind = 0; kind < 6; ++kind) {
      Clay clay = clayBall<8>(20);
      const ActionOptions action{static_cast<ActionKind>(kind), 0.4, kToolColour};
      stroke(clay, ball(9), action, dabAt({15, 2, 9}));
      const auto made = stroke(clay, ball(9), action, dabAt({14, 3, 8}));
      ASSERT_EQ(made.delta.changes.size(), made.report.total.changed.size());
      for (std::size_t n = 0; n < made.delta.changes.size(); ++n)
        EXPECT_EQ(differing(made.delta.changes[n]), made.report.total.changed[n].corners) << kind;
    }
  }
  forbidSimd(false);
}

TEST(SameResult, dirtiedKeysAreThoseOfTheDelta) {
  Clay clay = clayBall<8>(20);
  const auto made =
      stroke(clay, ball(9), {ActionKind::add, 0.5, kBallColour}, lineOf({-25, 2, 3}, {20, 4, 8}));
  ASSERT_EQ(made.delta.changes.size(), made.report.total.changed.size());
  for (std::size_t n = 0; n < made.delta.changes.size(); ++n)
    EXPECT_EQ(made.delta.changes[n].key, made.report.total.changed[n].key);
}

}  // namespace
}  // namespace bozzetto
