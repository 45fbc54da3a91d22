#include "bozzetto/sculptor/sculptor.hpp"

#include <gtest/gtest.h>

#include <map>

#include "bozzetto/sculptor/replay.hpp"

namespace bozzetto {
namespace {

Recording parse(const std::string& lines) {
  return parseRecording("{\"bozzetto\":\"recording\",\"version\":1}\n" + lines, "test");
}

// A little of everything.
const Recording& mixture() {
  static const Recording recording = parse(R"(
{"op":"scene","spacing":0.5}
{"op":"fill","shape":"ellipsoid","center":[0,0,0],"radii":[12,9,10],"colour":"#b08060"}
{"op":"tool","radii":[3,2,2.5],"rotation":[0.9,0.1,0.3,0.2]}
{"op":"action","name":"add","strength":0.4,"colour":"#3060c0"}
{"op":"stroke","points":[[10,2,1],[13,6,3,0.5],[15,9,-2]],"mirror":"x","pressure":["strength"]}
{"op":"action","name":"remove","strength":0.5}
{"op":"stroke","points":[[0,9,0],[4,8,4]],"radial":{"axis":"y","count":5}}
{"op":"action","name":"smooth","strength":1}
{"op":"stroke","points":[[10,2,1],[13,6,3]],"mirror":"xz"}
{"op":"action","name":"paint_soft","colour":"#f0e0d0"}
{"op":"stroke","points":[[-12,0,0],[0,0,10],[12,0,0]]}
{"op":"action","name":"erase"}
{"op":"tool","shape":"box","radii":[1,6,1]}
{"op":"stroke","points":[[0,0,0],[0,0,2]]}
{"op":"undo","count":2}
{"op":"redo"}
)");
  return recording;
}

template <int Side>
BasicSculptor<Side> played(const Recording& recording, SurfaceUpkeep upkeep = SurfaceUpkeep::none) {
  BasicSculptor<Side> sculptor({}, upkeep);
  for (const Operation& operation : recording.operations) sculptor.apply(operation);
  return sculptor;
}

TEST(Sculptor, sameFieldForAnyThreadsAndAnySide) {
  setThreadCount(1);
  const auto hash = fieldHash(played<8>(mixture()).field());
  for (const int threads : {2, 3, 7}) {
    setThreadCount(threads);
    EXPECT_EQ(fieldHash(played<8>(mixture()).field()), hash) << threads << " threads";
  }
  setThreadCount(0);
  EXPECT_EQ(fieldHash(played<1>(mixture()).field()), hash);
}

TEST(Sculptor, undoRestoresEveryStateBitForBit) {
  Sculptor sculptor;
  std::vector<std::uint64_t> states{fieldHash(sculptor.field())};
  for (const Operation& operation : mixture().operations) {
    if (std::holds_alternative<UndoOperation>(operation)) break;
    const std::size_t before = sculptor.history().undoDepth();
    sculptor.apply(operation);
    if (sculptor.history().undoDepth() > before) states.push_back(fieldHash(sculptor.field()));
  }
  ASSERT_EQ(states.size(), 7u);
  for (std::size_t n = states.size(); n-- > 1;) {
    EXPECT_EQ(fieldHash(sculptor.field()), states[n]);
    sculptor.apply(UndoOperation{1});
  }
  EXPECT_EQ(fieldHash(sculptor.field()), states[0]);
  sculptor.apply(RedoOperation{100});
  EXPECT_EQ(fieldHash(sculptor.field()), states.back());
  EXPECT_EQ(validate(sculptor.field()), std::nullopt);
}

TEST(Sculptor, theLedgerBalances) {
  Sculptor sculptor;
  double mass = 0;
  for (const Operation& operation : mixture().operations) {
    const OperationReport report = sculptor.apply(operation);
    EXPECT_DOUBLE_EQ(report.massBefore, mass);
    mass = report.massAfter;
    EXPECT_DOUBLE_EQ(mass, statistics(sculptor.field()).mass) << report.op;
  }
}

TEST(Sculptor, theSurfaceFollows) {
  Sculptor sculptor({}, SurfaceUpkeep::afterEachDab);
  for (const Operation& operation : mixture().operations) {
    sculptor.apply(operation);
    Surface<8> anew;
    anew.rebuild(sculptor.field());
    ASSERT_EQ(sculptor.surface().totals(), anew.totals()) << nameOf(operation);
  }
}

using Triangles = std::vector<std::uint16_t>;

std::map<Key, Triangles> shownBy(const Surface<8>& surface) {
  std::map<Key, Triangles> shown;
  for (const auto& [key, run] : surface.patches()) {
    const auto content = run.block->content();
    shown[key] = Triangles(content.indices.begin(), content.indices.end());
  }
  return shown;
}

TEST(Sculptor, changesAreAllThatAViewerNeeds) {
  Sculptor sculptor({}, SurfaceUpkeep::afterEachDab);
  EXPECT_TRUE(sculptor.takeChanges().all);
  std::map<Key, Triangles> seen;
  for (const Operation& operation : mixture().operations) {
    sculptor.apply(operation);
    const SurfaceChanges changes = sculptor.takeChanges();
    ASSERT_FALSE(changes.all);
    const auto shown = shownBy(sculptor.surface());
    for (const Key key : changes.patches) {
      seen.erase(key);
      if (const auto now = shown.find(key); now != shown.end()) seen.insert(*now);
    }
    EXPECT_EQ(seen, shown) << toText(operation);
    for (std::size_t n = 1; n < changes.blocks.size(); ++n) {
      const Key end = changes.blocks[n - 1].key + Key{0, 0, changes.blocks[n - 1].length};
      EXPECT_LE(end, changes.blocks[n].key);
    }
  }
  EXPECT_TRUE(sculptor.takeChanges().patches.empty());
}

TEST(Sculptor, strokesCountWhatThePaperCounts) {
  Sculptor sculptor({}, SurfaceUpkeep::afterEachDab);
  sculptor.apply(parseOperation(R"({"op":"tool","radii":[4,4,4]})", ""));
  const auto stroke = parseOperation(R"({"op":"stroke","points":[[0,0,0]]})", "");
  const OperationReport report = sculptor.apply(stroke);
  EXPECT_EQ(report.dabs, 1);
  EXPECT_EQ(report.visited, 9 * 9 * 9);
  EXPECT_EQ(report.computed, 9 * 9 * 9);
  EXPECT_GT(report.dirty, 200);
  EXPECT_LT(report.dirty, report.computed);
  EXPECT_GT(report.treated, report.dirty);  // every dirty corner has 8 cubes, shared
  EXPECT_LE(report.treated, 10 * 10 * 10);
}

TEST(Sculptor, aStrokeThatChangesNothingIsAStepAllTheSame) {
  Sculptor sculptor;
  sculptor.apply(parseOperation(R"({"op":"action","name":"remove"})", ""));
  sculptor.apply(parseOperation(R"({"op":"stroke","points":[[0,0,0]]})", ""));
  EXPECT_EQ(sculptor.history().undoDepth(), 1u);
  EXPECT_TRUE(sculptor.field().tree.empty());
}

TEST(Sculptor, scaleIsForEmptyDocumentsOnly) {
  Sculptor sculptor;
  sculptor.apply(SceneOperation{0.5, 0.4});
  EXPECT_EQ(sculptor.field().scale.spacing, 0.5);
  sculptor.apply(FillOperation{});
  EXPECT_NO_THROW(sculptor.apply(SceneOperation{0.5, std::nullopt}));
  EXPECT_THROW(sculptor.apply(SceneOperation{1.0, std::nullopt}), Error);
  sculptor.apply(UndoOperation{1});
  EXPECT_THROW(sculptor.apply(SceneOperation{1.0, std::nullopt}), Error);  // redo would lie
}

TEST(Sculptor, resampleIsOneStepAndUndoBringsTheGridBack) {
  Sculptor sculptor;
  sculptor.apply(FillOperation{{Shape::ellipsoid, {0, 0, 0}, {20, 15, 18}, {1, 0, 0, 0}, {}}});
  const auto hash = fieldHash(sculptor.field());
  const double mass = statistics(sculptor.field()).mass;
  sculptor.apply(ResampleOperation{0.5});
  EXPECT_EQ(sculptor.field().scale.spacing, 0.5);
  EXPECT_NEAR(statistics(sculptor.field()).mass, mass, 0.01 * mass);
  EXPECT_EQ(validate(sculptor.field()), std::nullopt);
  sculptor.apply(UndoOperation{1});
  EXPECT_EQ(sculptor.field().scale.spacing, 1.0);
  EXPECT_EQ(fieldHash(sculptor.field()), hash);
}

// Stops after so many reports.
class StopAfter : public Progress {
 public:
  explicit StopAfter(int reports) : left_(reports) {}
  bool report(std::string_view, double) override { return left_-- > 0; }

