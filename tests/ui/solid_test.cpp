// Solid mode in the window: made, worked on by every tool, baked, wrapped, seen.
#include <chrono>
#include <glm/geometric.hpp>
#include <thread>

#include "ui/null_window.hpp"

namespace bozzetto::ui {
namespace {

namespace fs = std::filesystem;

class SolidMode : public Null {
 protected:
  SolidMode() {
    atelier_.run(Command::newEmpty);
    settle();
    tap(letter('L'));
    atelier_.solid.cells = {2, 2, 2};
    atelier_.solid.edge = 20;
    settle();
    atelier_.run(Command::solidBlock);
    settle();
  }
  const SolidShown& shown() { return *atelier_.solidShown(); }
  std::size_t cells() { return shown().control().cells.size(); }
  glm::dvec2 seen(const glm::dvec3& place) {
    return atelier_.corner() + pixelOf(atelier_.view, atelier_.extent(), place);
  }
  void use(SolidTool tool) { atelier_.run(Command(int(Command::solidMove) + int(tool))); }
  // Of the solid itself, where it has no clay.
  bool solidReplays() {
    const testing::Folder folder;
    const fs::path path = folder / "by hand.jsonl";
    const Solid before = *shown().solid;
    atelier_.saveRecording(path);
    settle();
    replayed(path);
    return atelier_.solidShown() && before == *shown().solid;
  }
};

TEST_F(SolidMode, aBlockIsMadeAndShown) {
  EXPECT_EQ(atelier_.mode(), WorkMode::solid);
  ASSERT_NE(atelier_.solidShown(), nullptr);
  EXPECT_EQ(cells(), 8u);
  EXPECT_FALSE(shown().surface.empty());
  EXPECT_FALSE(shown().wires.empty());
  EXPECT_GE(atelier_.overlays().lines.size(), 54u);
  tap(static_cast<KeyCode>('1'));
  settle();
  EXPECT_EQ(atelier_.mode(), WorkMode::clay) << "a clay tool leads back";
}

TEST_F(SolidMode, aPointFollowsTheHandAndReplays) {
  use(SolidTool::move);
  const glm::dvec3 corner(20, 20, 20);
  const glm::dvec2 at = seen(corner);
  drag(at, at + glm::dvec2(40, -30));
  bool moved = true;
  for (const glm::dvec3& point : shown().control().points) moved &= point != corner;
  EXPECT_TRUE(moved);
  EXPECT_TRUE(solidReplays());
}

TEST_F(SolidMode, escapePutsADraggedPointBack) {
  use(SolidTool::move);
  const Solid before = *shown().solid;
  const glm::dvec2 at = seen({20, 20, 20});
  moveTo(at);
  settle();
  post(ButtonChanged{Button::left, true});
  moveTo(at + glm::dvec2(40, 0));
  settle();
  EXPECT_FALSE(before == *shown().solid) << "it is seen while it is dragged";
  tap(KeyCode::escape);
  settle();
  post(ButtonChanged{Button::left, false});
  settle();
  EXPECT_TRUE(before == *shown().solid);
}

TEST_F(SolidMode, cellsAreCarvedExtrudedSplit) {
  use(SolidTool::carve);
  click(seen({10, 10, 20}));
  EXPECT_EQ(cells(), 7u);
  use(SolidTool::extrude);
  click(seen({-10, 10, 20}));
  EXPECT_EQ(cells(), 8u);
  use(SolidTool::subdivide);
  click(seen({-10, -10, 20}));
  EXPECT_GT(cells(), 8u);
  EXPECT_TRUE(solidReplays());
}

TEST_F(SolidMode, facesAreJoinedByTwoClicks) {
  use(SolidTool::carve);
  click(seen({10, 10, 20}));
  use(SolidTool::join);
  const std::size_t before = cells();
  click(seen({-10, 10, 20}));
  EXPECT_EQ(cells(), before);
  click(seen({10, -10, 20}));
  EXPECT_EQ(cells(), before + 1);
}

TEST_F(SolidMode, brushesAndRopeReplay) {
  for (const SolidTool tool : {SolidTool::sharp, SolidTool::mass, SolidTool::stiffness,
                               SolidTool::inflate, SolidTool::trim, SolidTool::probe}) {
    use(tool);
    click(middle());
  }
  EXPECT_FALSE(shown().solid->matter.mass.empty());
  use(SolidTool::rope);
  const auto before = shown().control().points;
  drag(middle(), middle() + glm::dvec2(60, 20));
  EXPECT_NE(shown().control().points, before);
  atelier_.solid.map = SolidMap::mass;
  atelier_.tellSolid();
  settle();
  EXPECT_GT(shown().high, shown().low);
  EXPECT_TRUE(solidReplays());
}

TEST_F(SolidMode, homeShowsAllOfTheSolid) {
  atelier_.view.distance /= 10;
  atelier_.run(Command::frameAll);
  for (const glm::dvec3& point : shown().control().points) {
    const glm::dvec2 at = atelier_.corner() + pixelOf(atelier_.view, atelier_.extent(), point);
    EXPECT_TRUE(interface_.layout().viewport.contains(at));
  }
}

TEST_F(SolidMode, whatIsTrimmedIsDark) {
  const auto darkest = [&] {
    int least = 255;
    for (const UnpackedPatch& patch : shown().surface)
      for (const Colour colour : patch.colours) least = std::min(least, int(colour.r));
    return least;
  };
  const int before = darkest();
  use(SolidTool::trim);
  click(middle());
  EXPECT_LT(darkest(), before - 40);
}

TEST_F(SolidMode, theRopeIsFelt) {
  use(SolidTool::rope);
  moveTo(middle());
  settle();
  post(ButtonChanged{Button::left, true});
  moveTo(middle() + glm::dvec2(120, 0));
  settle();
  ASSERT_NE(atelier_.feltHand(), nullptr);
  // The hand is pulled back towards the clay: some ticks of a thread of its own.
  for (int n = 0; n < 200 && glm::length(atelier_.feltHand()->force()) == 0; ++n) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    settle();
  }
  const glm::dvec3 force = atelier_.feltHand()->force();
  EXPECT_LT(glm::dot(force, atelier_.view.right()), 0);
  EXPECT_LE(glm::length(force), FeltHand::kMostForce);
  EXPECT_LT(glm::dot(atelier_.feltArrow(), atelier_.view.right()), 0) << "drawn as it is felt";
  post(ButtonChanged{Button::left, false});
  settle();
  EXPECT_EQ(atelier_.feltHand(), nullptr);
  EXPECT_TRUE(solidReplays());
}

TEST_F(SolidMode, theProbeTellsAndResists) {
  atelier_.applySolid(SolidPaintOperation{Matter::hardness, {0, 0, 20}, 60, 4});
  settle();
  use(SolidTool::probe);
  const std::size_t before = steps();
  moveTo(middle());
  settle();
  post(ButtonChanged{Button::left, true});
  settle();
  ASSERT_TRUE(atelier_.touched());
  EXPECT_GT(*atelier_.touched(), 1.5);
  for (int n = 0; n < 200 && glm::length(atelier_.feltHand()->force()) == 0; ++n) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    settle();
  }
  EXPECT_GT(glm::dot(atelier_.feltHand()->force(), atelier_.view.back()), 0) << "it pushes out";
  post(ButtonChanged{Button::left, false});
  settle();
  EXPECT_EQ(steps(), before) << "touching changes nothing";
}

