// Lights in the hand: handles in the viewport, their undo, what the scene keeps of them.
#include <glm/geometric.hpp>

#include "ui/kept_look.hpp"
#include "ui/null_window.hpp"

namespace bozzetto::ui {
namespace {

class Lights : public Null {
 protected:
  Lights() { atelier_.run(Command::moveLight); }

  Studio& studio() { return atelier_.options.look.studio; }
  // Where a light's handle is on the screen.
  glm::dvec2 handle(std::size_t n) {
    const glm::dvec3 place =
        atelier_.overlays().lights.at(n).place * atelier_.status().scale.spacing;
    return atelier_.corner() + pixelOf(atelier_.view, atelier_.extent(), place);
  }
};

TEST_F(Lights, handlesShowWhileLightsAreMoved) {
  EXPECT_EQ(atelier_.overlays().lights.size(), studio().lights.size());
  for (std::size_t n = 0; n < studio().lights.size(); ++n) {
    EXPECT_TRUE(interface_.layout().viewport.contains(handle(n))) << n;
  }
  atelier_.run(Command::moveScene);
  EXPECT_TRUE(atelier_.overlays().lights.empty());
}

TEST_F(Lights, aHandleFollowsThePointerAndTheClayStays) {
  const std::uint64_t clay = hash();
  const Studio before = studio();
  const glm::dvec2 to = middle() + glm::dvec2(60, 90);
  drag(handle(0), to);
  EXPECT_LT(glm::distance(handle(0), to), 1.5);
  EXPECT_EQ(hash(), clay);
  for (std::size_t n = 1; n < before.lights.size(); ++n)
    EXPECT_EQ(studio().lights[n], before.lights[n]);
}

TEST_F(Lights, beyondTheRimItGoesBehind) {
  const glm::dvec3 back = atelier_.view.back();
  const auto depth = [&] {
    return glm::dot(atelier_.overlays().lights[0].place - atelier_.overlays().lights[0].target,
                    back);
  };
  EXPECT_GT(depth(), 0);
  drag(handle(0), middle() + glm::dvec2(0, -380));
  EXPECT_LT(depth(), 0);
  drag(handle(0), middle() + glm::dvec2(0, -380));  // and back again
  EXPECT_GT(depth(), 0);
}

TEST_F(Lights, oneFixedToTheClayIsAimedAsItIsSeen) {
  studio().lights[1].frame = LightFrame::scene;
  studio().turn = 0.7f;
  settle();
  for (const std::size_t n : {0u, 1u}) {
    const glm::dvec2 to = handle(n) * 0.8 + middle() * 0.2;
    drag(handle(n), to);
    EXPECT_LT(glm::distance(handle(n), to), 1.5) << n;
  }
}

TEST_F(Lights, theViewsUndoTakesThemBack) {
  const Studio before = studio();
  drag(handle(0), middle());
  const Studio after = studio();
  ASSERT_NE(after, before);
  atelier_.run(Command::undoView);
  EXPECT_EQ(studio(), before);
  atelier_.run(Command::redoView);
  EXPECT_EQ(studio(), after);
}

TEST_F(Lights, theirKeyAndEscapeLetThemGo) {
  for (const KeyCode key : {KeyCode::escape, KeyCode(int(KeyCode::f1) + 3)}) {
    atelier_.run(Command::moveScene);
    atelier_.run(Command::moveLight);
    ASSERT_EQ(atelier_.mouseMoves, Moves::light);
    tap(key);
    settle();
    EXPECT_EQ(atelier_.mouseMoves, Moves::scene);
    EXPECT_EQ(atelier_.puckMoves, Moves::scene);
    EXPECT_TRUE(atelier_.overlays().lights.empty());
  }
}

TEST_F(Lights, theSceneKeepsThem) {
  testing::Folder folder;
  const std::filesystem::path path = folder / "lit.bzt";
  drag(handle(0), middle() + glm::dvec2(100, 40));
  studio().lights[1].colour = {0.2f, 1.1f, 2.2f};
  const Studio kept = studio();
  atelier_.saveScene(path);
  settle();
  studio() = Studio();
  atelier_.openScene(path);
  settle();
  ASSERT_EQ(studio().lights.size(), kept.lights.size());
  for (std::size_t n = 0; n < kept.lights.size(); ++n) {
    const StudioLight& light = studio().lights[n];
    EXPECT_LT(glm::distance(light.towards, kept.lights[n].towards), 1e-5) << n;
    EXPECT_LT(glm::distance(light.colour, kept.lights[n].colour), 0.03) << n;
  }
}

TEST_F(Lights, theSceneKeepsSoftBoxesAndWhatTheyAreFixedTo) {
  testing::Folder folder;
  const std::filesystem::path path = folder / "lit.bzt";
  studio() = Studio(Environment::dusk);
  studio().turn = 0.4f;
  studio().lights.push_back(studio().lights[0]);
  studio().lights[1].frame = LightFrame::scene;
  studio().lights[0].box = {{.3f, .2f}, .15f, {4, 3, 2}};
  atelier_.options.look.mode = Mode::glaze;
  const Look kept = atelier_.options.look;
  atelier_.saveScene(path);
  settle();
  studio() = Studio();
  atelier_.options.look.mode = Mode::clay;
  atelier_.openScene(path);
  settle();
  EXPECT_EQ(studio(), kept.studio);
  EXPECT_EQ(atelier_.options.look.mode, kept.mode);
}

TEST(KeptLook, damageIsHarmless) {
  ViewOptions options;
  options.references.resize(1);
  options.references[0].from = "/no/such/picture.png";
  const std::string text = lookText(options);
  for (std::size_t n = 0; n < text.size(); ++n) {
    takeLook(text.substr(0, n), options);
    takeLook(text.substr(0, n) + "9" + text.substr(n + 1), options);
  }
  takeLook(text, options);
  EXPECT_EQ(options.look, Look{});
  ASSERT_EQ(options.references.size(), 1u) << "for when the picture comes back";
  EXPECT_FALSE(options.references[0].picture.image);
  takeLook(R"({"studio":{"turn":1e999,"lights":[3,{"towards":[0,0,0],"colour":[1]}]},"mode":7})",
           options);
  EXPECT_EQ(options.look.mode, Mode::clay);
}

}  // namespace
}  // namespace bozzetto::ui
