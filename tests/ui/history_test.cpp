// What the window makes of the history: it goes on after reopening, nothing is lost with the
// window, a second one is told, panels lead anywhere.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <thread>

#include "bozzetto/base/file.hpp"
#include "support/faulty_file_system.hpp"
#include "ui/null_window.hpp"

namespace bozzetto::ui {
namespace {

namespace fs = std::filesystem;

class InFolder : public ::testing::Test, protected StateFolder {
 protected:
  // A scene with a saved stroke, closed as one should.
  double savedScene() {
    NullWindow window(scene_);
    window.drag(window.middle(), window.middle() + glm::dvec2(60, 20));
    window.atelier_.run(Command::save);
    window.settle();
    EXPECT_FALSE(window.atelier_.isModified());
    window.atelier_.askToClose();
    window.settle();
    EXPECT_TRUE(window.atelier_.wantsToClose());
    return window.mass();
  }
  // And one with a stroke that was not saved when the program went.
  double crashedScene() {
    savedScene();
    NullWindow window(scene_);
    window.drag(window.middle(), window.middle() + glm::dvec2(-60, 20));
    return window.mass();
  }
  static std::uint64_t hashOf(NullWindow& window) {
    std::uint64_t hash = 0;
    window.atelier_.worker().post(
        [&](ClayDesk& desk) { hash = fieldHash(desk.sculptor().field()); });
    window.settle();
    return hash;
  }

