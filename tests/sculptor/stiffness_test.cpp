// Painted stiffness as operations: steps of history, part of the document, the same on any grid.
#include <gtest/gtest.h>

#include <cstdlib>

#include "bozzetto/sculptor/recording.hpp"
#include "bozzetto/sculptor/replay.hpp"
#include "bozzetto/sculptor/session.hpp"
#include "support/folder.hpp"

namespace bozzetto {
namespace {

constexpr const char* kBall = R"({"op":"fill","shape":"ellipsoid","radii":[9,9,9]})";
constexpr const char* kTool = R"({"op":"tool","profile":"box","radii":[4,4,4]})";
constexpr const char* kDab = R"({"op":"stroke","points":[[8,0,0]]})";

Operation operation(std::string_view line) { return parseOperation(std::string(line), "test"); }

template <class Sculptor>
void begin(Sculptor& sculptor) {
  for (const char* line : {kBall, kTool}) sculptor.apply(operation(line));
}

template <class Sculptor>
void paint(Sculptor& sculptor, const char* action, double strength) {
  Operation chosen = operation(std::string(R"({"op":"action","name":")") + action + "\"}");
  std::get<ActionOperation>(chosen).action.strength = strength;
  sculptor.apply(chosen);
  sculptor.apply(operation(kDab));
}

double at(const clay::Setup& setup, Key corner) { return setup.stiffness.at(corner); }

TEST(PaintedStiffness, IsAStepOfHistoryThatLeavesTheClay) {
  Sculptor sculptor;
  begin(sculptor);
  const std::uint64_t clay = fieldHash(sculptor.field());
  paint(sculptor, "stiffen", 1);
  EXPECT_EQ(at(sculptor.clay(), {7, 0, 0}), 1);
  EXPECT_EQ(at(sculptor.clay(), {11, 0, 0}), 0) << "no clay there";
  EXPECT_EQ(at(sculptor.clay(), {0, 0, 0}), 0);
  EXPECT_EQ(fieldHash(sculptor.field()), clay);
  paint(sculptor, "soften", 0.5);
  EXPECT_NEAR(at(sculptor.clay(), {7, 0, 0}), 0.5, 0.01);
  EXPECT_EQ(sculptor.history().undoDepth(), 3u);
  sculptor.apply(UndoOperation{});
  EXPECT_EQ(at(sculptor.clay(), {7, 0, 0}), 1);
  sculptor.apply(UndoOperation{});
  EXPECT_FALSE(sculptor.clay().stiffness.any());
  sculptor.apply(RedoOperation{2});
  EXPECT_NEAR(at(sculptor.clay(), {7, 0, 0}), 0.5, 0.01);
  sculptor.apply(operation(R"({"op":"release","hold":false,"supports":false})"));
  EXPECT_FALSE(sculptor.clay().stiffness.any());
  sculptor.apply(UndoOperation{});
  EXPECT_NEAR(at(sculptor.clay(), {7, 0, 0}), 0.5, 0.01) << "as of before the release";
  sculptor.apply(operation(R"({"op":"release","stiffness":false})"));
  EXPECT_TRUE(sculptor.clay().stiffness.any());
}

TEST(PaintedStiffness, AStrokeThatIsTakenBackLeavesNoPaint) {
  Sculptor sculptor({}, SurfaceUpkeep::afterEachDab);
  begin(sculptor);
  sculptor.apply(operation(R"({"op":"action","name":"soften","strength":1})"));
  {
    Stroke stroke;
    stroke.points = {{{8, 0, 0}, 1}, {{0, 8, 0}, 1}};
    const auto live = sculptor.begin(stroke);
    while (live->dab()) {
    }
    EXPECT_EQ(at(sculptor.clay(), {7, 0, 0}), -1) << "seen while it is drawn";
  }
  EXPECT_FALSE(sculptor.clay().stiffness.any());
}

TEST(PaintedStiffness, IsTheSameWithBlocksOfOne) {
  BasicSculptor<1> one;
  Sculptor eight;
  begin(one);
  begin(eight);
  for (const char* action : {"stiffen", "soften", "stiffen"}) {
    paint(one, action, 0.3);
    paint(eight, action, 0.3);
  }
  EXPECT_TRUE(one.clay().stiffness.any());
  EXPECT_EQ(one.clay().stiffness, eight.clay().stiffness);
  for (auto line :
       {R"({"op":"action","name":"push"})", R"({"op":"stroke","points":[[14,0,0],[9,0,0]]})"}) {
    one.apply(operation(line));
    eight.apply(operation(line));
  }
  EXPECT_EQ(one.clay().stiffness, eight.clay().stiffness);
  EXPECT_EQ(fieldHash(one.field()), fieldHash(eight.field()));
}

TEST(PaintedStiffness, GoesToOtherGrids) {
  Sculptor sculptor;
  begin(sculptor);
  paint(sculptor, "soften", 1);
  sculptor.apply(operation(R"({"op":"resample","spacing":0.5})"));
  EXPECT_EQ(at(sculptor.clay(), {14, 0, 0}), -1);
  EXPECT_EQ(at(sculptor.clay(), {0, 0, 0}), 0);
  sculptor.apply(UndoOperation{});
  EXPECT_EQ(at(sculptor.clay(), {7, 0, 0}), -1);
  Recording recording;
  recording.operations = {operation(kDab)};
  ReplayOptions options;
  options.spacing = 2;
  options.stiffness = sculptor.clay().stiffness;
  const ReplayResult coarse = replay(recording, sculptor.field(), options);
  EXPECT_NEAR(coarse.stiffness.at({3, 0, 0}), -1, 0.1);
}

class KeptStiffness : public ::testing::Test {
 protected:
  KeptStiffness() { ::setenv("XDG_STATE_HOME", (folder_ / "state").c_str(), 1); }

