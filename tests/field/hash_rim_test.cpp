#include <gtest/gtest.h>

#include "bozzetto/field/field.hpp"

namespace bozzetto {
namespace {

TEST(FieldHash, knowsARowOfTheWholeWorkspace) {
  Clay row, same, shorter;
  const auto full = CornerBlock<8>::uniform(1.0f, packAttributes({}));
  const std::int32_t rim = kWorkspaceRim / 8;
  row.tree.put({0, 0, -rim}, 2 * rim, full);
  same.tree.put({0, 0, -rim}, rim, full);
  same.tree.put({0, 0, 0}, rim, full);
  shorter.tree.put({0, 0, -rim}, 2 * rim - 1, full);
  EXPECT_EQ(fieldHash(row), fieldHash(same));
  EXPECT_NE(fieldHash(row), fieldHash(shorter));
}

}  // namespace
}  // namespace bozzetto
