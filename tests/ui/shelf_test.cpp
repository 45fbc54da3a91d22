// The drawer with shelves: tools are taken, used, kept, renamed, shared and deleted.
#include "bozzetto/scene/scene_file.hpp"
#include "bozzetto/sculptor/shelf_tool.hpp"
#include "bozzetto/tool/fill.hpp"
#include "ui/shelf_window.hpp"

namespace bozzetto::ui {
namespace {

namespace fs = std::filesystem;

TEST_F(Shelf, aSculptureStandsAsASupport) {
  take("leaf");
  moveTo(middle());
  settle();
  tap(letter('Y'));
  settle();
  ASSERT_EQ(atelier_.status().clay.supports.size(), 1u);
  const clay::Support support = atelier_.status().clay.supports[0];
  EXPECT_EQ(support.shape, Shape::freeform);
  ASSERT_EQ(atelier_.status().supportMeshes.size(), 1u);
  EXPECT_GT(atelier_.status().supportMeshes[0]->positions.size(), 100u);
  const Overlays overlays = atelier_.overlays();
  ASSERT_EQ(overlays.tools.size(), 2u) << "the tool and the support";
  EXPECT_EQ(overlays.tools[0].mesh, atelier_.status().supportMeshes[0]);
  const auto mesh = atelier_.status().supportMeshes[0];
  const glm::dvec2 knob =
      atelier_.corner() + pixelOf(atelier_.view, atelier_.extent(), support.centre);
  drag(knob, knob + glm::dvec2(120, 0));
  EXPECT_GT(glm::length(atelier_.status().clay.supports[0].centre - support.centre), 5);
  EXPECT_EQ(atelier_.status().clay.supports[0].sculpture, support.sculpture);
  EXPECT_EQ(atelier_.status().supportMeshes[0], mesh) << "made once";
  expectReplays();
}

TEST_F(Shelf, theDrawerStandsBesideTheTools) {
  EXPECT_TRUE(atelier_.shelf.open);
  EXPECT_EQ(interface_.layout().drawer.low, glm::dvec2(60, 44));
  EXPECT_EQ(interface_.layout().viewport.low.x, 296);
  EXPECT_GE(atelier_.shelf.cards.size(), 12u);
  tap(letter('Q'));
  settle();
  EXPECT_EQ(interface_.layout().viewport.low.x, 60);
}

TEST_F(Shelf, aClickTakesTheToolWithWhatItDoes) {
  click(firstCard());
  ASSERT_TRUE(atelier_.sculpt.isFreeform());
  EXPECT_EQ(atelier_.sculpt.freeform->name, "brick");
  EXPECT_EQ(atelier_.sculpt.action, ActionKind::add);
  EXPECT_TRUE(atelier_.sculpt.ownColours);
  EXPECT_TRUE(atelier_.sculpt.placement.toNormal);
  EXPECT_DOUBLE_EQ(atelier_.sculpt.spacing, 5);
  EXPECT_FALSE(atelier_.sculpt.freeform->mesh->indices.empty());
}

TEST_F(Shelf, everyActionWorksWithASculptureAndReplays) {
  take("leaf");
  ASSERT_TRUE(atelier_.sculpt.isFreeform());
  atelier_.sculpt.size = 14;
  atelier_.sculpt.spacing = 0.6;
  std::uint64_t last = hash();
  double offset = -120;
  for (const ToolRow& row : toolTable()) {
    if (movesClay(row.action) || stiffens(row.action)) continue;
    atelier_.setTool(row.action);
    const glm::dvec2 from = middle() + glm::dvec2(offset, -40);
    drag(from, from + glm::dvec2(24, 50));
    offset += 28;
    EXPECT_NE(hash(), last) << row.title;
    last = hash();
  }
  expectReplays();
}

TEST_F(Shelf, aPushWithASculptureReplays) {
  take("thumb");
  atelier_.setTool(ActionKind::push);
  atelier_.sculpt.size = 8;
  const std::uint64_t before = hash();
  drag(middle(), middle() + glm::dvec2(20, 8));
  EXPECT_NE(hash(), before);
  expectReplays();
}

TEST_F(Shelf, theGhostStandsOnTheClay) {
  take("leaf");
  moveTo(middle());
  settle();
  for (const ToolDisplay display : {ToolDisplay::solid, ToolDisplay::wire}) {
    atelier_.options.tool = display;
    const Overlays overlays = atelier_.overlays();
    ASSERT_EQ(overlays.tools.size(), 1u);
    EXPECT_EQ(overlays.tools[0].display, display);
    EXPECT_EQ(overlays.tools[0].mesh, atelier_.sculpt.freeform->mesh);
    // Its contact side, −z, faces into the clay.
    const glm::dvec3 outward(overlays.tools[0].cellsFromTool[2]);
    EXPECT_GT(glm::dot(glm::normalize(outward), atelier_.hover().ground->normal), 0.999);
  }
}

TEST_F(Shelf, aRegionIsKeptTakenAndReplayed) {
  drag(middle(), middle() + glm::dvec2(60, 20));
  atelier_.options.boxSize = WorkspaceBox{{0, -60, 0}, {60, 60, 60}};
  atelier_.keepClay("corner", {"part"}, ShelfDrawer::Part::insideBox);
  settle();
  ASSERT_NE(card("corner"), nullptr);
  EXPECT_EQ(card("corner")->entry.place, ToolEntry::Place::document);
  take("corner");
  EXPECT_GT(atelier_.sculpt.freeform->size, 20);
  atelier_.sculpt.size = 12;
  drag(middle() + glm::dvec2(-80, 0), middle() + glm::dvec2(-60, 30));
  expectReplays();
}

TEST_F(Shelf, theKeepFormWorksByPointerAndKeys) {
  const Rect& at = interface_.layout().drawer;
  click({at.low.x + 40, at.high.y - 26});  // Keep…
  ASSERT_EQ(atelier_.shelf.form, ShelfDrawer::Form::keep);
  settle();
  tap(KeyCode::escape);
  settle();
  EXPECT_EQ(atelier_.shelf.form, ShelfDrawer::Form::none);
  click({at.low.x + 40, at.high.y - 26});
  settle();
  tapCtrl(letter('A'));
  type("my ball");
  tap(KeyCode::enter);
  settle();
  EXPECT_EQ(atelier_.shelf.form, ShelfDrawer::Form::none);
  EXPECT_NE(card("my ball"), nullptr);
}

// Drawing what the form asks for never sculpts.
TEST_F(Shelf, aPartInALassoIsDrawnOnce) {
  using Part = ShelfDrawer::Part;
  atelier_.choosePart(Part::insideLasso);
  EXPECT_TRUE(atelier_.drawsLasso());
  atelier_.choosePart(Part::allClay);
  EXPECT_FALSE(atelier_.drawsLasso());
  atelier_.choosePart(Part::insideLasso);
  const std::size_t before = steps();
  click(middle());
  EXPECT_TRUE(atelier_.drawsLasso()) << "a slip of the hand is no lasso";
  circle();
  ASSERT_TRUE(atelier_.lasso());
  EXPECT_FALSE(atelier_.drawsLasso());
  atelier_.choosePart(Part::allClay);
  atelier_.choosePart(Part::insideLasso);
  EXPECT_FALSE(atelier_.drawsLasso()) << "there is one";
  EXPECT_TRUE(atelier_.lasso());
  EXPECT_EQ(steps(), before);
}

TEST_F(Shelf, aTakenNameIsAskedAbout) {
  atelier_.keepClay("ball", {"first"}, ShelfDrawer::Part::allClay);
  settle();
  const Rect& at = interface_.layout().drawer;
  const auto keepAgain = [&] {
    click({at.low.x + 40, at.high.y - 26});  // Keep…
    tapCtrl(letter('A'));
    type("ball");
    tap(KeyCode::enter);
    settle();
  };
  keepAgain();
  ASSERT_EQ(atelier_.shelf.form, ShelfDrawer::Form::replace);
  EXPECT_EQ(card("ball")->entry.tags, std::vector<std::string>{"first"}) << "not yet";
  settle();
  tap(KeyCode::escape);
  settle();
  EXPECT_EQ(atelier_.shelf.form, ShelfDrawer::Form::none);
  keepAgain();
  settle();
  click({at.low.x + 64, at.high.y - 136});  // Cancel
  EXPECT_EQ(atelier_.shelf.form, ShelfDrawer::Form::keep) << "for another name";
  tap(KeyCode::escape);
  settle();
  keepAgain();
  settle();
  click({at.low.x + 64, at.high.y - 170});  // Keep both
  EXPECT_NE(card("ball 2"), nullptr);
  EXPECT_EQ(card("ball")->entry.tags, std::vector<std::string>{"first"});
}

TEST_F(Shelf, toolsAreRenamedSharedAndDeleted) {
  atelier_.keepClay("ball", {}, ShelfDrawer::Part::allClay);
  settle();
  atelier_.renameTool(card("ball")->entry, "orb", {"round"});
  settle();
  EXPECT_EQ(card("ball"), nullptr);
  ASSERT_NE(card("orb"), nullptr);
  EXPECT_EQ(card("orb")->entry.tags, std::vector<std::string>{"round"});
  atelier_.shareTool(card("orb")->entry, folder_ / "orb.bzt");
  settle();
  EXPECT_EQ(loadTool(folder_ / "orb.bzt").name, "orb");
  atelier_.keepForUser(card("orb")->entry, "orb");
  settle();
  EXPECT_TRUE(fs::exists(userToolFolder() / "orb.bzt"));
  atelier_.dropTool(card("orb")->entry);
  settle();
  ASSERT_NE(card("orb"), nullptr) << "the library's is left";
  EXPECT_EQ(card("orb")->entry.place, ToolEntry::Place::user);
  atelier_.renameTool(card("orb")->entry, "globe", {});
  settle();
  EXPECT_TRUE(fs::exists(userToolFolder() / "globe.bzt"));
  atelier_.renameTool(card("globe")->entry, "leaf", {});
  settle();
  EXPECT_TRUE(fs::exists(userToolFolder() / "globe.bzt")) << "a starter is called leaf";
  atelier_.dropTool(card("globe")->entry);
  settle();
  EXPECT_EQ(card("globe"), nullptr);
}

TEST_F(Shelf, filesAndLettersBecomeTools) {
  atelier_.keepClay("ball", {}, ShelfDrawer::Part::allClay);
  settle();
  atelier_.shareTool(card("ball")->entry, folder_ / "sphere.bzt");
  settle();
  post(FilesDropped{{(folder_ / "sphere.bzt").string()}});
  settle();
  EXPECT_NE(card("sphere"), nullptr);
  atelier_.keepLetters("Ab", 12, 3);
  settle();
  ASSERT_NE(card("Ab"), nullptr);
  take("Ab");
  atelier_.setTool(ActionKind::stamp);
  drag(middle(), middle() + glm::dvec2(3, 3));
  expectReplays();
}

TEST_F(Shelf, theShelfIsSavedWithTheScene) {
  atelier_.keepClay("ball", {}, ShelfDrawer::Part::allClay);
  settle();
  const fs::path path = folder_ / "scene.bzt";
  atelier_.saveScene(path);
  settle();
  atelier_.run(Command::newEmpty);
  settle();
  settle();  // the list is asked for when the document has come
  EXPECT_EQ(card("ball"), nullptr);
  atelier_.openScene(path);
  settle();
  settle();
  EXPECT_NE(card("ball"), nullptr);
}

TEST_F(Shelf, searchFindsNamesAndTags) {
  atelier_.shelf.query = "plant";
  int shown = 0;
  for (const ShelfCard& each : atelier_.shelf.cards) shown += atelier_.shelf.shows(each);
  EXPECT_EQ(shown, 1);
}

TEST_F(Null, aStampPrintsAndReplays) {
  tap(letter('D'));
  settle();
  ASSERT_EQ(atelier_.sculpt.action, ActionKind::stamp);
  atelier_.sculpt.stamp.conserving = true;
  atelier_.sculpt.stamp.height = 0.5;
  const std::uint64_t before = hash();
  drag(middle(), middle() + glm::dvec2(30, 8));
  EXPECT_NE(hash(), before);
  expectReplays();
}

TEST_F(Null, dabsStandAsThePlacementSays) {
  Placement& placement = atelier_.sculpt.placement;
  placement.toNormal = placement.alongStroke = true;
  placement.jitter = {0.5, 0.3, 40, 7};
  placement.copies = {2, 1, 1};
  placement.copyStep = {20, 0, 0};
  const double before = mass();
  drag(middle(), middle() + glm::dvec2(60, 20));
  EXPECT_GT(mass(), before);
  placement = {};
  placement.anchored = true;
  atelier_.setTool(ActionKind::remove);
  drag(middle(), middle() + glm::dvec2(0, 50));
  EXPECT_EQ(atelier_.status().last.dabs, 1);
  expectReplays();
}

TEST_F(Shelf, aLassoIsCutPastedAndReplays) {
  const double before = mass();
  atelier_.sculpt.placement.toNormal = true;
  circle();
  ASSERT_TRUE(atelier_.lasso());
  EXPECT_GT(atelier_.overlays().lines.size(), 0u);
  tapCtrl(letter('X'));
  settle();
  EXPECT_LT(mass(), before - 100) << "it is taken away";
  EXPECT_FALSE(atelier_.lasso());
  ASSERT_TRUE(atelier_.sculpt.isFreeform());
  EXPECT_EQ(atelier_.sculpt.freeform->source.from, "shelf:copy");
  EXPECT_EQ(atelier_.actionNow(), ActionKind::add);
  EXPECT_TRUE(atelier_.sculpt.ownColours);
  EXPECT_FALSE(atelier_.sculpt.placement.toNormal) << "it lies as it was";
  const double cut = mass();
  click(middle());
  EXPECT_GT(mass(), cut + 100) << "and put down again";
  expectReplays();
}

TEST_F(Shelf, aPartInTheBoxIsCopiedAndTheClayStays) {
  const double before = mass();
  EXPECT_FALSE(atelier_.isPossible(Command::copyPart)) << "of nothing";
  atelier_.run(Command::fitBox);
  atelier_.options.box = true;
  settle();
  atelier_.options.boxSize->low.x = 0;
  tapCtrl(letter('C'));
  settle();
  EXPECT_EQ(mass(), before);
  ASSERT_TRUE(atelier_.sculpt.isFreeform());
  EXPECT_NEAR(double(atelier_.sculpt.freeform->sculpture->bounds().low.i), 0, 1);
}

TEST_F(Shelf, copiesReplaceCopiesAndNothingElse) {
  atelier_.keepClay("copy", {"mine"}, ShelfDrawer::Part::allClay);
  settle();
  atelier_.run(Command::fitBox);
  atelier_.options.box = true;
  settle();
  for (int n = 0; n < 2; ++n) {
    tapCtrl(letter('C'));
    settle();
    EXPECT_EQ(atelier_.sculpt.freeform->name, "copy 2");
  }
  EXPECT_EQ(card("copy")->entry.tags, std::vector<std::string>{"mine"});
}

TEST_F(Shelf, aLassoIsKeptOnTheShelf) {
  circle();
  atelier_.keepClay("disc", {}, ShelfDrawer::Part::insideLasso);
  settle();
  atelier_.listShelf();
  settle();
  const auto same = [](const ShelfCard& card) { return card.entry.name == "disc"; };
  EXPECT_EQ(std::ranges::count_if(atelier_.shelf.cards, same), 1);
}

TEST_F(Shelf, aToolIsUnitedSubtractedIntersected) {
  EXPECT_FALSE(atelier_.isPossible(Command::uniteTool)) << "a ball is no sculpture";
  atelier_.takeTool({"brick", {}, ToolEntry::Place::starter});
  settle();
  moveTo(middle());
  settle();
  const double before = mass();
  tapCtrl(static_cast<KeyCode>('1'));
  settle();
  EXPECT_GT(mass(), before);
  tapCtrl(letter('Z'));
  settle();
  EXPECT_EQ(mass(), before);
  atelier_.run(Command::subtractTool);  // as a menu does: the next click says where
  ASSERT_EQ(atelier_.combining(), Combining::subtract);
  EXPECT_EQ(mass(), before);
  click(middle());
  EXPECT_LT(mass(), before);
  EXPECT_FALSE(atelier_.combining());
  tapCtrl(static_cast<KeyCode>('3'));
  settle();
  EXPECT_LT(mass(), before / 2);
  expectReplays();
}

TEST_F(Shelf, anotherSceneIsUnitedSubtractedIntersected) {
  const fs::path other = folder_ / "other.bzt";
  Document document;
  Edit<CornerBlock<8>> edit(document.field.tree);
  Primitive ball;
  ball.radii = glm::dvec3(9);
  ball.centre = {28, 0, 0};
  fill<8>(edit, document.field.scale, ball);
  edit.commit();
  saveScene(other, document);
  const double before = mass();
  atelier_.run(Command::combineFile);
  ASSERT_EQ(atelier_.dialog, Dialog::combine);
  atelier_.combineFile(other, Combining::unite);
  settle();
  EXPECT_EQ(atelier_.dialog, Dialog::none);
  EXPECT_GT(mass(), before);
  tapCtrl(letter('Z'));
  settle();
  EXPECT_EQ(mass(), before);
  atelier_.combineFile(other, Combining::subtract);
  settle();
  EXPECT_LT(mass(), before);
  atelier_.combineFile(other, Combining::intersect);
  settle();
  EXPECT_LT(mass(), before / 10);
  expectReplays();
}

}  // namespace
}  // namespace bozzetto::ui
