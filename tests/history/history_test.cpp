#include "bozzetto/history/history.hpp"

#include <gtest/gtest.h>

#include "history/sittings.hpp"

namespace bozzetto {
namespace {

using testing::Sitting;

TEST(History, undoAndRedoGiveEveryStateAgain) {
  Sitting s;
  for (int n = 0; n < 300; ++n) {
    s.anything();
    ASSERT_TRUE(s.asItWas()) << n;
    ASSERT_EQ(s.history.tree().validate(), std::nullopt);
  }
  s.undo(1000);
  EXPECT_EQ(s.history.place(), 0u);
  EXPECT_TRUE(s.asItWas());
  s.redo(1000);
  EXPECT_EQ(s.history.place(), s.history.tree().tip());
  EXPECT_TRUE(s.asItWas());
  EXPECT_EQ(validate(s.clay), std::nullopt);
}

TEST(History, aStepAfterUndoBeginsABranchAndTheOldOneStays) {
  Sitting s;
  for (int n = 0; n < 3; ++n) s.change();
  s.undo(2);
  const StepNumber branch = s.change();
  EXPECT_EQ(branch, 4u);
  EXPECT_EQ(s.history.undoDepth(), 2u);
  EXPECT_EQ(s.history.redoDepth(), 0u);
  s.goTo(3);
  EXPECT_TRUE(s.asItWas());
  EXPECT_EQ(s.history.undoDepth(), 3u);
  s.goTo(2);
  EXPECT_EQ(s.history.redoDepth(), 1u) << "towards 3, where we were";
  s.goTo(4);
  s.undo();
  EXPECT_EQ(s.history.tree().redoTarget(9), 4u) << "redo goes where we came from";
}

TEST(History, jumpsCostEachBlockOnce) {
  Sitting s;
  for (int n = 0; n < 40; ++n) s.change();
  const auto journey = s.history.goTo(3, s.clay.tree, s.clay.scale);
  std::set<Key> keys;
  for (const auto& change : journey.delta->changes) {
    EXPECT_TRUE(keys.insert(change.key).second);
    EXPECT_FALSE(change.before == change.after);
  }
}

TEST(History, thePastCanBeLookedAtWithoutGoingThere) {
  Sitting s;
  std::uint64_t then = 0;
  for (int n = 0; n < 20; ++n) {
    if (s.change() == 7) then = fieldHash(s.clay);
  }
  EXPECT_EQ(fieldHash(s.history.fieldAt(7, s.clay)), then);
  EXPECT_EQ(s.history.place(), 20u);
  EXPECT_TRUE(s.asItWas());
  EXPECT_THROW(s.history.fieldAt(21, s.clay), Error);
  EXPECT_THROW(s.goTo(99), Error);
  EXPECT_TRUE(s.asItWas());
}

TEST(History, aStepThatChangesNothingIsAStep) {
  Sitting s;
  s.history.push(std::make_shared<const Delta<testing::Block>>(), {"stroke", {}, {}});
  EXPECT_EQ(s.history.undoDepth(), 1u);
  s.undo();
  EXPECT_EQ(s.history.redoDepth(), 1u);
}

TEST(History, scalesGoWithTheirStates) {
  Sitting s;
  const auto nothing = std::make_shared<const Delta<testing::Block>>();
  s.history.push(nothing, {"resample", {1, 0.5f}, {2, 0.5f}});
  s.clay.scale.spacing = 2;
  s.undo();
  EXPECT_EQ(s.clay.scale.spacing, 1);
  s.redo();
  EXPECT_EQ(s.clay.scale.spacing, 2);
}

TEST(History, inMemoryOldStepsArePackedAndThenForgotten) {
  HistoryLimits limits;
  limits.memoryBytes = 200'000;
  Sitting s;
  s.history = History<8>(limits);
  for (int n = 0; n < 600; ++n) {
    s.change();
    ASSERT_LE(s.history.memoryBytes(), limits.memoryBytes + 500'000);
  }
  const std::size_t depth = s.history.undoDepth();
  EXPECT_GT(depth, 150u) << "packed steps are small";
  EXPECT_LT(depth, 600u);
  s.undo(2000);
  EXPECT_TRUE(s.asItWas());
  s.redo(2000);
  EXPECT_EQ(s.history.place(), s.history.tree().tip());
  EXPECT_GT(s.history.undoDepth(), 150u);
  EXPECT_TRUE(s.asItWas());
}

TEST(History, thePapersCornersHaveOneToo) {
  Field<1> clay;
  History<1> history;
  std::vector<std::uint64_t> hashes{fieldHash(clay)};
  std::mt19937 random(5);
  for (int n = 0; n < 20; ++n) {
    Edit<CornerBlock<1>> edit(clay.tree);
    for (int c = 0; c < 30; ++c) {
      const auto at = [&] { return static_cast<std::int32_t>(random() % 6u); };
      edit.write({at(), at(), at()}).value[0] = static_cast<float>(random() % 3u) / 2;
    }
    history.push(std::make_shared<const Delta<CornerBlock<1>>>(edit.commit()), {"", {}, {}});
    hashes.push_back(fieldHash(clay));
  }
  for (StepNumber n = 20; n-- > 0;) {
    history.goTo(n, clay.tree, clay.scale);
    ASSERT_EQ(fieldHash(clay), hashes[n]);
  }
}

// Ten thousand strokes there and back, in a memory that holds a few.
TEST(History, SlowTenThousandStrokesComeBackBitForBit) {
  HistoryLimits limits;
  limits.memoryBytes = 16u << 20;
  Sitting s;
  s.history = History<8>(limits);
  for (int n = 0; n < 10'000; ++n) {
    auto delta =
        std::make_shared<const Delta<testing::Block>>(testing::randomChange(s.clay, s.random));
    s.history.push(std::move(delta), {"stroke", {}, {}});
    if (n % 1000 == 0) s.hashes[s.history.place()] = fieldHash(s.clay);
  }
  ASSERT_EQ(s.history.undoDepth(), 10'000u);
  s.hashes[10'000] = fieldHash(s.clay);
  for (auto state = s.hashes.rbegin(); state != s.hashes.rend(); ++state) {
    ASSERT_EQ(s.goTo(state->first), "");
    ASSERT_TRUE(s.asItWas()) << state->first;
  }
  EXPECT_TRUE(s.clay.tree.empty());
  for (const auto& [state, hash] : s.hashes) {
    ASSERT_EQ(s.goTo(state), "");
    ASSERT_TRUE(s.asItWas()) << state;
  }
}

TEST(StepTree, aTipWhoseFileIsLostIsNoTip) {
  StepTree tree;
  for (StepNumber number = 1; number < 4; ++number) {
    Step step;
    step.number = number;
    step.parent = number - 1;
    tree.add(step);
  }
  tree.moveTo(1);
  tree.aimAt(9);
  EXPECT_EQ(tree.tip(), 3u);
  EXPECT_EQ(tree.validate(), std::nullopt);
}

}  // namespace
}  // namespace bozzetto