 private:
  int left_;
};

TEST(Sculptor, aCancelledStrokeLeavesNothing) {
  Sculptor sculptor(Clay{}, SurfaceUpkeep::afterEachDab);
  sculptor.apply(FillOperation{});
  const auto hash = fieldHash(sculptor.field());
  const auto totals = sculptor.surface().totals();
  StopAfter stop(5);
  const auto stroke = parseOperation(R"({"op":"stroke","points":[[0,8,0],[50,8,0]]})", "");
  EXPECT_THROW(sculptor.apply(stroke, stop), Cancelled);
  EXPECT_EQ(fieldHash(sculptor.field()), hash);
  EXPECT_EQ(sculptor.surface().totals(), totals);
  EXPECT_EQ(sculptor.history().undoDepth(), 1u);
}

// Keeps the notes.
class Listener : public Progress {
 public:
  void note(std::string_view text) override { notes.emplace_back(text); }
  std::vector<std::string> notes;
};

TEST(Sculptor, thinToolsAreWidenedAndThatIsSaid) {
  Sculptor sculptor;
  Listener listener;
  sculptor.apply(parseOperation(R"({"op":"tool","radii":[0.5,8,8]})", ""), listener);
  ASSERT_EQ(listener.notes.size(), 1u);
  EXPECT_THROW(sculptor.apply(parseOperation(R"({"op":"tool","radii":[0,8,8]})", "")), Error);
}

TEST(Sculptor, theFirstToolIsABallOfEightCells) {
  Sculptor sculptor;
  sculptor.apply(SceneOperation{0.01, std::nullopt});
  const auto stroke = parseOperation(R"({"op":"stroke","points":[[0,0,0]]})", "");
  EXPECT_EQ(sculptor.apply(stroke).visited, 17 * 17 * 17);
  EXPECT_THROW(sculptor.apply(parseOperation(R"({"op":"tool","radii":[8,8,8]})", "")), Error);
}

TEST(Replay, aFinerGridGivesTheSameShape) {
  ReplayOptions finer;
  finer.spacing = 0.25;
  const ReplayResult coarse = replay(mixture(), {}), fine = replay(mixture(), {}, finer);
  const double mass = statistics(coarse.field).mass;
  EXPECT_EQ(fine.field.scale.spacing, 0.25);
  EXPECT_NEAR(statistics(fine.field).mass, mass, 0.03 * mass);
}

TEST(Replay, faultsNameTheOperation) {
  const Recording recording = parse("{\"op\":\"fill\"}\n{\"op\":\"scene\",\"spacing\":2}\n");
  try {
    replay(recording, {});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).substr(0, 20), "test:3: operation 2:");
  }
}

