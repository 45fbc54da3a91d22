#include "bozzetto/base/background.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "bozzetto/base/parallel.hpp"

namespace bozzetto {
namespace {

TEST(Background, worksWhileOthersDo) {
  std::vector<int> there(20000), here(20000);
  const auto fill = [](std::vector<int>& list) {
    parallelFor(list.size(), 100, [&](std::size_t begin, std::size_t end) {
      std::iota(list.begin() + begin, list.begin() + end, int(begin));
    });
  };
  Background job([&] { fill(there); });
  fill(here);
  job.wait();
  EXPECT_TRUE(job.finished());
  EXPECT_EQ(there, here);
}

TEST(Background, tellsOnceWhatTheJobThrew) {
  Background job([] { throw std::runtime_error("x"); });
  EXPECT_THROW(job.wait(), std::runtime_error);
  job.wait();
  EXPECT_TRUE(job.finished());
}

TEST(Background, waitsForTheJobWhenItGoes) {
  std::atomic<int> done{0};
  {
    Background job([&] { ++done; });
    const Background moved = std::move(job);
  }
  EXPECT_EQ(done, 1);
}

}  // namespace
}  // namespace bozzetto
