// Full cells in a line, as walks look for them: the same answers as looking at each.
#include "clay/full_lines.hpp"

#include <gtest/gtest.h>

namespace bozzetto::clay::testing {
namespace {

int countedAhead(const Region& region, std::size_t cell, FullLines::Way way, int most) {
  const std::ptrdiff_t step = way.sign * region.strides()[way.axis];
  int count = 0;
  while (count < most && isFull(region, cell + (count + 1) * step)) ++count;
  return count;
}

TEST(FullLines, AnswerLikeLookingAtEachCell) {
  Region region(KeyBox{{0, 0, 0}, {39, 47, 31}});
  std::uint32_t random = 1;
  const auto next = [&random] { return (random = random * 1664525u + 1013904223u) >> 8; };
  const auto anyCell = [&] {
    const std::uint32_t i = next() % 24, j = next() % 32, k = next() % 16;
    return region.index(Key{8, 8, 8} + Key{int(i), int(j), int(k)});
  };
  for (std::size_t cell = 0; cell < 40 * 48 * 32; ++cell) region.value[cell] = 1;
  for (int n = 0; n < 900; ++n) region.value[anyCell()] = 0.5f;
  for (int n = 0; n < 100; ++n) region.cover[anyCell()] = n % 2 == 0 ? 1.0f : 0.25f;
  for (int n = 0; n < 100; ++n) region.hold[anyCell()] = kFixed;
  FullLines lines;
  lines.begin(region);
  for (int n = 0; n < 20000; ++n) {
    const std::size_t cell = anyCell();
    const FullLines::Way way{next() % 3, next() % 2 == 0 ? 1 : -1};
    const int most = 1 + static_cast<int>(next() % 40);
    ASSERT_EQ(lines.ahead(region, cell, way, most), countedAhead(region, cell, way, most));
    if (n % 500 == 0) region.value[anyCell()] = 1;  // matter that walked there
  }
  region.value[anyCell()] = 0;
  lines.begin(region);
  for (int n = 0; n < 2000; ++n) {
    const std::size_t cell = anyCell();
    const FullLines::Way way{next() % 3, 1};
    ASSERT_EQ(lines.ahead(region, cell, way, 30), countedAhead(region, cell, way, 30));
  }
}

}  // namespace
}  // namespace bozzetto::clay::testing
