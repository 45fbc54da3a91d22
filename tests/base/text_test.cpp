#include "bozzetto/base/text.hpp"

#include <gtest/gtest.h>

namespace bozzetto {
namespace {

TEST(Text, lowerLeavesAllButCapitals) {
  EXPECT_EQ(lower("Fox 7.BZT"), "fox 7.bzt");
  EXPECT_EQ(lower("Äpfel"), "Äpfel");
  EXPECT_EQ(lower(""), "");
}

}  // namespace
}  // namespace bozzetto
