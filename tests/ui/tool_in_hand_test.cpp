// The sculpture in the hand: where it stands, which side of it touches, and how it is kept.
#include <glm/geometric.hpp>

#include "ui/shelf_window.hpp"

namespace bozzetto::ui {
namespace {

TEST_F(Shelf, pivotAndContactAreChosenInTheHand) {
  take("leaf");
  Freeform& tool = *atelier_.sculpt.freeform;
  const auto mesh = tool.mesh;
  EXPECT_TRUE(tool.standsAsKept());
  tool.setPivot({1, 0, 0});
  tool.setContact({0, 0, 1});
  EXPECT_NEAR(tool.pivot().x, 1, 1e-12);
  EXPECT_NEAR(tool.pivot().y, 0, 1e-12);
  EXPECT_EQ(tool.sculpture->contact(), glm::dvec3(0, 0, 1));
  EXPECT_EQ(tool.mesh, mesh) << "its surface is made once";
  moveTo(middle());
  settle();
  const Overlays overlays = atelier_.overlays();
  ASSERT_EQ(overlays.tools.size(), 1u);
  // Its front faces into the clay, and its right side lies on the pointer.
  const glm::dmat4& placed = overlays.tools[0].cellsFromTool;
  EXPECT_GT(glm::dot(glm::normalize(-glm::dvec3(placed[2])), atelier_.hover().ground->normal),
            0.999);
  const glm::dvec3 right(tool.sculpture->halfExtents().x - 1, 0, 0);
  const glm::dvec3 at(placed * glm::dvec4(right, 1));
  EXPECT_LT(glm::distance(at, atelier_.hover().ground->position), 1e-9);
  drag(middle(), middle() + glm::dvec2(20, 8));
  const std::uint64_t turned = hash();
  tapCtrl(letter('Z'));
  settle();
  tool.standAsKept();
  EXPECT_FALSE(tool.source.pivot);
  drag(middle(), middle() + glm::dvec2(20, 8));
  EXPECT_NE(hash(), turned);
  expectReplays();
}

TEST_F(Shelf, aToolIsKeptAsItStands) {
  take("leaf");
  atelier_.sculpt.freeform->setContact({1, 0, 0});
  atelier_.keepStand();
  settle();
  EXPECT_TRUE(atelier_.sculpt.freeform->standsAsKept());
  ASSERT_EQ(cardNamed(atelier_.shelf.cards, "leaf")->entry.place, ToolEntry::Place::document);
  atelier_.sculpt.drop();
  atelier_.takeTool(cardNamed(atelier_.shelf.cards, "leaf")->entry);
  settle();
  EXPECT_EQ(atelier_.sculpt.freeform->sculpture->contact(), glm::dvec3(1, 0, 0));
  EXPECT_EQ(atelier_.sculpt.action, ActionKind::add) << "and does what a leaf does";
  EXPECT_TRUE(atelier_.sculpt.ownColours);
}

TEST_F(Shelf, marksShowWhereASculptureStands) {
  take("leaf");
  moveTo({1200, 300});  // over a panel
  settle();
  EXPECT_TRUE(atelier_.overlays().tools.empty());
  atelier_.standOpen = true;
  const Overlays overlays = atelier_.overlays();
  EXPECT_EQ(overlays.tools.size(), 1u) << "in the middle of the view";
  EXPECT_EQ(overlays.lines.size(), 4u);
}

TEST_F(Shelf, directionsHaveAngles) {
  for (const glm::dvec3 way : {glm::dvec3(0, 0, -1), glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0),
                               glm::dvec3(-.6, .48, .64), glm::dvec3(0, -1, 0)}) {
    EXPECT_LT(glm::distance(directionOf(headingOf(way)), way), 1e-12);
  }
  EXPECT_EQ(headingOf({0, 0, -1}).right, 0);
  EXPECT_NEAR(headingOf({1, 0, 0}).right, 90, 1e-9);
  EXPECT_NEAR(headingOf({0, 1, 0}).up, 90, 1e-9);
}

TEST_F(Shelf, aPlainShapeIsKeptAsAPreset) {
  SculptState& sculpt = atelier_.sculpt;
  sculpt.shape = Shape::box;
  sculpt.size = 6;
  sculpt.proportions = {1, 0.5, 0.25};
  sculpt.rotation = glm::dquat(0.6, 0, 0.8, 0);
  sculpt.spacing = 0.7;
  sculpt.placement.jitter.size = 0.5;
  atelier_.setTool(ActionKind::stamp);
  sculpt.strengthOf(ActionKind::stamp) = 0.33;
  sculpt.stamp.height = 0.7;
  atelier_.keepClay("chisel", {"hard"}, ShelfDrawer::Part::toolInHand);
  settle();
  ASSERT_NE(card("chisel"), nullptr);
  sculpt = SculptState{};
  take("chisel");
  EXPECT_FALSE(sculpt.isFreeform());
  EXPECT_EQ(sculpt.shape, Shape::box);
  EXPECT_DOUBLE_EQ(sculpt.size, 6);
  EXPECT_EQ(sculpt.proportions, glm::dvec3(1, 0.5, 0.25));
  EXPECT_EQ(sculpt.rotation, glm::dquat(0.6, 0, 0.8, 0));
  EXPECT_DOUBLE_EQ(sculpt.spacing, 0.7);
  EXPECT_DOUBLE_EQ(sculpt.placement.jitter.size, 0.5);
  EXPECT_EQ(sculpt.action, ActionKind::stamp);
  EXPECT_DOUBLE_EQ(sculpt.strengthOf(ActionKind::stamp), 0.33);
  EXPECT_DOUBLE_EQ(sculpt.stamp.height, 0.7);
  drag(middle(), middle() + glm::dvec2(20, 8));
  atelier_.shareTool(card("chisel")->entry, folder_ / "chisel.bzt");
  settle();
  EXPECT_EQ(loadTool(folder_ / "chisel.bzt").preset.size(), 3u);
  EXPECT_TRUE(loadTool(folder_ / "chisel.bzt").clay.tree.empty());
  expectReplays();
}

TEST_F(Shelf, aSculptureInTheHandIsKeptWithItsSettings) {
  take("leaf");
  atelier_.setTool(ActionKind::remove);
  atelier_.sculpt.freeform->setContact({0, 1, 0});
  atelier_.sculpt.size = 5;
  atelier_.keepClay("carver", {}, ShelfDrawer::Part::toolInHand);
  settle();
  atelier_.renameTool(card("carver")->entry, "gouge", {});
  settle();
  take("gouge");
  ASSERT_TRUE(atelier_.sculpt.isFreeform());
  EXPECT_EQ(atelier_.sculpt.action, ActionKind::remove);
  EXPECT_EQ(atelier_.sculpt.freeform->sculpture->contact(), glm::dvec3(0, 1, 0));
  EXPECT_NEAR(atelier_.sculpt.size, 5, 1e-9);
  const auto& tool = std::get<ToolOperation>(atelier_.sculpt.freeform->preset.at(0));
  EXPECT_EQ(tool.source->from, "shelf:gouge");
}

// Strokes name the tool: they find it under its new name, and none where it is gone.
TEST_F(Shelf, theHandFollowsItsTool) {
  atelier_.keepClay("ball", {}, ShelfDrawer::Part::allClay);
  settle();
  take("ball");
  atelier_.sculpt.size = 6;
  atelier_.renameTool(card("ball")->entry, "orb", {});
  settle();
  EXPECT_EQ(atelier_.sculpt.freeform->name, "orb");
  const std::uint64_t before = hash();
  drag(middle(), middle() + glm::dvec2(20, 8));
  EXPECT_NE(hash(), before);
  EXPECT_TRUE(atelier_.messages().empty());
  atelier_.dropTool(card("orb")->entry);
  settle();
  EXPECT_FALSE(atelier_.sculpt.isFreeform());
}

TEST_F(Shelf, aSceneTakesItsToolsAlong) {
  atelier_.keepClay("ball", {}, ShelfDrawer::Part::allClay);
  settle();
  for (const char* name : {"ball", "leaf"}) {
    take(name);
    ASSERT_TRUE(atelier_.sculpt.isFreeform());
    atelier_.worker().post([](ClayDesk& desk) { desk.startNew(NewClay::ball); });
    settle();
    EXPECT_EQ(atelier_.sculpt.isFreeform(), std::string(name) == "leaf") << "everybody has that";
  }
}

// A name means one tool: what the ghost shows is what acts.
TEST_F(Shelf, aNameIsNotGivenTwice) {
  atelier_.keepClay("ball", {}, ShelfDrawer::Part::allClay);
  settle();
  atelier_.renameTool(card("ball")->entry, "leaf", {});
  settle();
  EXPECT_NE(card("ball"), nullptr);
  EXPECT_FALSE(atelier_.messages().empty());
  take("leaf");
  const auto starter = atelier_.sculpt.freeform->sculpture;
  atelier_.keepClay("leaf", {}, ShelfDrawer::Part::allClay);  // as after the question
  settle();
  EXPECT_NE(atelier_.sculpt.freeform->sculpture, starter) << "the hand has what acts";
  const auto mine = atelier_.sculpt.freeform->sculpture;
  atelier_.takeTool({"leaf", {}, ToolEntry::Place::starter});
  settle();
  EXPECT_EQ(atelier_.sculpt.freeform->sculpture, mine) << "that one is hidden";
}

TEST_F(Shelf, copiesHaveRings) {
  moveTo(middle());
  settle();
  EXPECT_EQ(atelier_.overlays().rings.size(), 1u);
  atelier_.sculpt.placement.copies = {3, 2, 1};
  atelier_.sculpt.placement.copyStep = glm::dvec3(10);
  const Overlays overlays = atelier_.overlays();
  ASSERT_EQ(overlays.rings.size(), 6u);
  EXPECT_EQ(overlays.rings[5].centre - overlays.rings[0].centre, glm::dvec3(20, 10, 0));
}

TEST_F(Shelf, onePrintIsWhatWasDragged) {
  SculptState& sculpt = atelier_.sculpt;
  sculpt.placement.jitter.size = 0.5;
  EXPECT_EQ(sculpt.strokeFrom({glm::dvec3(0), 1}).placement.jitter.size, 0.5);
  sculpt.placement.anchored = true;
  EXPECT_EQ(sculpt.strokeFrom({glm::dvec3(0), 1}).placement.jitter.size, 0);
}

TEST_F(Shelf, theGhostIsThereWhenAPanelLetsGo) {
  take("leaf");
  moveTo({400, 60});
  settle();
  atelier_.dialog = Dialog::help;
  settle();
  EXPECT_FALSE(atelier_.hover().inside);
  atelier_.dialog = Dialog::none;
  settle();
  EXPECT_TRUE(atelier_.hover().inside) << "without a move of the pointer";
}

TEST_F(Shelf, anAnchoredDragShowsTheSizeItWillHave) {
  take("leaf");
  Placement& placement = atelier_.sculpt.placement;
  placement = {};
  placement.anchored = placement.alongStroke = true;
  atelier_.sculpt.size = 5;
  moveTo(middle());
  settle();
  const auto lengthOf = [](const glm::dmat4& m) { return glm::length(glm::dvec3(m[1])); };
  const Overlays before = atelier_.overlays();
  post(ButtonChanged{Button::left, true});
  moveTo(middle() + glm::dvec2(0, -200));
  settle();
  const Overlays dragged = atelier_.overlays();
  const double grown = dragged.rings[0].radius / before.rings[0].radius;
  EXPECT_GT(grown, 2);
  EXPECT_NEAR(lengthOf(dragged.tools[0].cellsFromTool) / lengthOf(before.tools[0].cellsFromTool),
              grown, 1e-9);
  EXPECT_LT(glm::distance(dragged.rings[0].centre, before.rings[0].centre), 1e-9);
  const glm::dvec3 upright = glm::normalize(glm::dvec3(dragged.tools[0].cellsFromTool[1]));
  EXPECT_GT(glm::dot(upright, atelier_.view.up()), 0.9) << "its y follows the drag";
  post(ButtonChanged{Button::left, false});
  settle();
  expectReplays();
}

}  // namespace
}  // namespace bozzetto::ui
