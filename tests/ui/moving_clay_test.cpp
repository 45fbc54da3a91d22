// Clay that moves, in the window: layers, supports, hold, relaxing, the ledger.
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
  EXPECT_EQ(atelier_.status().movedSteps, 1u);
  EXPECT_LT(std::abs(atelier_.status().drift), 1e-6 * mass());
  expectReplays();
}

TEST_F(Moving, relaxIsOneStep) {
  drag(middle(), middle() + glm::dvec2(30, 10));
  const std::size_t before = steps();
  atelier_.relaxSteps = 2;
  tap(letter('R'));
  settle();
  EXPECT_EQ(steps(), before + 1);
  EXPECT_EQ(atelier_.status().movedSteps, 2u);
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

TEST_F(Moving, theBoxIsHeldAndLetGo) {
  atelier_.run(Command::fitBox);
  const std::size_t before = steps();
  atelier_.run(Command::holdBox);
  settle();
  EXPECT_EQ(steps(), before + 1);
  const std::uint64_t held = hash();
  drag(middle(), middle() + glm::dvec2(30, 10));
  EXPECT_EQ(hash(), held) << "held clay stays";
  atelier_.run(Command::releaseHold);
  settle();
  EXPECT_NE(hash(), held);
  expectReplays();
}

}  // namespace
}  // namespace bozzetto::ui