TEST_F(SolidMode, aCurveIsLaidDraggedAndReplays) {
  atelier_.lookFrom(0, 0);
  use(SolidTool::spline);
  for (const double x : {-10.0, 0.0, 10.0}) click(seen({x, 0, 16}));
  ASSERT_EQ(atelier_.curve().points.size(), 3u);
  click(seen({0, 0, 16}));
  EXPECT_EQ(atelier_.curve().points.size(), 3u) << "a click on a control adds nothing";
  const glm::dvec3 control = atelier_.curveControls()[1];
  const std::size_t before = steps();
  drag(seen(control), seen(control + glm::dvec3(0, 12, 0)));
  EXPECT_EQ(steps(), before + 1);
  EXPECT_GT(atelier_.curveControls()[1].y, control.y + 2) << "the curve stays on the clay";
  ASSERT_TRUE(shown().ran);
  EXPECT_EQ(shown().ran->steps, atelier_.solid.steps);
  EXPECT_GT(shown().ran->energy, 0);
  tapCtrl(KeyCode::escape);
  EXPECT_TRUE(solidReplays());
  EXPECT_TRUE(atelier_.curve().points.empty());
}

TEST_F(SolidMode, aCurveLosesPointsAndGoes) {
  atelier_.lookFrom(0, 0);
  use(SolidTool::spline);
  for (const double x : {-10.0, 0.0, 10.0}) click(seen({x, 0, 16}));
  post(KeyChanged{KeyCode::leftControl, true, false});
  click(seen(atelier_.curveControls()[0]));
  post(KeyChanged{KeyCode::leftControl, false, false});
  EXPECT_EQ(atelier_.curve().points.size(), 2u);
  tap(KeyCode::escape);
  settle();
  EXPECT_TRUE(atelier_.curve().points.empty());
  click(seen({0, 0, 16}));
  atelier_.applySolid(SolidCarveOperation{{10, 10, 10}});
  settle();
  EXPECT_TRUE(atelier_.curve().points.empty()) << "other points are other points";
}

