// The brushes of painted stiffness: o ← o ± s·p, kept as clay that is white above 0, black below.
#include "tool/tool_fixture.hpp"

namespace bozzetto::testing {
namespace {

ActionOptions painting(ActionKind kind, double strength) {
  ActionOptions action;
  action.kind = kind;
  action.strength = strength;
  return action;
}

ToolShape box(double radius) {
  ToolShape tool = ball(radius);
  tool.profile = Profile::box;  // potential 1 inside
  return tool;
}

double offsetIn(const Clay& painted) {
  const Attributes white = painted.attributes({0, 0, 0}) & 0xffffff;
  EXPECT_TRUE(white == 0 || white == 0xffffff);
  return painted.value({0, 0, 0}) * (white != 0 ? 1 : -1);
}

TEST(StiffenBrush, AddsAndTakesByStrength) {
  Clay painted;
  stroke(painted, box(4), painting(ActionKind::stiffen, 0.25), dabAt({0, 0, 0}));
  EXPECT_NEAR(offsetIn(painted), 0.25, 0.005);
  stroke(painted, box(4), painting(ActionKind::soften, 0.75), dabAt({0, 0, 0}));
  EXPECT_NEAR(offsetIn(painted), -0.5, 0.005);
  stroke(painted, box(4), painting(ActionKind::stiffen, 0.5), dabAt({0, 0, 0}));
  EXPECT_NEAR(offsetIn(painted), 0, 0.01);
  EXPECT_EQ(validate(painted), std::nullopt);
}

TEST(StiffenBrush, ArrivesAtTheEndsAndStaysThere) {
  Clay painted;
  for (const ActionKind kind : {ActionKind::soften, ActionKind::stiffen}) {
    for (int n = 0; n < 300; ++n) stroke(painted, box(4), painting(kind, 0.01), dabAt({0, 0, 0}));
    EXPECT_EQ(offsetIn(painted), kind == ActionKind::stiffen ? 1 : -1);
  }
}

}  // namespace
}  // namespace bozzetto::testing