  const testing::Folder folder_;
  const std::filesystem::path path_ = folder_ / "soft.bzt";
};

// Also the first stroke on clay that has no steps, and strokes of before a crash.
TEST_F(KeptStiffness, IsUndoneWheneverItWasPainted) {
  {
    Session session = Session::create(path_);
    begin(session.sculptor());
    session.save();
  }
  std::filesystem::remove_all(historyFolderOf(path_));
  {
    Session session = Session::open(path_);
    ASSERT_EQ(session.sculptor().history().undoDepth(), 0u);
    session.sculptor().apply(operation(kTool));
    paint(session.sculptor(), "soften", 1);
    EXPECT_TRUE(session.sculptor().clay().stiffness.any());
    session.sculptor().apply(UndoOperation{});
    EXPECT_FALSE(session.sculptor().clay().stiffness.any());
    EXPECT_TRUE(session.saved());
    session.sculptor().apply(RedoOperation{});
  }
  Session crashed = Session::open(path_);
  EXPECT_EQ(at(crashed.sculptor().clay(), {7, 0, 0}), -1);
  crashed.sculptor().apply(operation(kTool));
  paint(crashed.sculptor(), "stiffen", 0.5);
  EXPECT_GT(at(crashed.sculptor().clay(), {7, 0, 0}), -1);
  crashed.sculptor().apply(UndoOperation{});
  EXPECT_EQ(at(crashed.sculptor().clay(), {7, 0, 0}), -1);
  crashed.sculptor().apply(UndoOperation{});
  EXPECT_FALSE(crashed.sculptor().clay().stiffness.any());
  EXPECT_TRUE(crashed.saved());
}

TEST_F(KeptStiffness, BelongsToTheDocument) {
  {
    Session session = Session::create(path_);
    begin(session.sculptor());
    session.save();
    paint(session.sculptor(), "soften", 1);
    EXPECT_FALSE(session.saved());
  }
  Session crashed = Session::open(path_);
  EXPECT_EQ(at(crashed.sculptor().clay(), {7, 0, 0}), -1) << "kept between saves";
  crashed.save();
  EXPECT_TRUE(crashed.saved());
  EXPECT_EQ(loadScene(path_).parts.stiffness.at({7, 0, 0}), -1);
}

}  // namespace
}  // namespace bozzetto
