// The brush that holds clay.
#include "tool/tool_fixture.hpp"

namespace bozzetto::testing {
namespace {

ActionOptions holding(double strength) {
  ActionOptions action;
  action.kind = ActionKind::hold;
  action.strength = strength;
  return action;
}

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
  for (int n = 0; n < 60; ++n) stroke(clay, ball(6), holding(0.2), dabAt({10, 0, 0}));
  EXPECT_EQ(holdOf(clay.attributes({10, 0, 0})), 255);
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
