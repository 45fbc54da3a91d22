#include "bozzetto/base/memory.hpp"

#include <gtest/gtest.h>

namespace bozzetto {
namespace {

TEST(Memory, IsReadFromWhatLinuxTells) {
  EXPECT_EQ(availableMemory("MemTotal: 100 kB\nMemAvailable:   2048 kB\nCached: 3 kB\n"), 2097152u);
  EXPECT_EQ(availableMemory("MemTotal: 100 kB\n"), std::nullopt);
  EXPECT_EQ(availableMemory("MemAvailable:"), std::nullopt);
  EXPECT_EQ(availableMemory("MemAvailable: much"), std::nullopt);
  EXPECT_EQ(availableMemory("MemAvailable: 99999999999999999999 kB"), std::nullopt);
}

TEST(Memory, ThisMachineHasSome) {
  const auto bytes = availableMemory();
  ASSERT_TRUE(bytes);
  EXPECT_GT(*bytes, std::uint64_t{1} << 20);
}

}  // namespace
}  // namespace bozzetto
