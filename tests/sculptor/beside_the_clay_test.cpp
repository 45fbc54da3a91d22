// Supports and the mass ledger go with the steps of history, on the disk too.
#include <gtest/gtest.h>

#include <cstdlib>

#include "bozzetto/scene/scene_file.hpp"
#include "bozzetto/sculptor/session.hpp"
#include "sculptor/fill_at.hpp"
#include "support/folder.hpp"

namespace bozzetto {
namespace {

using testing::fillAt;

class BesideTheClay : public ::testing::Test {
 protected:
  BesideTheClay() { ::setenv("XDG_STATE_HOME", (folder_ / "state").c_str(), 1); }

  const testing::Folder folder_;
  const std::filesystem::path scene_ = folder_ / "faun.bzt";
};

// Whatever was done to supports is undone in the order in which it was done, also after the
// program ended without a save, and after one.
TEST_F(BesideTheClay, supportsAreStepsOfHistory) {
  const auto standing = [](const Session& session) {
    std::string text;
    for (const clay::Support& each : session.sculptor().clay().supports)
      text += std::to_string(int(each.centre.y)) + " ";
    return text;
  };
  const auto box = [](double y) { return SupportOperation{{Shape::box, {0, y, 0}, {30, 5, 30}}}; };
  const std::vector<std::string> states{"", "", "-20 ", "-20 ", "-20 20 ", "-30 20 ", "20 ", ""};
  const auto walk = [&](Session& session) {
    for (std::size_t n = states.size(); n-- > 0;) {
      EXPECT_EQ(standing(session), states[n]) << n;
      session.sculptor().apply(UndoOperation{});
    }
    for (const std::string& state : states) {
      EXPECT_EQ(standing(session), state);
      session.sculptor().apply(RedoOperation{});
    }
  };
  {
    Session session = Session::create(scene_);
    Sculptor& sculptor = session.sculptor();
    sculptor.apply(fillAt(0));
    sculptor.apply(box(-20));
    EXPECT_FALSE(session.saved());
    sculptor.apply(fillAt(9));
    sculptor.apply(box(20));
    sculptor.apply(SupportMoveOperation{0, box(-30)});
    sculptor.apply(SupportDropOperation{0});
    sculptor.apply(ReleaseOperation{});
    EXPECT_EQ(sculptor.history().undoDepth(), 7u);
    walk(session);
  }
  {
    Session session = Session::open(scene_);
    EXPECT_EQ(session.findings().unsavedSteps, 7u);
    walk(session);
    session.sculptor().apply(UndoOperation{2});
    EXPECT_EQ(standing(session), "-30 20 ");
    session.save();
    EXPECT_TRUE(session.saved());
    session.sculptor().apply(UndoOperation{});
    EXPECT_FALSE(session.saved()) << "the support stands elsewhere";
    session.sculptor().apply(RedoOperation{});
    EXPECT_TRUE(session.saved());
  }
  Session session = Session::open(scene_);
  EXPECT_EQ(standing(session), "-30 20 ");
  EXPECT_TRUE(session.saved());
  session.sculptor().apply(RedoOperation{2});
  walk(session);
}

// Of the state we are in: what undo takes back is not in it.
TEST_F(BesideTheClay, theLedgerIsKept) {
  MassLedger made;
  {
    Session session = Session::create(scene_);
    Sculptor& sculptor = session.sculptor();
    const auto run = [&](const char* line) { return sculptor.apply(parseOperation(line, "test")); };
    run("{\"op\":\"fill\",\"radii\":[12,12,12]}");
    const double ball = run("{\"op\":\"action\",\"name\":\"push\"}").massAfter;
    EXPECT_DOUBLE_EQ(sculptor.ledger().added, ball);
    run("{\"op\":\"stroke\",\"points\":[[0,20,0],[0,12,0]]}");
    EXPECT_EQ(sculptor.ledger().moves, 1);
    EXPECT_LT(std::abs(sculptor.ledger().drift), 1e-6 * ball);
    run("{\"op\":\"action\",\"name\":\"erase\"}");
    const auto cut = run("{\"op\":\"stroke\",\"points\":[[12,0,0]]}");
    made = sculptor.ledger();
    EXPECT_DOUBLE_EQ(made.removed, cut.massBefore - cut.massAfter);
    EXPECT_NEAR(made.total(), cut.massAfter, 1e-9 * ball);
    run("{\"op\":\"undo\"}");
    EXPECT_EQ(sculptor.ledger().removed, 0);
    run("{\"op\":\"redo\"}");
    EXPECT_EQ(sculptor.ledger(), made);
    session.save();
    EXPECT_TRUE(session.saved());
  }
  EXPECT_EQ(ledgerOf(loadScene(scene_).parts, "test"), made);
  Session session = Session::open(scene_);
  EXPECT_EQ(session.sculptor().ledger(), made);
  EXPECT_FALSE(session.parts.settings.contains("ledger")) << "our own business";
  session.sculptor().apply(UndoOperation{2});
  EXPECT_EQ(session.sculptor().ledger().moves, 0);
  EXPECT_TRUE(session.sculptor().ledger().removed == 0);
}

}  // namespace
}  // namespace bozzetto
