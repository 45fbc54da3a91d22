// The drawer with shelves: tools are taken, used, kept, renamed, shared and deleted.
#include <cmath>
#include <cstdlib>

#include "bozzetto/scene/scene_file.hpp"
#include "bozzetto/sculptor/shelf_tool.hpp"
#include "bozzetto/tool/fill.hpp"
#include "ui/null_window.hpp"

namespace bozzetto::ui {
namespace {

namespace fs = std::filesystem;

class Shelf : public Null {
 protected:
  Shelf() {
    ::setenv("XDG_DATA_HOME", folder_.path().c_str(), 1);
    tap(letter('Q'));
    settle();
  }

  const ShelfCard* card(const std::string& name) {
    for (const ShelfCard& each : atelier_.shelf.cards)
      if (each.entry.name == name) return &each;
    return nullptr;
  }
  void take(const std::string& name) {
    ASSERT_NE(card(name), nullptr) << name;
    atelier_.takeTool(card(name)->entry);
    settle();
  }
  // A lasso round the middle of the view, a third as high as it.
  void circle() {
    tapCtrl(letter('L'));
    settle();
    const double radius = atelier_.extent().height / 6;
    const auto at = [&](int n) {
      const double turn = 6.283185307179586 * n / 24;
      return middle() + radius * glm::dvec2(std::cos(turn), std::sin(turn));
    };
    moveTo(at(0));
    settle();
    post(ButtonChanged{Button::left, true});
    for (int n = 1; n < 24; ++n) moveTo(at(n));
    post(ButtonChanged{Button::left, false});
    settle();
  }
  // Of the first card.
  glm::dvec2 firstCard() const { return interface_.layout().drawer.low + glm::dvec2(44, 170); }

  const testing::Folder folder_;
};

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
  click({at.low.x + 64, at.high.y - 136});  // Keep both
  EXPECT_NE(card("ball 2"), nullptr);
  EXPECT_EQ(card("ball")->entry.tags, std::vector<std::string>{"first"});
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
