// What files do that come from outside, and what is found again where nothing was saved.
#include <atomic>
#include <thread>

#include "bozzetto/base/file.hpp"
#include "bozzetto/render/png.hpp"
#include "bozzetto/sculptor/replay.hpp"
#include "ui/kept_look.hpp"
#include "ui/null_window.hpp"

namespace bozzetto::ui {
namespace {

namespace fs = std::filesystem;

class Files : public Null {
 protected:
  Files() { ::setenv("XDG_DATA_HOME", folder_.path().c_str(), 1); }
  void drop(std::initializer_list<const char*> names) {
    FilesDropped files;
    for (const char* name : names) files.paths.push_back((folder_ / name).string());
    post(files);
    settle();
  }
  bool said(const std::string& part) {
    for (const Message& message : atelier_.messages())
      if (message.text.find(part) != std::string::npos) return true;
    return false;
  }

  const testing::Folder folder_;
};

TEST_F(Files, whatCannotBeOpenedAsksNothing) {
  drag(middle(), middle() + glm::dvec2(60, 20));
  ASSERT_TRUE(atelier_.isModified());
  const std::uint64_t before = hash();
  writeFile(folder_ / "notes.txt", Bytes(12));
  drop({"notes.txt"});
  EXPECT_EQ(atelier_.dialog, Dialog::none);
  EXPECT_TRUE(said("notes.txt"));
  EXPECT_EQ(hash(), before);
}

TEST_F(Files, allPicturesBecomeReferencesAndTheFirstDocumentIsOpened) {
  for (const char* name : {"front ö.png", "side.png"}) writePng(folder_ / name, Image(8, 4));
  for (const char* name : {"a.bzt", "b.bzt"}) {
    atelier_.saveScene(folder_ / name);
    settle();
  }
  atelier_.run(Command::newBall);
  settle();
  drop({"front ö.png", "b.bzt", "side.png", "a.bzt"});
  EXPECT_EQ(atelier_.path(), folder_ / "b.bzt");
  EXPECT_TRUE(said("b.bzt"));
  atelier_.run(Command::newBall);
  settle();
  atelier_.options.references.clear();
  drop({"front ö.png", "side.png"});
  EXPECT_EQ(atelier_.options.references.size(), 2u);
}

// Whether the shelf is open or not, and whatever is on it: the scene stays.
TEST_F(Files, aDroppedToolIsTaken) {
  saveTool(folder_ / "leaf.bzt", makeStarter("leaf"));
  drag(middle(), middle() + glm::dvec2(60, 20));
  const std::uint64_t before = hash();
  for (const char* name : {"leaf 2", "leaf 3"}) {
    drop({"leaf.bzt"});
    EXPECT_EQ(atelier_.dialog, Dialog::none);
    EXPECT_EQ(hash(), before);
    ASSERT_TRUE(atelier_.sculpt.isFreeform());
    EXPECT_EQ(atelier_.sculpt.freeform->name, name) << "there is a starter of its name";
    EXPECT_TRUE(said("in hand"));
  }
  EXPECT_TRUE(atelier_.path().empty());
  EXPECT_TRUE(atelier_.isModified());
}

TEST_F(Files, onAnOpenShelfAllBecomeTools) {
  for (const char* name : {"a.bzt", "b c.bzt"}) {
    atelier_.saveScene(folder_ / name);
    settle();
  }
  tap(letter('Q'));
  settle();
  drop({"a.bzt", "b c.bzt"});
  std::size_t kept = 0;
  for (const ShelfCard& card : atelier_.shelf.cards)
    kept += card.entry.place == ToolEntry::Place::document;
  EXPECT_EQ(kept, 2u);
  EXPECT_EQ(atelier_.path(), folder_ / "b c.bzt");
}

TEST_F(Files, aMatcapIsKeptByItsPath) {
  writePng(folder_ / "ball.png", Image(16, 16));
  atelier_.loadMatcap(folder_ / "ball.png");
  const std::string text = lookText(atelier_.options);
  ViewOptions found;
  takeLook(text, found);
  EXPECT_EQ(found.look.mode, Mode::matcap);
  ASSERT_TRUE(found.look.matcapImage);
  EXPECT_EQ(found.look.matcapImage->width, 16);
  takeLook(lookText(found), found);
  EXPECT_TRUE(found.look.matcapImage);
  fs::remove(folder_ / "ball.png");
  takeLook(text, found);
  EXPECT_FALSE(found.look.matcapImage) << "the painted one then";
  takeLook(lookText({}), found);
  EXPECT_TRUE(found.matcapFrom.empty());
}

TEST_F(Files, aLostReferenceKeepsItsPlace) {
  writePng(folder_ / "front.png", Image(8, 4));
  drop({"front.png"});
  ASSERT_EQ(atelier_.options.references.size(), 1u);
  const glm::dvec3 at = atelier_.options.references[0].picture.centre;
  EXPECT_LT(glm::dot(at, atelier_.view.back()), -kRadius * .8) << "behind the ball";
  atelier_.saveScene(folder_ / "a.bzt");
  settle();
  fs::rename(folder_ / "front.png", folder_ / "elsewhere.png");
  atelier_.openScene(folder_ / "a.bzt");
  settle();
  EXPECT_TRUE(said("front.png"));
  ASSERT_EQ(atelier_.options.references.size(), 1u);
  frame();
  fs::create_directory(folder_ / "new");
  fs::rename(folder_ / "elsewhere.png", folder_ / "new/front.png");
  drop({"new/front.png"});
  ASSERT_EQ(atelier_.options.references.size(), 1u);
  EXPECT_TRUE(atelier_.options.references[0].picture.image);
  EXPECT_EQ(atelier_.options.references[0].picture.centre, at);
}

// The clay's thread waits while this lives.
class Gate {
 public:
  explicit Gate(ClayWorker& worker) {
    worker.post([open = open_](ClayDesk&) {
      while (!*open) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    });
  }
  ~Gate() { *open_ = true; }
  Gate(const Gate&) = delete;
  Gate& operator=(const Gate&) = delete;

