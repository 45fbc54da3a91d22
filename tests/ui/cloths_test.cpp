// Cloths stand in for the mesh while much of the clay moves, and leave it as it would have been.
#include <gtest/gtest.h>

#include "surface/surface_fields.hpp"
#include "ui/clay_desk.hpp"

namespace bozzetto::ui {
namespace {

TEST(HeightSwitch, waitsBothWays) {
  HeightSwitch view;
  view.meshed(100, 100);
  EXPECT_FALSE(view.wantsCloths()) << "once is no rule";
  view.meshed(100, 100);
  EXPECT_TRUE(view.wantsCloths());
  // 40 ms of meshing: too little to begin with, too much to end with.
  for (int n = 0; n < 9; ++n) view.draped(40);
  EXPECT_TRUE(view.wantsCloths());
  for (int n = 0; n < 4; ++n) view.draped(9);
  EXPECT_FALSE(view.wantsCloths());
  view.meshed(100, 100);
  EXPECT_FALSE(view.wantsCloths());
}

TEST(ClayDesk, SlowClothsComeAndGoWithAStroke) {
  ClayDesk desk;
  desk.setHeightSwitch(HeightSwitch(0, 0));
  desk.startNew(NewClay::ball);
  desk.seenFrom(Camera{});
  desk.take();
  HandOperations hand;
  hand.action.action.kind = ActionKind::push;
  Stroke stroke;
  stroke.points = {{{0, 0, 60}, 1}, {{0, 0, 30}, 1}};
  desk.beginStroke(hand, stroke);
  while (desk.dab()) desk.showDabs();
  Publication draped = desk.take();
  EXPECT_GT(draped.heights.size(), 20u);
  EXPECT_TRUE(draped.undraped) << "of what there was before";
  desk.endStroke();
  const Publication meshed = desk.take();
  EXPECT_TRUE(meshed.heights.empty());
  EXPECT_TRUE(meshed.undraped);
  EXPECT_FALSE(meshed.fine.empty());
  EXPECT_TRUE(
      testing::samePatches(desk.sculptor().surface(), testing::surfaceOf(desk.sculptor().field())));
  // Later on top: what the window's thread did not take in time.
  draped.add(meshed);
  EXPECT_TRUE(draped.heights.empty() && draped.undraped);
}

}  // namespace
}  // namespace bozzetto::ui
