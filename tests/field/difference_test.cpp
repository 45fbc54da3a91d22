// What compare counts against counting by hand.
#include "bozzetto/field/difference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "field/test_fields.hpp"

namespace bozzetto {
namespace {

using testing::ball;

template <class T>
class Difference : public ::testing::Test {
 public:
  static constexpr int kSide = T::value;
};
using Sides = ::testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 8>>;
TYPED_TEST_SUITE(Difference, Sides);

TYPED_TEST(Difference, isNothingBetweenCopies) {
  const auto clay = ball<TestFixture::kSide>(12);
  const FieldDifference none = compare(clay, clay);
  EXPECT_EQ(none.blocks, 0);
  EXPECT_EQ(none.corners, 0);
  EXPECT_TRUE(none.bounds.empty());
  EXPECT_EQ(none.massBefore, none.massAfter);
}

TYPED_TEST(Difference, countsEveryCornerOnce) {
  const auto before = ball<TestFixture::kSide>(20),
             after = ball<TestFixture::kSide>(17, {6, -3, 2});
  std::int64_t corners = 0;
  for (std::int32_t i = -30; i <= 30; ++i)
    for (std::int32_t j = -30; j <= 30; ++j)
      for (std::int32_t k = -30; k <= 30; ++k) {
        const Key corner{i, j, k};
        corners += before.value(corner) != after.value(corner) ||
                   before.attributes(corner) != after.attributes(corner);
      }
  EXPECT_EQ(compare(before, after).corners, corners);
  EXPECT_EQ(compare(after, before).corners, corners);
}

TYPED_TEST(Difference, theBlocksThatDifferHoldAllCornersThatDo) {
  constexpr int side = TestFixture::kSide;
  const auto before = ball<side>(20), after = ball<side>(17, {6, -3, 2});
  const std::vector<KeyRun> runs = differingBlocks(before, after);
  std::int64_t blocks = 0;
  std::set<Key> keys;
  for (const KeyRun& run : runs) {
    blocks += run.length;
    for (int n = 0; n < run.length; ++n) keys.insert(run.key + Key{0, 0, n});
  }
  EXPECT_TRUE(std::ranges::is_sorted(runs, {}, &KeyRun::key));
  EXPECT_EQ(std::int64_t(keys.size()), blocks) << "none twice";
  EXPECT_EQ(blocks, compare(before, after).blocks);
  for (std::int32_t i = -30; i <= 30; ++i)
    for (std::int32_t j = -30; j <= 30; ++j) {
      const Key corner{i, j, (i + j) % 20};
      if (before.value(corner) == after.value(corner)) continue;
      EXPECT_TRUE(keys.contains(BlockGeometry<side>::blockOf(corner))) << i << " " << j;
    }
}

TYPED_TEST(Difference, knowsShapeFromColourAndWhere) {
  auto before = ball<TestFixture::kSide>(20);
  auto after = before;
  testing::fill<TestFixture::kSide>(
      after, {{-2, -1, 0}, {2, 1, 3}}, [](Key) { return 1.0f; }, Colour{1, 2, 3});
  const FieldDifference painted = compare(before, after);
  EXPECT_EQ(painted.corners, 5 * 3 * 4);
  EXPECT_EQ(painted.reshaped, 0);
  EXPECT_EQ(painted.bounds, (KeyBox{{-2, -1, 0}, {2, 1, 3}}));
  testing::fill<TestFixture::kSide>(after, {{0, 0, 0}, {0, 0, 0}}, [](Key) { return 0.5f; });
  EXPECT_EQ(compare(before, after).reshaped, 1);
  EXPECT_DOUBLE_EQ(compare(before, after).massAfter, compare(before, after).massBefore - 0.5);
}

// A solid's inside is one run of blocks a row.
TYPED_TEST(Difference, looksIntoLongRuns) {
  const Field<TestFixture::kSide> empty;
  const auto solid = ball<TestFixture::kSide>(40);
  const FieldDifference all = compare(empty, solid);
  EXPECT_EQ(all.corners, statistics(solid).corners);
  EXPECT_EQ(all.bounds, statistics(solid).bounds);
  EXPECT_EQ(compare(solid, empty).corners, all.corners);
}

}  // namespace
}  // namespace bozzetto