TEST(Replay, asksForTheClayThatARecordingGoesOnFrom) {
  const Recording ball = parse("{\"op\":\"fill\",\"shape\":\"ellipsoid\"}");
  const Clay clay = replay(ball, {}).field;
  Recording further = parse(R"({"op":"stroke","points":[[8,0,0]]})");
  further.start = RecordingStart{"ball.bzt", fieldHash(clay)};
  Listener listener;
  EXPECT_NO_THROW(replay(further, clay, {}, listener));
  EXPECT_TRUE(listener.notes.empty());
  try {
    replay(further, {});
    FAIL() << "there is no clay";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("ball.bzt"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("--from"), std::string::npos);
  }
  replay(further, replay(further, clay).field, {}, listener);
  ASSERT_EQ(listener.notes.size(), 1u);
  EXPECT_NE(listener.notes[0].find("ball.bzt"), std::string::npos);
}

TEST(Replay, notesOnceWhatManyStrokesShare) {
  const std::string push = R"({"op":"stroke","points":[[8,0,0]],"pressure":["strength"]})";
  const Recording recording = parse(
      "{\"op\":\"fill\",\"shape\":\"ellipsoid\"}\n"
      "{\"op\":\"action\",\"name\":\"push\"}\n" +
      push + "\n" + push);
  Listener listener;
  replay(recording, {}, {}, listener);
  ASSERT_EQ(listener.notes.size(), 1u);
  EXPECT_NE(listener.notes[0].find("pressure"), std::string::npos);
}

TEST(Replay, notesThatAPushCarriedWhatNothingHolds) {
  const auto notesOf = [](const std::string& held) {
    Listener listener;
    replay(parse("{\"op\":\"fill\",\"shape\":\"ellipsoid\",\"radii\":[10,10,10]}\n" + held +
                 "{\"op\":\"tool\",\"radii\":[4,4,4]}\n{\"op\":\"action\",\"name\":\"push\"}\n" +
                 R"({"op":"stroke","points":[[16,0,0],[10,0,0]]})"),
           {}, {}, listener);
    return listener.notes;
  };
  const std::vector<std::string> free = notesOf("");
  ASSERT_EQ(free.size(), 1u);
  EXPECT_NE(free[0].find("nothing holds"), std::string::npos);
  EXPECT_TRUE(notesOf(R"({"op":"hold","box":{"min":[-12,-12,-12],"max":[-4,12,12]}})"
                      "\n")
                  .empty());
}

}  // namespace
}  // namespace bozzetto
