#include "bozzetto/field/field.hpp"

#include <gtest/gtest.h>

#include "field/test_fields.hpp"

namespace bozzetto {
namespace {

using testing::ball;

TEST(Field, absentCornersAreEmpty) {
  const Clay clay;
  EXPECT_EQ(clay.value({5, -7, 9}), 0.0f);
  EXPECT_EQ(clay.attributes({5, -7, 9}), 0u);
  EXPECT_EQ(statistics(clay).corners, 0);
  EXPECT_TRUE(statistics(clay).bounds.empty());
}

TEST(Field, sideOneAndSideEightHoldTheSameClay) {
  const auto eight = ball<8>(20.3f, {3, -5, 7});
  const auto one = ball<1>(20.3f, {3, -5, 7});
  EXPECT_EQ(fieldHash(eight), fieldHash(one));
  EXPECT_EQ(fieldHash(withSide<1>(eight)), fieldHash(eight));
  EXPECT_EQ(fieldHash(withSide<8>(one)), fieldHash(one));
  EXPECT_TRUE(massUnits(eight) == massUnits(one));
  EXPECT_EQ(statistics(eight).corners, statistics(one).corners);
  EXPECT_EQ(statistics(eight).bounds, statistics(one).bounds);
  EXPECT_EQ(validate(eight), std::nullopt);
  EXPECT_EQ(validate(one), std::nullopt);
}

TEST(Field, massOfABallIsItsVolume) {
  const double radius = 30;
  const double expected = 4.0 / 3.0 * 3.14159265358979 * radius * radius * radius;
  EXPECT_NEAR(statistics(ball<8>(30)).mass, expected, 0.002 * expected);
}

TEST(Field, theInsideCostsNoCornerStorage) {
  const FieldStatistics small = statistics(ball<8>(40)), large = statistics(ball<8>(80));
  EXPECT_LT(large.blocks, 5 * small.blocks);  // grows with the surface: 4 times, not 8
  EXPECT_LT(large.nodes, 5 * small.nodes);
}

TEST(Field, hashSeesValueColourAndPlace) {
  const auto hash = fieldHash(ball<8>(9));
  EXPECT_NE(hash, fieldHash(ball<8>(9.01f)));
  EXPECT_NE(hash, fieldHash(ball<8>(9, {1, 0, 0})));
  EXPECT_NE(hash, fieldHash(ball<8>(9, {}, Colour{1, 2, 3})));
  EXPECT_EQ(hash, fieldHash(ball<8>(9)));
}

TEST(Field, hashDoesNotDependOnThreads) {
  const auto field = ball<8>(33);
  setThreadCount(1);
  const auto one = fieldHash(field);
  setThreadCount(4);
  EXPECT_EQ(one, fieldHash(field));
  setThreadCount(0);
}

TEST(Field, wayOfBuildingDoesNotShow) {
  auto field = ball<8>(12);
  const auto hash = fieldHash(field);
  const auto mass = massUnits(field);
  const auto delta =
      testing::fill<8>(field, {{-30, -30, -30}, {30, 30, 30}}, [](Key) { return 1.0f; });
  EXPECT_EQ(validate(field), std::nullopt);
  EXPECT_NE(fieldHash(field), hash);
  delta.apply(field.tree, Direction::backward);
  EXPECT_EQ(fieldHash(field), hash);
  EXPECT_TRUE(massUnits(field) == mass);
  EXPECT_EQ(validate(field), std::nullopt);
}

TEST(Field, clearedCornersLeaveTheTree) {
  auto field = ball<8>(12);
  testing::fill<8>(field, {{-16, -16, -16}, {16, 16, 16}}, [](Key) { return 0.0f; });
  EXPECT_TRUE(field.tree.empty());
}

TEST(Field, duplicatesShareBlocks) {
  const auto field = ball<8>(40);
  const Clay copy = field;  // NOLINT(performance-unnecessary-copy-initialization)
  for (const auto& [key, run] : field.tree) ASSERT_EQ(copy.tree.find(key), run.block.get());
}

}  // namespace
}  // namespace bozzetto
