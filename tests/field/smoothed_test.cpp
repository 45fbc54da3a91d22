#include "bozzetto/field/smoothed.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "bozzetto/field/difference.hpp"
#include "field/test_fields.hpp"

namespace bozzetto {
namespace {

Clay fieldOf(const KeyBox& box, float (*value)(Key)) {
  Clay field;
  Edit<CornerBlock<8>> edit(field.tree);
  for (Key key = box.low; key.i <= box.high.i; ++key.i)
    for (key.j = box.low.j; key.j <= box.high.j; ++key.j)
      for (key.k = box.low.k; key.k <= box.high.k; ++key.k) {
        if (value(key) <= 0) continue;
        auto& block = edit.write(BlockGeometry<8>::blockOf(key));
        const int n = BlockGeometry<8>::indexOf(key);
        block.value[n] = value(key);
        block.attributes[n] = packAttributes({10, 20, 30});
        block.updateRange();
      }
  edit.commit();
  return field;
}

// One corner at the edge of its block: an eighth stays, the corner beyond has a 64th of it.
TEST(Smoothed, SharesAmongTwentySeven) {
  const Clay one = fieldOf({{7, 8, -1}, {7, 8, -1}}, [](Key) { return 1.0f; });
  const Clay field = smoothed(one);
  EXPECT_EQ(validate(field), std::nullopt);
  EXPECT_EQ(field.value({7, 8, -1}), 1 / 8.0f);
  EXPECT_EQ(field.value({8, 8, -1}), 1 / 16.0f);
  EXPECT_EQ(field.value({8, 7, -1}), 1 / 32.0f);
  EXPECT_EQ(field.value({8, 7, 0}), 1 / 64.0f);
  EXPECT_EQ(field.value({9, 8, -1}), 0);
  EXPECT_EQ(field.attributes({8, 7, 0}), packAttributes({10, 20, 30}));
  EXPECT_EQ(statistics(field).mass, statistics(one).mass);
}

TEST(Smoothed, KeepsMassAndSharesTheInside) {
  const Clay ball = testing::ball<8>(30, {3, 1, -7}, {10, 200, 77});
  const Clay field = smoothed(ball);
  EXPECT_EQ(validate(field), std::nullopt);
  EXPECT_NEAR(statistics(field).mass / statistics(ball).mass, 1, 1e-6);
  EXPECT_EQ(field.tree.find({0, 0, 0}), ball.tree.find({0, 0, 0}));
  EXPECT_EQ(field.attributes({3, 1, -7}), ball.attributes({3, 1, -7}));
}

TEST(Smoothed, NothingStaysNothing) { EXPECT_TRUE(smoothed(Clay{}).tree.empty()); }

// Changes as strokes make them: it follows them, and tells no more than what they did to it.
TEST(Smoothed, FollowsChanges) {
  Clay field = testing::ball<8>(30, {3, 1, -7}, {10, 200, 77});
  Clay copy = smoothed(field);
  std::mt19937 chance(7);
  for (int n = 0; n < 12; ++n) {
    const Clay before = field, copyBefore = copy;
    Edit<CornerBlock<8>> edit(field.tree);
    const auto some = [&] { return std::int32_t(chance() % 80) - 40; };
    const Key low{some(), some(), some()};
    for (std::int32_t m = 0; m < 20 * 20 * 20; ++m) {
      const Key key = low + Key{m / 400, m / 20 % 20, m % 20};
      auto& block = edit.write(BlockGeometry<8>::blockOf(key));
      block.value[BlockGeometry<8>::indexOf(key)] = float(n % 3) / 2;
      block.attributes[BlockGeometry<8>::indexOf(key)] = packAttributes({9, 9, 9});
      block.updateRange();
    }
    edit.commit();
    const auto changed = differingBlocks(before, field);
    const auto altered = refreshSmoothed(copy, field, changed);
    EXPECT_EQ(validate(copy), std::nullopt);
    EXPECT_EQ(fieldHash(copy), fieldHash(smoothed(field)));
    std::set<Key> told;
    for (const KeyRun& run : altered) told.insert(run.key);
    for (const KeyRun& run : differingBlocks(copyBefore, copy))
      for (std::int32_t k = 0; k < run.length; ++k)
        EXPECT_TRUE(told.contains(run.key + Key{0, 0, k}));
    EXPECT_LE(told.size(), 5u * 5 * 5) << "4 blocks a side at most, and what they reach";
  }
}

// A slope of 1 in 12 with edges of one cell, as moved clay has them: how far its surface is from
// the plane, at worst.
double terracesOf(const Clay& field) {
  double worst = 0;
  for (int i = 12; i < 84; ++i)
    for (int j = 0; j < 24; ++j) {
      const double below = field.value({i, j, 8}), above = field.value({i, j + 1, 8});
      if (below < 0.5 || above >= 0.5) continue;
      const double height = j + (below - 0.5) / (below - above);
      worst = std::max(worst, std::abs(height - (i / 12.0 + 3.5)));
    }
  return worst;
}

TEST(Smoothed, TakesTerracesAway) {
  const Clay slope = fieldOf({{0, 0, 0}, {96, 24, 16}}, [](Key key) {
    return std::clamp(static_cast<float>(key.i) / 12 + 4 - static_cast<float>(key.j), 0.0f, 1.0f);
  });
  const double before = terracesOf(slope);
  EXPECT_GT(before, 0.08);
  EXPECT_LT(terracesOf(smoothed(slope)), 0.5 * before);
}

}  // namespace
}  // namespace bozzetto