 private:
  std::shared_ptr<std::atomic<bool>> open_ = std::make_shared<std::atomic<bool>>(false);
};

class Coming : public Files {
 protected:
  Coming() {
    atelier_.exportMesh(folder_ / "ball.stl", 1);
    atelier_.saveScene(folder_ / "base.bzt");
    settle();
  }
  void frames() {
    for (int n = 0; n < 5; ++n) frame();
  }
};

TEST_F(Coming, nothingMeantForThisDocumentMeetsTheOther) {
  const Bytes saved = readFile(folder_ / "base.bzt");
  {
    const Gate gate(atelier_.worker());
    atelier_.importMesh(folder_ / "ball.stl", 24);
    tapCtrl(letter('S'));
    tapCtrl(letter('Z'));
    moveTo(middle());
    post(ButtonChanged{Button::left, true});
    moveTo(middle() + glm::dvec2(50, 0));
    post(ButtonChanged{Button::left, false});
    tapCtrl(letter('N'));
    frames();
    EXPECT_TRUE(said("Importing"));
  }
  settle();
  EXPECT_EQ(readFile(folder_ / "base.bzt"), saved);
  EXPECT_TRUE(atelier_.path().empty());
  EXPECT_EQ(steps(), 1u) << "the import, and nothing else";
}

TEST_F(Coming, leavingMeanwhileAsksForWhatIsThere) {
  drag(middle(), middle() + glm::dvec2(60, 20));
  {
    const Gate gate(atelier_.worker());
    atelier_.importMesh(folder_ / "ball.stl", 24);
    frames();
    atelier_.askToClose();
    frames();
    EXPECT_FALSE(atelier_.wantsToClose());
  }
  settle();
  EXPECT_EQ(atelier_.dialog, Dialog::unsaved);
  EXPECT_EQ(atelier_.path(), folder_ / "base.bzt");
}

// A stroke that waits behind something else is work already.
TEST_F(Coming, strokesOnTheirWayAreAskedFor) {
  {
    const Gate gate(atelier_.worker());
    moveTo(middle());
    frames();
    post(ButtonChanged{Button::left, true});
    moveTo(middle() + glm::dvec2(50, 0));
    post(ButtonChanged{Button::left, false});
    frames();
    atelier_.askToClose();
    frames();
  }
  settle();
  EXPECT_FALSE(atelier_.wantsToClose());
  EXPECT_EQ(atelier_.dialog, Dialog::unsaved);
}

class Left : public ::testing::Test, protected StateFolder {
 protected:
  const testing::Folder folder_;
  const fs::path scene_ = folder_ / "faun.bzt";
};

TEST_F(Left, anUntouchedBallWithANameIsNotOffered) {
  { const NullWindow killed(scene_); }
  {
    NullWindow window(scene_);
    EXPECT_EQ(window.atelier_.dialog, Dialog::none);
    EXPECT_FALSE(window.atelier_.patches().empty());
    window.drag(window.middle(), window.middle() + glm::dvec2(60, 20));
  }
  NullWindow window(scene_);
  EXPECT_EQ(window.atelier_.dialog, Dialog::recovered) << "a stroke is work";
}

// The desk is asked for more all the time: it never comes to rest.
TEST_F(Left, aToolSurvivesAKillAmongStrokes) {
  {
    ClayDesk desk;
    desk.startNew(NewClay::ball, scene_);
    desk.apply(ShelfKeepOperation{"chisel"});
    desk.lookAfter();
  }
  const Session session = Session::look(scene_);
  ASSERT_EQ(session.sculptor().tools().shelf.size(), 1u);
  EXPECT_EQ(session.sculptor().tools().shelf[0].name, "chisel");
}

// What was done since a scene was opened is replayed on that scene, and on nothing else.
TEST_F(Files, aRecordingSaysWhichSceneItGoesOnFrom) {
  atelier_.saveScene(folder_ / "bust.bzt");
  settle();
  atelier_.openScene(folder_ / "bust.bzt");
  settle();
  const Clay opened = loadScene(folder_ / "bust.bzt").field;
  drag(middle(), middle() + glm::dvec2(60, 20));
  const std::uint64_t worked = hash();
  atelier_.saveRecording(folder_ / "work.jsonl");
  settle();
  const Recording recording = readRecording(folder_ / "work.jsonl");
  ASSERT_TRUE(recording.start);
  EXPECT_EQ(recording.start->scene, "bust.bzt");
  EXPECT_EQ(fieldHash(replay(recording, opened).field), worked);
  atelier_.run(Command::newEmpty);
  settle();
  atelier_.answerUnsaved(false);
  settle();
  atelier_.replay(folder_ / "work.jsonl");
  settle();
  EXPECT_TRUE(said("bust.bzt"));
  EXPECT_EQ(steps(), 0u);
}

}  // namespace
}  // namespace bozzetto::ui
