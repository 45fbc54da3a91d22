// Clay that is looked at smoothed: what is shown follows the clay, which stays as it is.
#include "bozzetto/field/smoothed.hpp"

#include "surface/surface_fields.hpp"
#include "ui/kept_look.hpp"
#include "ui/null_window.hpp"

namespace bozzetto::ui {
namespace {

class SmoothedDesk : public ::testing::Test, protected StateFolder {
 protected:
  SmoothedDesk() {
    desk_.newRadius = 16;
    desk_.startNew(NewClay::ball);
  }
  void expectFollows() {
    const Clay now = smoothed(desk_.sculptor().field());
    EXPECT_EQ(fieldHash(desk_.shownClay()), fieldHash(now));
    EXPECT_TRUE(testing::samePatches(desk_.shownSurface(), testing::surfaceOf(now)));
  }
  // A stroke into its left, but for its end.
  void beginStroke(ActionKind kind) {
    HandOperations hand;
    hand.tool.shape.radii = glm::dvec3(5);
    hand.action.action.kind = kind;
    Stroke stroke;
    stroke.points = {{{-20, 6, 0}, 1}};
    desk_.beginStroke(hand, stroke);
    const StrokePoint next[] = {{{-14, 7, 0}, 1}, {{-10, 7, 0}, 1}};
    desk_.extendStroke(next);
    while (desk_.dab()) desk_.showDabs();
  }

  ClayDesk desk_;
};

TEST_F(SmoothedDesk, followsEveryDabAndEveryStep) {
  desk_.setSmoothing(Smoothing::shown);
  expectFollows();
  for (const ActionKind kind : {ActionKind::add, ActionKind::push}) {
    beginStroke(kind);
    expectFollows();
    desk_.endStroke();
    expectFollows();
  }
  beginStroke(ActionKind::remove);
  desk_.cancelStroke();
  expectFollows();
  desk_.apply(UndoOperation{1});
  expectFollows();
  desk_.apply(ResampleOperation{1.5});
  expectFollows();
  desk_.startNew(NewClay::block);
  expectFollows();
}

TEST_F(SmoothedDesk, theClayIsNotTouched) {
  desk_.setSmoothing(Smoothing::shown);
  beginStroke(ActionKind::push);
  desk_.endStroke();
  const std::uint64_t hash = fieldHash(desk_.sculptor().field());
  EXPECT_NE(fieldHash(desk_.shownClay()), hash);
  ClayDesk sharp;
  sharp.newRadius = 16;
  sharp.startNew(NewClay::ball);
  for (std::size_t n = 1; n < desk_.recording().operations.size(); ++n)
    sharp.apply(desk_.recording().operations[n]);
  EXPECT_EQ(fieldHash(sharp.sculptor().field()), hash);
  desk_.setSmoothing(Smoothing::none);
  EXPECT_EQ(fieldHash(desk_.shownClay()), hash);
  EXPECT_EQ(&desk_.shownSurface(), &desk_.sculptor().surface());
}

// What a window has of patches after everything equals what it gets anew.
TEST_F(SmoothedDesk, theWindowHasWhatIsShown) {
  desk_.setSmoothing(Smoothing::shown);
  PatchSet window;
  const auto take = [&] {
    const Publication fresh = desk_.take();
    if (fresh.cleared) window.clear();
    for (const auto& [key, patch] : fresh.fine) window.put(key, patch);
  };
  const auto expectAll = [&](const char* when) {
    take();
    EXPECT_EQ(window.triangles(), std::size_t(desk_.shownSurface().totals().triangles)) << when;
  };
  expectAll("at first");
  const StepNumber first = desk_.sculptor().history().place();
  beginStroke(ActionKind::add);
  desk_.endStroke();
  expectAll("a stroke");
  const std::size_t triangles = window.triangles();
  desk_.peek(first);
  take();
  EXPECT_NE(window.triangles(), triangles);
  desk_.peek(std::nullopt);
  expectAll("a look at another state");
  EXPECT_EQ(window.triangles(), triangles);
}

// Cloths are of the smoothed clay too, and the surface catches up behind them.
TEST_F(SmoothedDesk, catchesUpBehindCloths) {
  desk_.setSmoothing(Smoothing::shown);
  desk_.setHeightSwitch(HeightSwitch(0, 0));
  desk_.seenFrom(Camera{});
  beginStroke(ActionKind::push);
  desk_.endStroke();
  expectFollows();
}

TEST(Smoothed, IsKeptWithTheScene) {
  ViewOptions options;
  options.smoothed = true;
  ViewOptions read;
  takeLook(lookText(options), read);
  EXPECT_TRUE(read.smoothed);
}

TEST(Smoothed, TheSwitchShowsItAtOnce) {
  const StateFolder state;
  NullWindow window;
  const std::uint64_t hash = window.hash();
  const std::size_t sharp = window.atelier_.patches().triangles();
  window.atelier_.options.smoothed = true;
  window.settle();
  EXPECT_NE(window.atelier_.patches().triangles(), sharp);
  EXPECT_EQ(window.hash(), hash);
  window.atelier_.options.smoothed = false;
  window.settle();
  EXPECT_EQ(window.atelier_.patches().triangles(), sharp);
}

}  // namespace
}  // namespace bozzetto::ui
