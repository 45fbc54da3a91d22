#include "bozzetto/grid/key.hpp"

#include <gtest/gtest.h>

#include "bozzetto/base/error.hpp"

namespace bozzetto {
namespace {

TEST(Key, orderIsLexicographic) {
  EXPECT_LT((Key{0, 9, 9}), (Key{1, 0, 0}));
  EXPECT_LT((Key{1, 0, 9}), (Key{1, 1, 0}));
  EXPECT_LT((Key{1, 1, -1}), (Key{1, 1, 0}));
}

TEST(Key, blocksDivideDownwards) {
  using Eight = BlockGeometry<8>;
  EXPECT_EQ(Eight::blockOf({-1, 0, 7}), (Key{-1, 0, 0}));
  EXPECT_EQ(Eight::indexOf({-1, 0, 7}), (7 * 8 + 0) * 8 + 7);
  EXPECT_EQ(Eight::cornersOf({-1, 0, 0}).low, (Key{-8, 0, 0}));
  EXPECT_EQ(BlockGeometry<1>::blockOf({-3, 2, 5}), (Key{-3, 2, 5}));
}

TEST(Key, growingBeyondTheWorkspaceIsAnError) {
  const std::int32_t rim = kWorkspaceRim;
  EXPECT_NO_THROW(grown({{0, 0, 0}, {rim - 1, 0, 0}}, 1));
  EXPECT_THROW(grown({{0, 0, 0}, {rim, 0, 0}}, 1), Error);
  EXPECT_THROW(grown({{0, 0, INT32_MIN}, {0, 0, 0}}, 1), Error);
}

}  // namespace
}  // namespace bozzetto
