// The window without a window: events in, clay out.
#include <filesystem>

#include "bozzetto/base/file.hpp"
#include "bozzetto/render/png.hpp"
#include "ui/null_window.hpp"

namespace bozzetto::ui {
namespace {

namespace fs = std::filesystem;

TEST_F(Null, opensOnABallFramedInTheFreeViewport) {
  EXPECT_FALSE(atelier_.patches().empty());
  EXPECT_EQ(atelier_.dialog, Dialog::none);
  EXPECT_EQ(atelier_.sculpt.action, ActionKind::add);
  EXPECT_FALSE(atelier_.isModified());
  moveTo(middle());
  settle();
  EXPECT_TRUE(atelier_.hover().ground.has_value());
  const Layout& layout = interface_.layout();
  EXPECT_EQ(layout.viewport.low, glm::dvec2(60, 44));
  EXPECT_EQ(layout.viewport.high, glm::dvec2(1280 - 288, 800 - 28));
}

TEST_F(Null, aLeftDragOnTheClayAddsThere) {
  const double before = mass();
  drag(middle(), middle() + glm::dvec2(60, 20));
  EXPECT_GT(mass(), before);
  EXPECT_EQ(steps(), 2u);  // the ball, the stroke
  EXPECT_TRUE(atelier_.isModified());
  EXPECT_EQ(atelier_.status().last.op, "stroke");
  // On the side that was looked at.
  EXPECT_GT(atelier_.status().lastEdit.centre().z, 20);
}

TEST_F(Null, everyPointerSampleReachesTheStroke) {
  moveTo(middle());
  post(ButtonChanged{Button::left, true});
  constexpr int kSamples = 137;
  for (int n = 1; n <= kSamples; ++n) moveTo(middle() + glm::dvec2(0.5 * n, 0));
  post(ButtonChanged{Button::left, false});
  settle();
  std::size_t points = 0;
  atelier_.worker().post([&](ClayDesk& desk) {
    const auto* last = std::get_if<StrokeOperation>(&desk.recording().operations.back());
    points = last->stroke.points.size();
  });
  settle();
  EXPECT_EQ(points, kSamples + 1u);
}

TEST_F(Null, ctrlInvertsAndShiftSmooths) {
  post(KeyChanged{KeyCode::leftControl, true, false});
  settle();
  EXPECT_EQ(atelier_.actionNow(), ActionKind::remove);
  const double before = mass();
  drag(middle(), middle() + glm::dvec2(40, 0));
  EXPECT_LT(mass(), before);
  post(KeyChanged{KeyCode::leftControl, false, false});
  post(KeyChanged{KeyCode::leftShift, true, false});
  settle();
  EXPECT_EQ(atelier_.actionNow(), ActionKind::smooth);
  post(FocusChanged{false});
  settle();
  EXPECT_EQ(atelier_.actionNow(), ActionKind::add);
}

// Left and right button with keys held, as somebody expects who comes from there.
TEST_F(Null, likeZBrush) {
  atelier_.setProfile(KeyProfile::zbrush);
  const glm::dvec2 beside = interface_.layout().viewport.low + glm::dvec2(40, 200);
  const auto dragged = [&](KeyCode with, glm::dvec2 from, Button button) {
    const ViewState before = atelier_.view;
    if (with != KeyCode::none) post(KeyChanged{with, true, false});
    settle();
    drag(from, from + glm::dvec2(50, 30), button);
    if (with != KeyCode::none) post(KeyChanged{with, false, false});
    settle();
    return before;
  };
  const std::size_t done = steps();
  EXPECT_NE(dragged(KeyCode::none, beside, Button::left).worldFromView,
            atelier_.view.worldFromView);
  EXPECT_NE(dragged(KeyCode::none, middle(), Button::right).worldFromView,
            atelier_.view.worldFromView);
  ViewState before = dragged(KeyCode::leftAlt, middle(), Button::right);
  EXPECT_EQ(before.worldFromView, atelier_.view.worldFromView);
  EXPECT_NE(before.target, atelier_.view.target) << "pan";
  before = dragged(KeyCode::leftControl, middle(), Button::right);
  EXPECT_EQ(before.worldFromView, atelier_.view.worldFromView);
  EXPECT_NE(before.distance, atelier_.view.distance) << "zoom";
  EXPECT_EQ(steps(), done);
  const double mass = this->mass();
  dragged(KeyCode::leftControl, middle(), Button::left);
  EXPECT_EQ(steps(), done + 1);
  EXPECT_EQ(this->mass(), mass) << "held, not added";
  dragged(KeyCode::leftAlt, middle() + glm::dvec2(0, 60), Button::left);
  EXPECT_LT(this->mass(), mass);
}

TEST_F(Null, undoAndRedoByKeys) {
  const double before = mass();
  drag(middle(), middle() + glm::dvec2(60, 20));
  const double after = mass();
  tapCtrl(letter('Z'));
  settle();
  EXPECT_DOUBLE_EQ(mass(), before);
  tapCtrl(letter('Y'));
  settle();
  EXPECT_DOUBLE_EQ(mass(), after);
}

TEST_F(Null, escapeTakesAStrokeBack) {
  const double before = mass();
  moveTo(middle());
  post(ButtonChanged{Button::left, true});
  moveTo(middle() + glm::dvec2(50, 0));
  settle();
  tap(KeyCode::escape);
  settle();
  post(ButtonChanged{Button::left, false});
  settle();
  EXPECT_DOUBLE_EQ(mass(), before);
  EXPECT_EQ(steps(), 1u);
}

TEST_F(Null, clayCanBeMadeInEmptyAir) {
  const double before = mass();
  const Rect& at = interface_.layout().viewport;
  drag(at.low + glm::dvec2(30, 200), at.low + glm::dvec2(60, 240));
  EXPECT_GT(mass(), before);
}

TEST_F(Null, cameraAndHoverUploadNothing) {
  settle();
  uploaded_ = 0;
  const auto version = atelier_.status().version;
  for (int n = 0; n < 30; ++n) {
    moveTo(middle() + glm::dvec2(n, 2 * n));
    frame();
  }
  drag(middle(), middle() + glm::dvec2(90, 40), Button::middle);
  post(WheelTurned{{0, 2}});
  settle();
  EXPECT_EQ(uploaded_, 0u);
  EXPECT_EQ(atelier_.status().version, version);
}

TEST_F(Null, aDabUploadsItsSurroundingsOnly) {
  std::size_t all = 0;
  atelier_.patches().forEach([&](const ShownPatch& patch) { all += patch.uploadBytes(); });
  atelier_.sculpt.size = 4;
  uploaded_ = 0;
  drag(middle(), middle() + glm::dvec2(1, 0));
  EXPECT_GT(uploaded_, 0u);
  EXPECT_LT(uploaded_, all);
}

TEST_F(Null, keysOfTheToolRowAndOfSize) {
  tap(static_cast<KeyCode>('2'));
  settle();
  EXPECT_EQ(atelier_.sculpt.action, ActionKind::remove);
  const double size = atelier_.sculpt.size;
  tap(KeyCode::rightBracket);
  settle();
  EXPECT_GT(atelier_.sculpt.size, size);
  moveTo(middle());
  tap(letter('F'));
  moveTo(middle() + glm::dvec2(80, 0));
  settle();
  EXPECT_GT(atelier_.sculpt.size, 1.2 * size);
  tap(KeyCode::escape);
  settle();
  EXPECT_NEAR(atelier_.sculpt.size, size / 0.9, 1e-9);
}

TEST_F(Null, mirroredStrokesAreSymmetric) {
  tap(letter('X'));
  settle();
  ASSERT_TRUE(atelier_.sculpt.symmetry.mirror[0]);
  drag(middle() + glm::dvec2(60, 0), middle() + glm::dvec2(90, 30));
  const CellBounds edit = atelier_.status().lastEdit;
  EXPECT_NEAR(edit.low.x, -edit.high.x, 8.1);
}

TEST_F(Null, savesOpensAndAsksBeforeItForgets) {
  const testing::Folder folder;
  const fs::path path = folder / "a.bzt";
  drag(middle(), middle() + glm::dvec2(60, 20));
  atelier_.saveScene(path);
  settle();
  ASSERT_TRUE(fs::exists(path));
  EXPECT_FALSE(atelier_.isModified());
  EXPECT_EQ(atelier_.path(), path);
  const double kept = mass();
  drag(middle(), middle() + glm::dvec2(-60, 20));
  post(CloseAsked{});
  settle();
  EXPECT_EQ(atelier_.dialog, Dialog::unsaved);
  EXPECT_FALSE(atelier_.wantsToClose());
  tap(KeyCode::escape);
  settle();
  EXPECT_EQ(atelier_.dialog, Dialog::none);
  post(CloseAsked{});
  settle();
  atelier_.answerUnsaved(false);
  settle();
  EXPECT_TRUE(atelier_.wantsToClose());
  atelier_.openScene(path);
  settle();
  EXPECT_EQ(atelier_.dialog, Dialog::none) << "it was discarded";
  atelier_.worker().post([](ClayDesk& desk) { desk.apply(SceneOperation{}); });
  settle();
  EXPECT_NEAR(mass(), kept, 1e-6 * kept);
}

TEST_F(Null, numberedCopiesLieBesideTheScene) {
  const testing::Folder folder;
  atelier_.run(Command::saveNumbered);
  EXPECT_EQ(atelier_.dialog, Dialog::saveAs) << "no name yet";
  atelier_.saveScene(folder / "a.bzt");
  settle();
  for (const char* name : {"a.001.bzt", "a.002.bzt"}) {
    atelier_.run(Command::saveNumbered);
    settle();
    EXPECT_TRUE(fs::exists(folder / name)) << name;
  }
  EXPECT_EQ(atelier_.path(), folder / "a.bzt");
}

TEST_F(Null, whatWasDoneByHandCanBeReplayed) {
  const testing::Folder folder;
  const fs::path path = folder / "a.jsonl";
  drag(middle(), middle() + glm::dvec2(60, 20));
  tap(static_cast<KeyCode>('2'));
  drag(middle(), middle() + glm::dvec2(-30, 50));
  const std::uint64_t hash = this->hash();
  atelier_.saveRecording(path);
  settle();
  EXPECT_EQ(replayed(path), hash);
}

TEST_F(Null, thePuckHoldsTheToolWhileTheMouseTurnsTheScene) {
  atelier_.run(Command::moveTool);
  moveTo(middle());
  settle();
  const glm::dquat looked = atelier_.view.worldFromView;
  post(PuckMoved{{1, 0, 0}, {0, 0.5, 0}, 0.05});
  settle();
  ASSERT_TRUE(atelier_.heldTool().has_value());
  EXPECT_EQ(atelier_.view.worldFromView, looked);
  const glm::dvec3 held = atelier_.heldTool()->position;
  drag(middle(), middle() + glm::dvec2(80, 0), Button::middle);
  EXPECT_NE(atelier_.view.worldFromView, looked);
  EXPECT_EQ(atelier_.heldTool()->position, held);
  const std::size_t before = steps();
  post(PuckButton{0, true});
  for (int n = 0; n < 5; ++n) post(PuckMoved{{0, 0.5, 0}, {0, 0, 0}, 0.05});
  post(PuckButton{0, false});
  settle();
  EXPECT_EQ(steps(), before + 1);
  EXPECT_GT(atelier_.heldTool()->position.y, held.y);
}

TEST_F(Null, thePuckTurnsTheScene) {
  const ViewState before = atelier_.view;
  post(PuckMoved{{0, 0, 1}, {0, 1, 0}, 0.05});
  settle();
  EXPECT_LT(atelier_.view.distance, before.distance);
  EXPECT_NE(atelier_.view.worldFromView, before.worldFromView);
  atelier_.run(Command::undoView);
  EXPECT_EQ(atelier_.view, before);
}

TEST_F(Null, aPenPressesIntoTheStroke) {
  atelier_.sculpt.curve = {1, 0};
  post(PointerMoved{middle(), 0.25});
  post(ButtonChanged{Button::left, true});
  post(PointerMoved{middle() + glm::dvec2(30, 0), 0.75});
  post(ButtonChanged{Button::left, false});
  settle();
  std::vector<StrokePoint> points;
  atelier_.worker().post([&](ClayDesk& desk) {
    points = std::get<StrokeOperation>(desk.recording().operations.back()).stroke.points;
  });
  settle();
  ASSERT_EQ(points.size(), 2u);
  EXPECT_DOUBLE_EQ(points[0].pressure, 0.25);
  EXPECT_DOUBLE_EQ(points[1].pressure, 0.75);
}

TEST_F(Null, everyCommandCanBeRun) {
  for (const CommandRow& row : commandTable()) {
    if (row.command == Command::quit) continue;
    if (atelier_.isPossible(row.command)) atelier_.run(row.command);
    settle();
    tap(KeyCode::escape);
    settle();
    atelier_.dialog = Dialog::none;
    atelier_.paletteOpen = false;
    atelier_.fullScreen = false;
    atelier_.panelsShown = true;
  }
}

TEST_F(Null, panelsComeBackWithAKey) {
  for (const Command command : {Command::panels, Command::fullScreen}) {
    for (int n = 0; n < 4; ++n) {
      const bool before = interface_.layout().panels;
      for (const Chord& chord : chordsOf(rowOf(command).blender)) tap(chord.key);
      settle();
      EXPECT_NE(interface_.layout().panels, before);
    }
  }
}

TEST_F(Null, windowsOfAnySizeAreDrawn) {
  atelier_.run(Command::shelf);
  atelier_.run(Command::history);
  for (const glm::dvec2 size :
       {glm::dvec2{0, 0}, {1, 1}, {60, 40}, {320, 73}, {73, 900}, {8000, 90}}) {
    size_ = size;
    settle();
  }
}

TEST_F(Null, ctrlClickTypesANumberIntoASlider) {
  const Rect at = interface_.layout().properties;
  for (double y = at.low.y + 100; y < at.high.y - 40 && atelier_.sculpt.size != 17.5; y += 12) {
    post(KeyChanged{KeyCode::leftControl, true, false});
    click({at.centre().x, y});
    post(KeyChanged{KeyCode::leftControl, false, false});
    type("17.5");
    tap(KeyCode::enter);
    settle();
  }
  EXPECT_DOUBLE_EQ(atelier_.sculpt.size, 17.5);
}

TEST_F(Null, theFileDialogWorksByKeyboard) {
  const testing::Folder folder;
  atelier_.settings.folder = folder.path().string();
  tapCtrl(letter('S'));
  settle();
  ASSERT_EQ(atelier_.dialog, Dialog::saveAs);
  settle();
  tapCtrl(letter('A'));
  for (const char c : std::string("by keys")) post(TextTyped{unsigned(c)});
  settle();
  tap(KeyCode::enter);
  settle();
  EXPECT_TRUE(fs::exists(folder / "by keys.bzt"));
  EXPECT_EQ(atelier_.dialog, Dialog::none);
}

TEST_F(Null, enterTwiceReplacesAFile) {
  const testing::Folder folder;
  writeFile(folder / "there.jsonl", Bytes(3));
  atelier_.settings.folder = folder.path().string();
  drag(middle(), middle() + glm::dvec2(60, 20));
  tapCtrl(letter('R'));
  settle();
  type("elsewhere");
  post(KeyChanged{KeyCode::leftControl, true, false});
  settle();
  post(KeyChanged{letter('A'), true, false});
  post(KeyChanged{KeyCode::leftControl, false, false});  // before the next frame
  post(KeyChanged{letter('A'), false, false});
  settle();
  type("there");
  tap(KeyCode::enter);
  settle();
  EXPECT_EQ(atelier_.dialog, Dialog::record) << "asks";
  EXPECT_EQ(fs::file_size(folder / "there.jsonl"), 3u);
  tap(KeyCode::enter);
  settle();
  EXPECT_EQ(atelier_.dialog, Dialog::none);
  EXPECT_GT(fs::file_size(folder / "there.jsonl"), 3u);
}

TEST_F(Null, enterSavesWhatIsUnsaved) {
  const testing::Folder folder;
  atelier_.saveScene(folder / "a.bzt");
  settle();
  drag(middle(), middle() + glm::dvec2(60, 20));
  post(CloseAsked{});
  settle();
  ASSERT_EQ(atelier_.dialog, Dialog::unsaved);
  tap(KeyCode::enter);
  settle();
  EXPECT_EQ(atelier_.dialog, Dialog::none);
  EXPECT_FALSE(atelier_.isModified());
  EXPECT_TRUE(atelier_.wantsToClose());
}

TEST_F(Null, menusAreGoneThroughByKeys) {
  const auto isOpen = [] {
    return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  };
  const glm::dvec2 fileMenu{154, 22};
  click(fileMenu);
  ASSERT_TRUE(isOpen());
  tap(KeyCode::escape);
  settle();
  EXPECT_FALSE(isOpen());
  click(fileMenu);
  tap(KeyCode::down);
  tap(KeyCode::enter);  // a new block
  settle();
  EXPECT_FALSE(isOpen());
  const glm::dvec3 size = atelier_.patches().bounds().high - atelier_.patches().bounds().low;
  EXPECT_GT(atelier_.status().mass, 0.9 * size.x * size.y * size.z) << "it fills its box";
}

TEST_F(Null, referencesAreMovedAndKept) {
  const testing::Folder folder;
  writePng(folder / "ref.png", Image(8, 4));
  atelier_.addReference(folder / "ref.png");
  settle();
  ASSERT_EQ(atelier_.overlays().pictures.size(), 1u);
  const auto place = [&] {
    const glm::dvec3 at = atelier_.options.references.at(0).picture.centre;
    return pixelOf(atelier_.view, atelier_.extent(), at);
  };
  const glm::dvec2 from = place();
  const std::size_t done = steps();
  atelier_.movingReference = 0;
  drag(middle(), middle() + glm::dvec2(120, -40));
  EXPECT_LT(glm::distance(place(), from + glm::dvec2(120, -40)), 0.5);
  EXPECT_EQ(steps(), done) << "no stroke";
  const double high = glm::length(atelier_.options.references[0].picture.up);
  atelier_.wheel(2, Modifiers{.shift = true});
  EXPECT_NEAR(glm::length(atelier_.options.references[0].picture.up), high * 1.21, 1e-9 * high);
  tap(KeyCode::escape);
  settle();
  EXPECT_FALSE(atelier_.movingReference);
  const ReferencePicture moved = atelier_.options.references[0].picture;
  atelier_.saveScene(folder / "a.bzt");
  settle();
  atelier_.options.references.clear();
  atelier_.openScene(folder / "a.bzt");
  settle();
  ASSERT_EQ(atelier_.options.references.size(), 1u);
  EXPECT_EQ(atelier_.options.references[0].picture.centre, moved.centre);
  EXPECT_EQ(atelier_.options.references[0].picture.image->width, 8);
}

TEST_F(Null, wiresOfToolsCanBeToldApart) {
  moveTo(middle());
  settle();
  const auto triangles = [&] { return atelier_.overlays().tools.at(0).mesh->indices.size() / 3; };
  atelier_.options.tool = ToolDisplay::solid;
  EXPECT_GT(triangles(), 2000u);
  atelier_.options.tool = ToolDisplay::wire;
  EXPECT_LT(triangles(), 200u);
}

TEST_F(Null, aMessageComesAndGoes) {
  atelier_.openScene("/no/such/folder/thing");
  settle();
  atelier_.say(Message::Kind::error, "something");
  EXPECT_FALSE(atelier_.messages().empty());
  now_ += 20;
  frame();
  EXPECT_TRUE(atelier_.messages().empty());
}

}  // namespace
}  // namespace bozzetto::ui
