// The brush that holds clay, and its opposite.
#include "tool/tool_fixture.hpp"

namespace bozzetto::testing {
namespace {

ActionOptions doing(ActionKind kind, double strength) {
  ActionOptions action;
  action.kind = kind;
  action.strength = strength;
  return action;
}
ActionOptions holding(double strength) { return doing(ActionKind::hold, strength); }
ActionOptions freeing(double strength) { return doing(ActionKind::free, strength); }

TEST(HoldBrush, GrowsTheHoldAndNothingElse) {
  Clay clay = clayBall<8>(12);
  const Clay before = clay;
  stroke(clay, ball(6), holding(0.5), dabAt({12, 0, 0}));
  EXPECT_EQ(holdOf(clay.attributes({11, 0, 0})) > 90, true);
  EXPECT_EQ(holdOf(clay.attributes({0, 0, 0})), 0);
  EXPECT_EQ(clay.value({11, 0, 0}), before.value({11, 0, 0}));
  EXPECT_EQ(colourOf(clay.attributes({11, 0, 0})), kBallColour);
  EXPECT_EQ(validate(clay), std::nullopt);
}

TEST(HoldBrush, ArrivesAtFixed) {
  Clay clay = clayBall<8>(12);
  for (int n = 0; n < 60; ++n) stroke(clay, ball(6), holding(1), dabAt({12, 0, 0}));
  EXPECT_EQ(holdOf(clay.attributes({10, 0, 0})), 255);
}

// However often it is painted over, and where more is held already it stays.
TEST(HoldBrush, StrengthIsTheValue) {
  Clay clay = clayBall<8>(12);
  const Key at{10, 0, 0};
  const auto paint = [&](const ActionOptions& action) {
    for (int n = 0; n < 60; ++n) stroke(clay, ball(6), action, dabAt({12, 0, 0}));
    return int(holdOf(clay.attributes(at)));
  };
  EXPECT_EQ(paint(holding(0.4)), 102);
  EXPECT_EQ(paint(holding(0.2)), 102);
  EXPECT_EQ(paint(holding(0.8)), 204);
  EXPECT_EQ(paint(freeing(0.1)), 204);
  EXPECT_EQ(paint(freeing(0.6)), 102);
  EXPECT_EQ(paint(freeing(1)), 0);
}

TEST(HoldBrush, OneDabGoesByThePotential) {
  Clay clay = clayBall<8>(12);
  const Clay before = clay;
  stroke(clay, ball(6), holding(1), dabAt({11, 0, 0}));
  EXPECT_EQ(holdOf(clay.attributes({11, 0, 0})), 255);
  const int side = holdOf(clay.attributes({8, 0, 0}));
  EXPECT_GT(side, 60);
  EXPECT_LT(side, 200);
  stroke(clay, ball(6), freeing(1), dabAt({11, 0, 0}));
  EXPECT_EQ(holdOf(clay.attributes({11, 0, 0})), 0);
  EXPECT_NEAR(holdOf(clay.attributes({8, 0, 0})), side * (255 - side) / 255, 2);
  EXPECT_EQ(clay.value({11, 0, 0}), before.value({11, 0, 0}));
  EXPECT_EQ(colourOf(clay.attributes({8, 0, 0})), kBallColour);
  EXPECT_EQ(validate(clay), std::nullopt);
}

TEST(HoldBrush, FreeingFreeClayChangesNothing) {
  Clay clay = clayBall<8>(12);
  EXPECT_TRUE(stroke(clay, ball(6), freeing(1), dabAt({11, 0, 0})).delta.changes.empty());
}

TEST(HoldBrush, ActionsThatMoveClayAreNoBrushes) {
  for (const ActionKind kind : {ActionKind::push, ActionKind::grip, ActionKind::swell}) {
    ActionOptions action;
    action.kind = kind;
    EXPECT_TRUE(movesClay(kind));
    EXPECT_THROW(makeAction(action), Error);
    EXPECT_EQ(actionNamed(toText(kind)), kind);
  }
}

}  // namespace
}  // namespace bozzetto::testing
