// Clay that moves, in the window: layers, supports, hold, relaxing, the ledger.
#include "bozzetto/clay/idle.hpp"
#include "ui/null_window.hpp"

namespace bozzetto::ui {
namespace {

class Moving : public Null {
 protected:
  Moving() {
    tap(letter('G'));  // push
    settle();
    atelier_.sculpt.size = 8;
  }
};

TEST_F(Moving, aPushTakesThePanelsSettingsAndKeepsTheMass) {
  atelier_.sculpt.clay.stiffness = 0.2;
  atelier_.sculpt.clay.layers = {clay::LayerKind::conservation, clay::LayerKind::tension};
  drag(middle(), middle() + glm::dvec2(30, 10));
  EXPECT_EQ(atelier_.status().clay.settings.stiffness, 0.2);
  EXPECT_EQ(atelier_.status().clay.settings.layers.size(), 2u);
  EXPECT_EQ(atelier_.status().ledger.moves, 1);
  EXPECT_LT(std::abs(atelier_.status().ledger.drift), 1e-6 * mass());
  expectReplays();
}

TEST_F(Moving, relaxIsOneStep) {
  drag(middle(), middle() + glm::dvec2(30, 10));
  const std::size_t before = steps();
  atelier_.relaxSteps = 2;
  tap(letter('R'));
  settle();
  EXPECT_EQ(steps(), before + 1);
  EXPECT_EQ(atelier_.status().ledger.moves, 2);
  expectReplays();
}

TEST_F(Moving, supportsArePlacedDraggedAndTakenAway) {
  moveTo(middle());
  settle();
  tap(letter('Y'));
  settle();
  ASSERT_EQ(atelier_.status().clay.supports.size(), 1u);
  EXPECT_EQ(atelier_.overlays().tools.size(), 2u) << "the tool and the support";
  const glm::dvec3 placed = atelier_.status().clay.supports[0].centre;
  const std::uint64_t clay = hash();
  drag(middle(), middle() + glm::dvec2(120, 0));  // takes the knob, not the clay
  const glm::dvec3 moved = atelier_.status().clay.supports[0].centre;
  EXPECT_GT(glm::length(moved - placed), 5);
  EXPECT_EQ(hash(), clay);
  std::size_t moves = 0;
  atelier_.worker().post([&](ClayDesk& desk) {
    for (const Operation& each : desk.recording().operations)
      moves += std::holds_alternative<SupportMoveOperation>(each);
  });
  settle();
  EXPECT_EQ(moves, 1u) << "one move, however many pixels";
  atelier_.run(Command::placeTable);
  settle();
  EXPECT_EQ(atelier_.status().clay.supports.size(), 2u);
  drag(middle() + glm::dvec2(0, -60), middle() + glm::dvec2(10, -30));
  atelier_.dropSupport(0);
  settle();
  EXPECT_EQ(atelier_.status().clay.supports.size(), 1u);
  expectReplays();
}

TEST_F(Moving, undoPutsASupportBack) {
  moveTo(middle());
  settle();
  tap(letter('Y'));
  settle();
  const auto centre = [&] { return atelier_.status().clay.supports.at(0).centre; };
  const glm::dvec3 placed = centre();
  const std::size_t before = steps();
  drag(middle(), middle() + glm::dvec2(120, 0));
  const glm::dvec3 moved = centre();
  EXPECT_NE(moved, placed);
  EXPECT_EQ(steps(), before + 1);
  tapCtrl(letter('Z'));
  settle();
  EXPECT_EQ(centre(), placed);
  tapCtrl(letter('Z'));
  settle();
  EXPECT_TRUE(atelier_.status().clay.supports.empty());
  atelier_.run(Command::redo);
  atelier_.run(Command::redo);
  settle();
  EXPECT_EQ(centre(), moved);
  atelier_.chosenSupport = 0;
  tap(KeyCode::del);
  settle();
  EXPECT_TRUE(atelier_.status().clay.supports.empty());
  tapCtrl(letter('Z'));
  settle();
  EXPECT_EQ(centre(), moved);
}

TEST_F(Moving, shiftTurnsASupportCtrlBringsItNearerEscLeavesIt) {
  moveTo(middle());
  settle();
  tap(letter('Y'));
  settle();
  const auto support = [&] { return atelier_.status().clay.supports.at(0); };
  const clay::Support placed = support();
  const std::size_t before = steps();
  post(KeyChanged{KeyCode::leftShift, true, false});
  drag(middle(), middle() + glm::dvec2(40, 0));
  post(KeyChanged{KeyCode::leftShift, false, false});
  EXPECT_EQ(support().centre, placed.centre);
  EXPECT_NE(support().rotation, placed.rotation);
  const glm::dquat turned = support().rotation;
  post(KeyChanged{KeyCode::leftControl, true, false});
  drag(middle(), middle() + glm::dvec2(0, 50));
  post(KeyChanged{KeyCode::leftControl, false, false});
  EXPECT_EQ(support().rotation, turned);
  const glm::dvec3 way = support().centre - placed.centre;
  EXPECT_GT(glm::dot(way, atelier_.view.back()), 0.99 * glm::length(way));
  EXPECT_GT(glm::length(way), 1);
  EXPECT_EQ(steps(), before + 2);
  const clay::Support there = support();
  moveTo(middle());
  settle();
  post(ButtonChanged{Button::left, true});
  moveTo(middle() + glm::dvec2(50, 50));
  settle();
  EXPECT_NE(support().centre, there.centre);
  tap(KeyCode::escape);
  post(ButtonChanged{Button::left, false});
  settle();
  EXPECT_EQ(support().centre, there.centre);
  EXPECT_EQ(steps(), before + 2);
}

TEST_F(Moving, ctrlLetsHeldClayGo) {
  const auto held = [&] {
    std::uint64_t sum = 0;
    atelier_.worker().post([&](ClayDesk& desk) {
      for (const auto& [key, run] : desk.sculptor().field().tree)
        for (const Attributes each : run.block->attributes) sum += holdOf(each);
    });
    settle();
    return sum;
  };
  tap(letter('M'));
  settle();
  ASSERT_EQ(atelier_.sculpt.action, ActionKind::hold);
  drag(middle(), middle() + glm::dvec2(30, 10));
  const std::uint64_t much = held();
  EXPECT_GT(much, 1000u);
  drag(middle(), middle() + glm::dvec2(30, 10));
  EXPECT_GE(held(), much);
  post(KeyChanged{KeyCode::leftControl, true, false});
  settle();
  EXPECT_EQ(atelier_.actionNow(), ActionKind::free);
  drag(middle(), middle() + glm::dvec2(30, 10));
  EXPECT_LT(held(), much * 2 / 3);
  drag(middle(), middle() + glm::dvec2(30, 10));
  EXPECT_LT(held(), much * 4 / 9) << "the rims go more slowly";
  post(KeyChanged{KeyCode::leftControl, false, false});
  expectReplays();
}

// A layer that is off has lost its number, not its place.
TEST_F(Moving, theDocumentKeepsWhatThePanelSays) {
  atelier_.sculpt.clay.stiffness = 0.2;
  settle();
  EXPECT_EQ(atelier_.status().clay.settings.stiffness, 0.2);
  EXPECT_EQ(atelier_.sculpt.layerOrder.size(), 5u);
  atelier_.sculpt.clay.layers = {clay::LayerKind::conservation, clay::LayerKind::tension};
  settle();
  EXPECT_EQ(atelier_.status().clay.settings.layers.size(), 2u);
  EXPECT_EQ(atelier_.sculpt.layerOrder[0], clay::LayerKind::displacement);
}

TEST_F(Moving, theBoxIsHeldAndLetGo) {
  atelier_.run(Command::holdBox);
  ASSERT_EQ(atelier_.messages().size(), 1u) << "it is shown first";
  const std::size_t before = steps();
  atelier_.run(Command::holdBox);
  settle();
  EXPECT_EQ(steps(), before + 1);
  atelier_.worker().post([](ClayDesk& desk) {
    for (const auto& [key, run] : desk.sculptor().field().tree)
      for (std::size_t n = 0; n < run.block->value.size(); ++n)
        if (run.block->value[n] > 0) {
          EXPECT_GT(holdOf(run.block->attributes[n]), 0) << "all of it";
        }
  });
  const std::uint64_t held = hash();
  drag(middle(), middle() + glm::dvec2(30, 10));
  EXPECT_EQ(hash(), held) << "held clay stays";
  atelier_.run(Command::releaseHold);
  settle();
  EXPECT_NE(hash(), held);
  expectReplays();
}

// The tool starts outside: pressing the button makes no crater as deep as the tool.
TEST_F(Moving, aPressSinksByAShareOfTheRadius) {
  const auto front = [&] {
    moveTo(middle());
    settle();
    return glm::dot(atelier_.hover().ground.value().position, atelier_.view.back());
  };
  atelier_.sculpt.clay.stiffness = 0;
  for (const double depth : {0.25, 0.5}) {
    atelier_.sculpt.strengthOf(ActionKind::push) = depth;
    const double before = front();
    const glm::dvec3 ghost(atelier_.overlays().tools.at(0).cellsFromTool[3]);
    const double spacing = atelier_.status().scale.spacing;
    EXPECT_NEAR(glm::dot(ghost, atelier_.view.back()) * spacing - before, 8 * (1 - depth), 0.4)
        << "the ghost stands where the tool will";
    click(middle());
    EXPECT_NEAR(before - front(), 8 * depth, 0.8) << depth;
  }
  expectReplays();
}

// Pressure is depth: the points say what the tool did.
TEST_F(Moving, recordingsOfPushesHoldNothingThatPlaysNoPart) {
  atelier_.sculpt.pressureStrength = true;
  atelier_.sculpt.placement.toNormal = true;
  atelier_.sculpt.placement.roll = 1;
  atelier_.sculpt.placement.copies = {2, 1, 1};
  atelier_.sculpt.placement.copyStep = glm::dvec3(6, 0, 0);
  drag(middle(), middle() + glm::dvec2(30, 10));
  atelier_.worker().post([](ClayDesk& desk) {
    const auto& last = std::get<StrokeOperation>(desk.recording().operations.back()).stroke;
    EXPECT_FALSE(last.pressure.strength);
    EXPECT_FALSE(last.placement.toNormal);
    EXPECT_EQ(last.placement.copies[0], 2);
    EXPECT_TRUE(clay::idleIn(last, clay::Role::push, {}).empty());
  });
  settle();
  EXPECT_TRUE(atelier_.sculpt.placement.toNormal) << "the hand keeps it for other tools";
  expectReplays();
  for (const Message& message : atelier_.messages())
    EXPECT_EQ(message.text.find("play no part"), std::string::npos) << message.text;
}

// What the ghost shows acts: a tool that faces the surface is turned as the stroke begins.
TEST_F(Moving, aToolThatFacesTheSurfacePushesAsItStands) {
  atelier_.sculpt.shape = Shape::box;
  atelier_.sculpt.placement.toNormal = true;
  const glm::dvec2 at = middle() + glm::dvec2(60, -50);
  moveTo(at);
  settle();
  const glm::dvec3 normal = atelier_.hover().ground.value().normal;
  click(at);
  atelier_.worker().post([&](ClayDesk& desk) {
    const ToolShape& tool = desk.sculptor().tool();
    EXPECT_GT(glm::dot(tool.rotation * glm::dvec3(0, 0, 1), normal), 0.999);
  });
  settle();
}

TEST_F(Moving, whatAStrokeIsToldIsSaid) {
  clay::Support thin;
  thin.radii = {30, 0.25, 30};
  thin.centre = {0, -40, 0};
  atelier_.apply(SupportOperation{thin});
  settle();
  now_ += 100;  // that message is gone
  frame();
  ASSERT_TRUE(atelier_.messages().empty());
  const ToolGhost ghost = atelier_.overlays().tools.at(0);
  EXPECT_NEAR(glm::length(glm::dvec3(ghost.cellsFromTool[1])), 1, 1e-9) << "as clay meets it";
  click(middle());
  ASSERT_EQ(atelier_.messages().size(), 1u);
  EXPECT_NE(atelier_.messages()[0].text.find("support of 0.5 cells widened"), std::string::npos);
}

TEST_F(Moving, aToolThatIsWidenedIsSaid) {
  atelier_.sculpt.size = 0.25 * atelier_.status().scale.spacing;
  click(middle());
  ASSERT_FALSE(atelier_.messages().empty());
  EXPECT_NE(atelier_.messages()[0].text.find("tool radius"), std::string::npos);
}

}  // namespace
}  // namespace bozzetto::ui
