#include "bozzetto/history/undo_stack.hpp"

#include <gtest/gtest.h>

#include <random>

#include "field/test_fields.hpp"

namespace bozzetto {
namespace {

using Stack = UndoStack<CornerBlock<8>, int>;

Delta<CornerBlock<8>> randomBox(Clay& clay, std::mt19937& random) {
  const auto at = [&] { return static_cast<std::int32_t>(random() % 40u) - 20; };
  const Key low{at(), at(), at()};
  const float value = static_cast<float>(random() % 3u) / 2;
  const Colour colour{static_cast<std::uint8_t>(random()), 0, 0};
  return testing::fill<8>(
      clay, {low, low + Key{12, 12, 12}}, [&](Key) { return value; }, colour);
}

TEST(UndoStack, undoAndRedoGiveEveryStateAgain) {
  std::mt19937 random(3);
  Clay clay;
  Stack stack;
  std::vector<std::uint64_t> hashes{fieldHash(clay)};
  for (int n = 0; n < 60; ++n) {
    stack.push(randomBox(clay, random), n);
    hashes.push_back(fieldHash(clay));
  }
  for (int step = 0; step < 500; ++step) {
    const bool back = random() % 2 == 0;
    if (back && stack.canUndo()) stack.undo(clay.tree);
    if (!back && stack.canRedo()) stack.redo(clay.tree);
    ASSERT_EQ(fieldHash(clay), hashes[stack.undoDepth()]);
  }
  EXPECT_EQ(validate(clay), std::nullopt);
}

TEST(UndoStack, aNewStepForgetsTheUndoneOnes) {
  std::mt19937 random(4);
  Clay clay;
  Stack stack;
  for (int n = 0; n < 3; ++n) stack.push(randomBox(clay, random), n);
  stack.undo(clay.tree);
  EXPECT_EQ(stack.undo(clay.tree).note, 1);
  stack.push({}, 7);
  EXPECT_EQ(stack.undoDepth(), 2u);
  EXPECT_FALSE(stack.canRedo());
  EXPECT_EQ(stack.steps().back().note, 7);
}

}  // namespace
}  // namespace bozzetto
