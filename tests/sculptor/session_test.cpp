#include "bozzetto/sculptor/session.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "bozzetto/history/copy.hpp"
#include "bozzetto/scene/scene_file.hpp"
#include "bozzetto/sculptor/clay_settings.hpp"
#include "sculptor/fill_at.hpp"
#include "support/folder.hpp"

namespace bozzetto {
namespace {

namespace fs = std::filesystem;

using testing::fillAt;

class Sessions : public ::testing::Test {
 protected:
  Sessions() { ::setenv("XDG_STATE_HOME", (folder_ / "state").c_str(), 1); }

  std::uint64_t hashOf(const Session& session) { return fieldHash(session.sculptor().field()); }

  testing::Folder folder_;
  const fs::path scene_ = folder_ / "faun.bzt";
};

TEST_F(Sessions, aDocumentIsSavedWithItsHistory) {
  {
    Session session = Session::create(scene_);
    EXPECT_TRUE(session.saved()) << "nothing happened yet";
    session.sculptor().apply(fillAt(0));
    EXPECT_FALSE(session.saved());
    session.save();
    EXPECT_TRUE(session.saved());
    session.parts.settings["theme"] = "dusk";
    EXPECT_FALSE(session.saved()) << "parts count";
    session.save();
    session.sculptor().apply(UndoOperation{});
    EXPECT_FALSE(session.saved());
    session.sculptor().apply(RedoOperation{});
    EXPECT_TRUE(session.saved());
  }
  Session session = Session::open(scene_);
  EXPECT_FALSE(session.findings().recovered);
  EXPECT_TRUE(session.saved());
  EXPECT_EQ(session.parts.settings.at("theme"), "dusk");
  EXPECT_FALSE(session.parts.settings.contains("history")) << "our own business";
  EXPECT_EQ(session.sculptor().history().undoDepth(), 1u);
  session.sculptor().apply(UndoOperation{});
  EXPECT_TRUE(session.sculptor().field().tree.empty());
}

TEST_F(Sessions, clayGoesOnAsItWas) {
  ClayOperation dry;
  dry.settings.stiffness = .125;
  dry.settings.layers = {clay::LayerKind::automaton};
  dry.settings.sharing = clay::SharingRule::literal;
  {
    Session session = Session::create(scene_);
    session.sculptor().apply(fillAt(0));
    session.save();
    EXPECT_TRUE(session.saved());
    session.sculptor().apply(dry);
    EXPECT_FALSE(session.saved());
    session.save();
  }
  {
    Session session = Session::open(scene_);
    EXPECT_EQ(toText(ClayOperation{session.sculptor().clay().settings}), toText(dry));
    EXPECT_TRUE(session.saved());
    session.sculptor().apply(ClayOperation{});
    session.save();
    EXPECT_FALSE(session.document().parts.settings.contains("clay"));
  }
  SceneParts damaged;
  damaged.settings["clay"] = R"({"op":"undo"})";
  EXPECT_THROW(settingsOf(damaged, "scene"), Error);
}

TEST_F(Sessions, whatWasNotSavedComesBack) {
  std::uint64_t hash = 0;
  {
    Session session = Session::create(scene_);
    session.sculptor().apply(fillAt(0));
    session.save();
    session.sculptor().apply(fillAt(40));
    hash = hashOf(session);
  }
  {
    const Session looked = Session::look(scene_);
    EXPECT_EQ(hashOf(looked), hash);
  }
  Session session = Session::open(scene_);
  EXPECT_TRUE(session.findings().recovered);
  EXPECT_EQ(session.findings().unsavedSteps, 1u);
  EXPECT_EQ(hashOf(session), hash);
  EXPECT_FALSE(session.saved());
}

TEST_F(Sessions, theSolidIsSavedAndRecoveredWithItsSteps) {
  SolidRef made, moved;
  {
    Session session = Session::create(scene_);
    SolidOperation solid;
    solid.block.edge = glm::dvec3(20);
    session.sculptor().apply(solid);
    made = session.sculptor().solid();
    session.save();
    EXPECT_TRUE(session.saved());
    session.sculptor().apply(SolidMoveOperation{Key{1, 1, 1}, {5, 6, 7}});
    EXPECT_FALSE(session.saved());
    moved = session.sculptor().solid();
  }
  {
    Session session = Session::open(scene_);
    EXPECT_TRUE(session.findings().recovered);
    ASSERT_NE(session.sculptor().solid(), nullptr);
    EXPECT_EQ(*session.sculptor().solid(), *moved);
    session.sculptor().apply(UndoOperation{1});
    EXPECT_EQ(*session.sculptor().solid(), *made);
    EXPECT_TRUE(session.saved());
    session.sculptor().apply(UndoOperation{1});
    EXPECT_EQ(session.sculptor().solid(), nullptr);
    session.sculptor().apply(GoToOperation{2});
    session.saveAs(folder_ / "satyr.bzt");
    session.sculptor().apply(UndoOperation{1});
    EXPECT_EQ(*session.sculptor().solid(), *made);
    session.sculptor().apply(RedoOperation{1});
  }
  Session session = Session::open(folder_ / "satyr.bzt");
  EXPECT_FALSE(session.findings().recovered);
  EXPECT_TRUE(session.saved());
  EXPECT_EQ(*session.sculptor().solid(), *moved);
  EXPECT_TRUE(session.parts.solid.empty()) << "our own business";
}

TEST_F(Sessions, aDamagedFileIsReplacedByItsHistory) {
  std::uint64_t hash = 0;
  {
    Session session = Session::create(scene_);
    session.sculptor().apply(fillAt(0));
    session.save();
    hash = hashOf(session);
  }
  std::ofstream(scene_) << "no scene at all";
  Session session = Session::open(scene_);
  EXPECT_EQ(hashOf(session), hash);
  EXPECT_FALSE(session.findings().notices.empty());
  session.save();
  EXPECT_FALSE(Session::look(scene_).findings().recovered);
}

TEST_F(Sessions, theHistoryComesAlongToAnotherName) {
  Session session = Session::create(scene_);
  session.sculptor().apply(fillAt(0));
  session.save();
  const fs::path other = folder_ / "satyr.bzt";
  session.saveAs(other);
  EXPECT_EQ(session.path(), other);
  EXPECT_TRUE(session.saved());
  session.sculptor().apply(fillAt(40));
  session.sculptor().apply(UndoOperation{2});
  EXPECT_TRUE(session.sculptor().field().tree.empty());
  session.sculptor().apply(RedoOperation{2});
  session.save();
  EXPECT_EQ(Session::look(scene_).sculptor().history().tree().size(), 1u) << "as it was left";
  EXPECT_EQ(Session::look(other).sculptor().history().tree().size(), 2u);
  EXPECT_FALSE(Session::look(scene_).findings().recovered);
}

TEST_F(Sessions, documentsWithoutANameLiveInTheStateFolder) {
  std::uint64_t hash = 0;
  {
    Session session = Session::create({});
    EXPECT_TRUE(session.path().empty());
    session.sculptor().apply(fillAt(0));
    hash = hashOf(session);
    EXPECT_THROW(session.save(), Error);
    session.sculptor().history().waitDurable();
    EXPECT_TRUE(Session::leftBehind().empty()) << "it is open";
  }
  const auto left = Session::leftBehind();
  ASSERT_EQ(left.size(), 1u);
  Session session = Session::open(left[0]);
  EXPECT_EQ(hashOf(session), hash);
  EXPECT_TRUE(session.path().empty());
  session.saveAs(scene_);
  EXPECT_EQ(session.path(), scene_);
  EXPECT_TRUE(Session::leftBehind().empty());
  EXPECT_EQ(Session::look(scene_).sculptor().history().undoDepth(), 1u);
}

TEST_F(Sessions, theSecondIsToldAndWritesNothing) {
  Session first = Session::create(scene_);
  first.sculptor().apply(fillAt(0));
  first.save();
  Session second = Session::open(scene_);
  EXPECT_TRUE(second.findings().readOnly);
  EXPECT_EQ(hashOf(second), hashOf(first));
  second.sculptor().apply(fillAt(40));
  EXPECT_THROW(second.save(), Error);
  second.saveAs(folder_ / "copy.bzt");
  EXPECT_EQ(fieldHash(loadScene(scene_).field), hashOf(first));
}

// By a program that keeps the identity and knows nothing of histories.
TEST_F(Sessions, aSceneSavedByOthersLaterIsTakenAsItIs) {
  Document document;
  {
    Session session = Session::create(scene_);
    session.sculptor().apply(fillAt(0));
    session.save();
    document = loadScene(scene_);
    session.sculptor().apply(fillAt(40));
  }
  document.parts.settings.clear();
  saveScene(scene_, document);
  fs::last_write_time(scene_, fs::last_write_time(scene_) + std::chrono::minutes(5));
  const std::uint64_t hash = fieldHash(document.field);
  EXPECT_EQ(hashOf(Session::look(scene_)), hash);
  EXPECT_EQ(hashOf(Session::open(scene_)), hash);
  EXPECT_TRUE(fs::exists(scene_.string() + ".history~"));
}

TEST_F(Sessions, picturesGoWithTheirSteps) {
  Session session = Session::create(scene_);
  session.sculptor().setPictureTaker([] { return Bytes(10, std::byte{1}); });
  session.sculptor().apply(fillAt(0));
  session.sculptor().history().waitDurable();
  EXPECT_EQ(session.sculptor().history().thumbnail(1), Bytes(10, std::byte{1}));
}

TEST_F(Sessions, theShelfIsTheSculptors) {
  {
    Session session = Session::create(scene_);
    session.sculptor().apply(fillAt(0));
    session.save();
    session.sculptor().apply(ShelfKeepOperation{"ball"});
    EXPECT_FALSE(session.saved());
    session.save();
    EXPECT_TRUE(session.saved());
  }
  Session session = Session::open(scene_);
  EXPECT_TRUE(session.saved());
  ToolOperation take;
  take.shape.shape = Shape::freeform;
  take.source.emplace().from = "shelf:ball";
  EXPECT_NO_THROW(session.sculptor().apply(take));
}

TEST_F(Sessions, aPictureMayComeLater) {
  const Bytes picture(10, std::byte{7});
  {
    Session session = Session::create(scene_);
    session.sculptor().apply(fillAt(0));
    session.sculptor().apply(fillAt(40));
    session.sculptor().history().setThumbnail(1, picture);
    session.sculptor().history().setThumbnail(9, picture);
    session.save();
  }
  Session session = Session::open(scene_);
  EXPECT_TRUE(session.findings().notices.empty());
  EXPECT_EQ(session.sculptor().history().thumbnail(1), picture);
  EXPECT_TRUE(session.sculptor().history().thumbnail(2).empty());
  EXPECT_TRUE(session.sculptor().history().thumbnail(9).empty()) << "no such step";
  session.saveAs(folder_ / "satyr.bzt");
  EXPECT_EQ(session.sculptor().history().thumbnail(1), picture);
}

TEST_F(Sessions, picturesAreForgottenWithTheirSteps) {
  SessionOptions options;
  options.limits.steps = 3;
  Session session = Session::create(scene_, options);
  for (int n = 0; n < 8; ++n) {
    session.sculptor().apply(fillAt(4 * n));
    session.sculptor().history().setThumbnail(StepNumber(n + 1), Bytes(10, std::byte{1}));
    session.save();
  }
  session.sculptor().history().waitDurable();
  int pictures = 0;
  for (const auto& entry : fs::directory_iterator(historyFolderOf(scene_)))
    pictures += entry.path().extension() == ".png";
  EXPECT_LE(pictures, 4);
  EXPECT_GE(pictures, 2);
}

TEST_F(Sessions, aGlanceTellsOfWhatWasLeftBehind) {
  {
    Session session = Session::create({});
    session.sculptor().apply(fillAt(0));
    session.sculptor().apply(fillAt(40));
    session.sculptor().history().setThumbnail(1, Bytes(10, std::byte{5}));
  }
  const auto left = Session::leftBehind();
  ASSERT_EQ(left.size(), 1u);
  const auto glance = glanceAt(historyFolderOf(left[0]));
  ASSERT_TRUE(glance.has_value());
  EXPECT_EQ(glance->steps, 2u);
  EXPECT_GT(glance->time, 1'700'000'000'000);
  EXPECT_EQ(glance->thumbnail, Bytes(10, std::byte{5}));
  Session::discardLeftBehind(left[0]);
  EXPECT_TRUE(Session::leftBehind().empty());
}

TEST_F(Sessions, discardingGoesBackToTheFile) {
  std::uint64_t hash = 0;
  {
    Session session = Session::create(scene_);
    session.sculptor().apply(fillAt(0));
    session.save();
    hash = hashOf(session);
    session.sculptor().apply(fillAt(40));
    Session::discard(std::move(session));
  }
  Session session = Session::open(scene_);
  EXPECT_FALSE(session.findings().recovered);
  EXPECT_EQ(hashOf(session), hash);
  EXPECT_EQ(session.sculptor().history().redoDepth(), 1u) << "and yet nothing is lost";
}

TEST_F(Sessions, discardingWithoutAFileLeavesNothing) {
  for (const fs::path& name : {fs::path(), scene_}) {
    Session session = Session::create(name);
    session.sculptor().apply(fillAt(0));
    Session::discard(std::move(session));
    EXPECT_TRUE(Session::leftBehind().empty());
    EXPECT_FALSE(fs::exists(historyFolderOf(scene_)));
  }
}

TEST_F(Sessions, withoutAPlaceItLivesInMemoryUntilItIsSaved) {
  Session session = Session::inMemory();
  EXPECT_TRUE(session.saved());
  session.sculptor().apply(fillAt(0));
  EXPECT_FALSE(session.saved());
  EXPECT_THROW(session.save(), Error);
  session.saveAs(scene_);
  EXPECT_TRUE(session.saved());
  session.sculptor().apply(fillAt(40));
  session.sculptor().history().waitDurable();
  EXPECT_EQ(hashOf(Session::look(scene_)), hashOf(session));
}

TEST_F(Sessions, anImportIsAStep) {
  std::ofstream(folder_ / "box.off") << "OFF\n8 6 0\n0 0 0\n9 0 0\n9 9 0\n0 9 0\n0 0 9\n"
                                        "9 0 9\n9 9 9\n0 9 9\n4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n"
                                        "4 2 3 7 6\n4 1 2 6 5\n4 0 4 7 3\n";
  Session session = Session::create(scene_);
  Sculptor& sculptor = session.sculptor();
  sculptor.tools().folder = folder_.path();
  const auto import = R"({"op":"import","from":"box.off","cells":18})";
  sculptor.apply(parseOperation(import, ""));
  EXPECT_DOUBLE_EQ(sculptor.field().scale.spacing, 0.5);
  EXPECT_NEAR(statistics(sculptor.field()).mass, 729, 10);
  EXPECT_THROW(sculptor.apply(parseOperation(import, "")), Error) << "clay is there";
  sculptor.apply(UndoOperation{});
  EXPECT_TRUE(sculptor.field().tree.empty());
  EXPECT_DOUBLE_EQ(sculptor.field().scale.spacing, 1);
  sculptor.apply(RedoOperation{});
  EXPECT_DOUBLE_EQ(sculptor.field().scale.spacing, 0.5);
}

TEST_F(Sessions, jumpsGoToAnyBranch) {
  Session session = Session::create(scene_);
  Sculptor& sculptor = session.sculptor();
  sculptor.apply(fillAt(0));
  const auto one = hashOf(session);
  sculptor.apply(fillAt(40));
  const auto two = hashOf(session);
  sculptor.apply(UndoOperation{});
  sculptor.apply(fillAt(80));
  sculptor.apply(GoToOperation{2});
  EXPECT_EQ(hashOf(session), two);
  const OperationReport report = sculptor.apply(GoToOperation{1});
  EXPECT_EQ(hashOf(session), one);
  EXPECT_DOUBLE_EQ(report.massAfter, statistics(sculptor.field()).mass);
  EXPECT_THROW(sculptor.apply(GoToOperation{9}), Error);
}

// A box at full strength brings back what it covers, and nothing else.
TEST_F(Sessions, recallBringsBackWhatTheToolCovers) {
  Session session = Session::create(scene_);
  Sculptor& sculptor = session.sculptor();
  sculptor.apply(fillAt(0));
  const Clay past = sculptor.field();
  FillOperation painted = fillAt(0);
  painted.primitive.radii = {12, 12, 12};
  painted.primitive.colour = {1, 2, 3};
  sculptor.apply(painted);
  const Clay before = sculptor.field();
  const auto tool = R"({"op":"tool","shape":"box","profile":"box","radii":[5,20,20]})";
  sculptor.apply(parseOperation(tool, ""));
  const auto recall = R"({"op":"action","name":"recall","strength":1,"step":1})";
  sculptor.apply(parseOperation(recall, ""));
  EXPECT_EQ(toText(parseOperation(recall, "")),
            toText(parseOperation(toText(parseOperation(recall, "")), "")));
  const auto stroke = R"({"op":"stroke","points":[[8,0,0]]})";
  const OperationReport report = sculptor.apply(parseOperation(stroke, ""));
  EXPECT_GT(report.dirty, 100);
  for (std::int32_t i = -14; i <= 14; ++i)
    for (std::int32_t j = -14; j <= 14; ++j) {
      if ((i > 2 && i < 6) || (i > 10 && i < 14)) continue;  // the soft rim of the tool
      const Key corner{i, j, 2};
      const bool covered = i >= 6 && i <= 10;
      const Clay& expected = covered ? past : before;
      ASSERT_EQ(sculptor.field().value(corner), expected.value(corner)) << i << " " << j;
      ASSERT_EQ(sculptor.field().attributes(corner), expected.attributes(corner));
    }
  EXPECT_EQ(validate(sculptor.field()), std::nullopt);
  EXPECT_DOUBLE_EQ(report.massAfter, statistics(sculptor.field()).mass);
  sculptor.apply(UndoOperation{});
  EXPECT_EQ(hashOf(session), fieldHash(before));
  EXPECT_THROW(sculptor.apply(parseOperation(R"({"op":"action","name":"recall","step":77})", "")),
               Error);
}

}  // namespace
}  // namespace bozzetto
