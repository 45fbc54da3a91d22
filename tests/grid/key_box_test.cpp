#include "bozzetto/grid/key_box.hpp"

#include <gtest/gtest.h>

namespace bozzetto {
namespace {

constexpr KeyBox kLeft{{-4, 0, 1}, {2, 5, 3}}, kRight{{1, -2, 2}, {9, 3, 8}};

TEST(KeyBox, UnitedHoldsBoth) {
  const KeyBox both{{-4, -2, 1}, {9, 5, 8}};
  EXPECT_EQ(united(kLeft, kRight), both);
  EXPECT_EQ(united(kRight, kLeft), both);
}

TEST(KeyBox, AnEmptyOneCountsForNothing) {
  EXPECT_EQ(united(kLeft, {}), kLeft);
  EXPECT_EQ(united({}, kLeft), kLeft);
  EXPECT_TRUE(united({}, {}).empty());
  EXPECT_TRUE(common(kLeft, {{3, 0, 0}, {9, 9, 9}}).empty());
}

TEST(KeyBox, CommonIsInBoth) {
  EXPECT_EQ(common(kLeft, kRight), (KeyBox{{1, 0, 2}, {2, 3, 3}}));
  EXPECT_EQ(common(kLeft, kLeft), kLeft);
}

}  // namespace
}  // namespace bozzetto
