#include "render/range_allocator.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace bozzetto {
namespace {

TEST(RangeAllocator, FreedNeighboursJoin) {
  RangeAllocator ranges;
  const std::size_t a = ranges.take(10), b = ranges.take(20), c = ranges.take(30);
  ranges.take(1);
  ranges.free(a, 10);
  ranges.free(c, 30);
  ranges.free(b, 20);
  EXPECT_EQ(ranges.take(60), a);
  EXPECT_EQ(ranges.size(), 61u);
}

TEST(RangeAllocator, TakenRangesNeverOverlap) {
  RangeAllocator ranges;
  std::map<std::size_t, std::size_t> taken;
  std::mt19937 random(3);
  for (int step = 0; step < 5000; ++step) {
    if (taken.empty() || random() % 5 < 3) {
      const std::size_t count = 1 + random() % 50, start = ranges.take(count);
      EXPECT_LE(start + count, ranges.size());
      const auto after = taken.lower_bound(start);
      if (after != taken.end()) {
        ASSERT_LE(start + count, after->first);
      }
      if (after != taken.begin()) {
        ASSERT_LE(std::prev(after)->first + std::prev(after)->second, start);
      }
      taken[start] = count;
    } else {
      const auto victim = std::next(taken.begin(), std::ptrdiff_t(random() % taken.size()));
      ranges.free(victim->first, victim->second);
      taken.erase(victim);
    }
  }
  for (const auto& [start, count] : taken) ranges.free(start, count);
  EXPECT_EQ(ranges.take(ranges.size()), 0u);
}

}  // namespace
}  // namespace bozzetto