  testing::Folder folder_;
  const fs::path scene_ = folder_ / "faun.bzt";
};

TEST_F(InFolder, undoGoesOnAfterReopening) {
  savedScene();
  NullWindow window(scene_);
  EXPECT_EQ(window.atelier_.dialog, Dialog::none) << "nothing to recover, nothing to ask";
  EXPECT_FALSE(window.atelier_.isModified());
  EXPECT_EQ(window.steps(), 2u);
  EXPECT_EQ(window.atelier_.status().history->steps[1].title, "Add clay");
  window.tapCtrl(letter('Z'));
  window.settle();
  EXPECT_EQ(window.steps(), 1u);
  EXPECT_TRUE(window.atelier_.isModified());
  window.tapCtrl(letter('Y'));
  window.settle();
  EXPECT_FALSE(window.atelier_.isModified()) << "as the file has it";
}

TEST_F(InFolder, whatWasNotSavedComesBackWithTheWindow) {
  const double mass = crashedScene();
  NullWindow window(scene_);
  EXPECT_EQ(window.atelier_.dialog, Dialog::recovered);
  EXPECT_EQ(window.atelier_.document().findings.unsavedSteps, 1u);
  EXPECT_TRUE(window.atelier_.isModified());
  window.tap(KeyCode::enter);  // the button in front: go on
  window.settle();
  EXPECT_EQ(window.atelier_.dialog, Dialog::none);
  window.atelier_.apply(SceneOperation{});
  window.settle();
  EXPECT_DOUBLE_EQ(window.mass(), mass);
}

TEST_F(InFolder, supportsThatWereNotSavedComeBackToo) {
  savedScene();
  {
    NullWindow window(scene_);
    window.atelier_.apply(SupportOperation{});
    window.settle();
  }
  NullWindow window(scene_);
  EXPECT_EQ(window.atelier_.status().clay.supports.size(), 1u);
  EXPECT_EQ(window.atelier_.dialog, Dialog::recovered) << "a support is a step, unsaved so far";
  EXPECT_TRUE(window.atelier_.isModified());
}

TEST_F(InFolder, theSavedFileIsAStepAway) {
  crashedScene();
  NullWindow window(scene_);
  const std::uint64_t recovered = hashOf(window);
  const StepNumber place = window.atelier_.status().history->place;
  window.atelier_.answerRecovered(true);
  window.settle();
  EXPECT_FALSE(window.atelier_.isModified());
  EXPECT_EQ(hashOf(window), fieldHash(loadScene(scene_).field));
  window.atelier_.goTo(place);
  window.settle();
  EXPECT_EQ(hashOf(window), recovered) << "nothing is lost";
}

TEST_F(InFolder, workWithoutANameIsOfferedAgain) {
  double mass = 0;
  {
    NullWindow window;
    EXPECT_EQ(window.atelier_.dialog, Dialog::none);
    window.drag(window.middle(), window.middle() + glm::dvec2(60, 20));
    mass = window.mass();
  }
  NullWindow window;
  ASSERT_EQ(window.atelier_.dialog, Dialog::leftBehind);
  ASSERT_EQ(window.atelier_.leftBehind().size(), 1u);
  EXPECT_EQ(window.atelier_.leftBehind()[0].glance.steps, 2u);
  window.atelier_.openLeftBehind(window.atelier_.leftBehind()[0].path);
  window.settle();
  EXPECT_EQ(window.atelier_.dialog, Dialog::none) << "it was asked for";
  EXPECT_TRUE(window.atelier_.path().empty());
  EXPECT_TRUE(window.atelier_.isModified());
  window.atelier_.apply(SceneOperation{});
  window.settle();
  EXPECT_DOUBLE_EQ(window.mass(), mass);
}

TEST_F(InFolder, workWithoutANameCanBeDiscarded) {
  {
    NullWindow window;
    window.drag(window.middle(), window.middle() + glm::dvec2(60, 20));
  }
  NullWindow window;
  ASSERT_EQ(window.atelier_.leftBehind().size(), 1u);
  window.atelier_.discardLeftBehind(window.atelier_.leftBehind()[0].path);
  window.settle();
  EXPECT_EQ(window.atelier_.dialog, Dialog::none);
  EXPECT_TRUE(Session::leftBehind().empty());
}

TEST_F(InFolder, aBallThatNobodyTouchedIsNoWork) {
  { NullWindow crashed; }
  EXPECT_EQ(Session::leftBehind().size(), 1u);
  {
    NullWindow window;
    EXPECT_EQ(window.atelier_.dialog, Dialog::none);
    window.atelier_.askToClose();
    window.settle();
  }
  EXPECT_TRUE(Session::leftBehind().empty());
  {
    NullWindow window(scene_);
    window.atelier_.askToClose();
    window.settle();
  }
  EXPECT_FALSE(fs::exists(historyFolderOf(scene_)));
}

TEST_F(InFolder, aSecondWindowIsToldAndSavesElsewhere) {
  savedScene();
  ClayDesk first;
  first.open(scene_, Progress::none());
  NullWindow second(scene_);
  EXPECT_TRUE(second.atelier_.status().keeping.readOnly);
  second.drag(second.middle(), second.middle() + glm::dvec2(60, 20));
  const auto before = fs::last_write_time(scene_);
  second.tapCtrl(letter('S'));
  second.settle();
  EXPECT_NE(second.atelier_.messages().back().text.find("save under another name"),
            std::string::npos);
  EXPECT_TRUE(second.atelier_.isModified());
  EXPECT_EQ(fs::last_write_time(scene_), before);
  second.atelier_.saveScene(folder_ / "other.bzt");
  second.settle();
  EXPECT_FALSE(second.atelier_.isModified());
  EXPECT_FALSE(second.atelier_.status().keeping.readOnly);
  EXPECT_EQ(second.atelier_.path(), folder_ / "other.bzt");
}

TEST_F(InFolder, theTreeLeadsToAnyStep) {
  NullWindow window(scene_);
  const auto at = window.middle();
  window.drag(at, at + glm::dvec2(40, 20));
  const std::uint64_t two = hashOf(window);
  window.tapCtrl(letter('Z'));
  window.drag(at, at + glm::dvec2(-40, 20));
  ASSERT_EQ(window.atelier_.status().history->steps.size(), 3u) << "the other branch stays";
  EXPECT_EQ(window.atelier_.status().history->place, 3u);
  window.atelier_.run(Command::history);
  window.settle();
  // The rows are 54 high, the newest on top.
  const Rect& viewport = window.interface_.layout().viewport;
  const glm::dvec2 second{viewport.high.x - 150, viewport.low.y + 112 + 46 + 54 * 1.5};
  window.moveTo(second);
  window.settle();
  window.post(ButtonChanged{Button::left, true});
  window.post(ButtonChanged{Button::left, false});
  window.settle();
  EXPECT_EQ(window.atelier_.status().history->place, 2u);
  EXPECT_EQ(hashOf(window), two);
}

TEST_F(InFolder, stepsAreComparedAndLookedAt) {
  NullWindow window(scene_);
  window.drag(window.middle(), window.middle() + glm::dvec2(60, 20));
  const std::uint64_t now = hashOf(window);
  window.atelier_.run(Command::history);
  window.atelier_.compareWith(1);
  window.settle();
  ASSERT_TRUE(window.atelier_.comparison.has_value());
  EXPECT_GT(window.atelier_.comparison->found.reshaped, 100);
  EXPECT_GT(window.atelier_.comparison->found.massAfter,
            window.atelier_.comparison->found.massBefore);
  const Comparison& found = *window.atelier_.comparison;
  EXPECT_NEAR(found.volumeThen, 4. / 3 * std::numbers::pi * std::pow(NullWindow::kRadius, 3), 100);
  EXPECT_NEAR(found.volumeNow - found.volumeThen, found.found.massAfter - found.found.massBefore,
              0.3 * (found.volumeNow - found.volumeThen));
  EXPECT_EQ(hashOf(window), now);
}

// The clay, its history and its journal know nothing of it.
TEST_F(InFolder, aStepThatIsLookedAtIsOnlySeen) {
  NullWindow window(scene_);
  const std::size_t ball = window.atelier_.patches().triangles();
  window.drag(window.middle(), window.middle() + glm::dvec2(60, 20));
  const std::uint64_t now = hashOf(window);
  const std::size_t triangles = window.atelier_.patches().triangles();
  ASSERT_NE(triangles, ball);
  const auto look = [&](std::optional<StepNumber> step) {
    window.atelier_.worker().post([step](ClayDesk& desk) { desk.peek(step); });
    window.settle();
  };
  const auto journal = [&] {
    std::map<fs::path, std::uintmax_t> sizes;
    for (const auto& entry : fs::recursive_directory_iterator(historyFolderOf(scene_)))
      if (entry.is_regular_file()) sizes[entry.path()] = entry.file_size();
    return sizes;
  };
  const auto before = journal();
  look(1);
  EXPECT_EQ(window.atelier_.status().peek, 1u);
  EXPECT_EQ(window.atelier_.patches().triangles(), ball);
  EXPECT_EQ(window.atelier_.status().history->place, 2u);
  EXPECT_EQ(hashOf(window), now);
  EXPECT_EQ(journal(), before);
  look(std::nullopt);
  EXPECT_EQ(window.atelier_.patches().triangles(), triangles);
  EXPECT_EQ(window.atelier_.status().peek, std::nullopt);
  look(1);
  window.drag(window.middle(), window.middle() + glm::dvec2(-60, 20));
  EXPECT_EQ(window.atelier_.status().peek, std::nullopt) << "whoever works sees the clay";
  EXPECT_NE(hashOf(window), now);
}

TEST_F(InFolder, whatCannotBeOpenedLeavesWhatIsThere) {
  NullWindow window(scene_);
  window.drag(window.middle(), window.middle() + glm::dvec2(60, 20));
  const std::uint64_t now = hashOf(window);
  const fs::path damaged = folder_ / "damaged.bzt", mesh = folder_ / "damaged.ply";
  for (const fs::path& path : {damaged, mesh}) writeFile(path, Bytes(3000, std::byte{7}));
  const auto expectSame = [&] {
    ASSERT_FALSE(window.atelier_.messages().empty());
    EXPECT_EQ(window.atelier_.messages().back().kind, Message::Kind::error);
    EXPECT_EQ(hashOf(window), now);
    EXPECT_EQ(window.atelier_.path(), scene_);
    EXPECT_EQ(window.atelier_.status().done, 2u);
  };
  window.atelier_.openScene(damaged);
  window.settle();
  expectSame();
  window.atelier_.importMesh(mesh, 32);
  window.settle();
  expectSame();
  // Nor does it go when nobody wants it saved.
  window.atelier_.ifSaved([&] { window.atelier_.openScene(damaged); });
  EXPECT_EQ(window.atelier_.dialog, Dialog::unsaved);
  window.atelier_.answerUnsaved(false);
  window.settle();
  expectSame();
  EXPECT_TRUE(window.atelier_.isModified());
}

TEST_F(InFolder, strokesBringThePastBack) {
  NullWindow window(scene_);
  const std::uint64_t ball = hashOf(window);
  const auto at = window.middle();
  window.drag(at, at + glm::dvec2(20, 0));
  const double added = window.mass();
  window.atelier_.recallFrom(1);
  window.atelier_.sculpt.recallStrength = 1;
  for (int n = 0; n < 4; ++n) window.drag(at + glm::dvec2(-20, 0), at + glm::dvec2(50, 0));
  EXPECT_LT(window.mass(), added);
  EXPECT_EQ(window.atelier_.status().history->steps.back().title, "Bring back");
  EXPECT_NE(hashOf(window), ball);
  window.atelier_.setTool(ActionKind::add);
  EXPECT_FALSE(window.atelier_.sculpt.recall.has_value());
}

// What a desk has told when nothing is on its way any more.
Publication whenCalm(ClayDesk& desk) {
  Publication all = desk.take();
  while (desk.isWaiting()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    desk.lookAfter();
    all.add(desk.take());
  }
  desk.lookAfter();
  all.add(desk.take());
  return all;
}

TEST_F(InFolder, aStrokeIsGivenUpWhileTheClayFollowsIt) {
  ClayDesk desk;
  desk.startNew(NewClay::ball, scene_);
  const std::uint64_t before = fieldHash(desk.sculptor().field());
  const std::size_t steps = whenCalm(desk).status->history->steps.size();
  Stroke stroke;
  stroke.points = {{{0, 0, 48}, 1}, {{4000, 0, 48}, 1}};
  int dabs = 0;
  desk.givesUp = [&] { return dabs >= 5; };
  const HandOperations hand;
  desk.beginStroke(hand, stroke);
  while (desk.dab()) ++dabs;
  desk.endStroke();
  EXPECT_EQ(dabs, 5);
  EXPECT_EQ(fieldHash(desk.sculptor().field()), before);
  EXPECT_EQ(whenCalm(desk).status->history->steps.size(), steps);
}

TEST_F(InFolder, afterAFailedSyncItNeverSaysSaved) {
  testing::FaultyFileSystem files(FileSystem::real());
  ClayDesk desk(files);
  desk.startNew(NewClay::ball, scene_);
  whenCalm(desk);
  for (std::size_t failing = 1; failing < 6; ++failing) {
    desk.apply(FillOperation{});
    whenCalm(desk);
    testing::Fault fault;
    fault.first = failing;
    fault.forever = true;
    files.start(fault);
    desk.save(scene_, {});
    const Publication told = whenCalm(desk);
    files.start();
    ASSERT_TRUE(told.saved.has_value());
    EXPECT_FALSE(told.saved->succeeded);
    EXPECT_FALSE(told.errors.empty());
    ASSERT_TRUE(told.status.has_value());
    EXPECT_TRUE(told.status->keeping.modified) << failing;
  }
  desk.save(scene_, {});
  const Publication told = whenCalm(desk);
  EXPECT_TRUE(told.saved->succeeded);
  EXPECT_FALSE(told.status->keeping.modified);
}

TEST_F(InFolder, workGoesOnWhileItIsSaved) {
  ClayDesk desk;
  desk.startNew(NewClay::ball, scene_);
  const std::uint64_t saved = fieldHash(desk.sculptor().field());
  desk.save(scene_, {});
  FillOperation fill;
  fill.primitive.centre = {60, 0, 0};
  desk.apply(fill);
  const Publication told = whenCalm(desk);
  EXPECT_TRUE(told.saved->succeeded);
  EXPECT_TRUE(told.status->keeping.modified) << "the step came after";
  EXPECT_EQ(fieldHash(loadScene(scene_).field), saved);
  EXPECT_EQ(fieldHash(Session::look(scene_).sculptor().field()),
            fieldHash(desk.sculptor().field()));
}

}  // namespace
}  // namespace bozzetto::ui