TEST_F(SolidMode, bakedItIsClayAndReplays) {
  const double before = mass();
  atelier_.run(Command::bake);
  settle();
  EXPECT_GT(mass(), before);
  expectReplays();
}

TEST_F(Null, aWrapCarriesTheClayAlong) {
  const double before = atelier_.statistics().field.mass;
  atelier_.solid.cells = {2, 2, 2};
  atelier_.run(Command::wrap);
  settle();
  ASSERT_NE(atelier_.solidShown(), nullptr);
  EXPECT_TRUE(atelier_.solidShown()->solid->isWrap());
  atelier_.applySolid(SolidMoveOperation{Key{2, 4, 2}, {0, 30, 0}});
  atelier_.run(Command::wrapApply);
  settle();
  EXPECT_NEAR(mass(), before, 1e-6 * before);
  atelier_.run(Command::undo);
  settle();
  expectReplays();
}

// What is seen while a wrap is posed is what applying it gives, to a fraction of a cell.
TEST_F(Null, clayIsSeenToFollowAWrap) {
  const auto seen = [&] { return atelier_.patches().bounds(); };
  const CellBounds before = seen();
  atelier_.solid.cells = {2, 2, 2};
  atelier_.run(Command::wrap);
  settle();
  EXPECT_EQ(seen().high, before.high) << "a wrap at rest shows the clay as it is";
  for (int i = 0; i <= 4; ++i)
    for (int k = 0; k <= 4; ++k) atelier_.applySolid(SolidMoveOperation{Key{i, 4, k}, {0, 20, 0}});
  for (int i = 0; i <= 4; ++i)
    for (int k = 0; k <= 4; ++k) atelier_.applySolid(SolidMoveOperation{Key{i, 3, k}, {0, 20, 0}});
  settle();
  const CellBounds posed = seen();
  EXPECT_GT(posed.high.y, before.high.y + 5);
  const glm::dvec3 top(0, posed.high.y + 50, 0);
  const auto hit = atelier_.patches().pick({top, {0, -1, 0}});
  ASSERT_TRUE(hit);
  EXPECT_GT(hit->position.y, before.high.y + 5) << "it can be taken where it is seen";
  atelier_.run(Command::solidMode);
  settle();
  EXPECT_EQ(seen().high, before.high) << "clay tools meet the clay as it is";
  atelier_.run(Command::solidMode);
  atelier_.solid.keepMass = false;
  atelier_.run(Command::wrapApply);
  settle();
  EXPECT_NEAR(seen().high.y, posed.high.y, 0.6);
  EXPECT_NEAR(seen().low.y, posed.low.y, 0.6);
}

}  // namespace
}  // namespace bozzetto::ui
