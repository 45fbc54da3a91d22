// Every index once, whatever the threads; exceptions come out; nothing runs for nothing.
#include "bozzetto/base/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

namespace bozzetto {
namespace {

class Parallel : public testing::TestWithParam<int> {
 protected:
  void SetUp() override { setThreadCount(GetParam()); }
  void TearDown() override { setThreadCount(0); }
};

TEST_P(Parallel, CoversEveryIndexOnce) {
  for (const std::size_t count : {1u, 2u, 7u, 64u, 1000u, 4099u}) {
    for (const std::size_t grain : {0u, 1u, 3u, 64u, 5000u}) {
      std::vector<std::atomic<int>> visits(count);
      parallelFor(count, grain, [&](std::size_t begin, std::size_t end) {
        ASSERT_LT(begin, end);
        ASSERT_LE(end, count);
        for (std::size_t n = begin; n < end; ++n) ++visits[n];
      });
      for (std::size_t n = 0; n < count; ++n)
        ASSERT_EQ(visits[n], 1) << "index " << n << " of " << count << ", grain " << grain;
    }
  }
}

TEST_P(Parallel, NothingRunsForNothing) {
  parallelFor(0, 16, [](std::size_t, std::size_t) { FAIL(); });
}

TEST_P(Parallel, AnExceptionComesOutAndTheNextLoopWorks) {
  const auto failing = [](std::size_t begin, std::size_t end) {
    if (begin <= 700 && 700 < end) throw std::runtime_error("at 700");
  };
  EXPECT_THROW(parallelFor(1000, 10, failing), std::runtime_error);
  std::atomic<std::size_t> sum{0};
  parallelFor(1000, 10, [&](std::size_t begin, std::size_t end) { sum += end - begin; });
  EXPECT_EQ(sum, 1000u);
}

TEST_P(Parallel, EveryBodyThrowingGivesOneException) {
  EXPECT_THROW(
      parallelFor(100, 1, [](std::size_t, std::size_t) { throw std::runtime_error("always"); }),
      std::runtime_error);
}

TEST_P(Parallel, UsesNoMoreThreadsThanAsked) {
  std::atomic<int> working{0};
  std::atomic<int> most{0};
  parallelFor(200, 1, [&](std::size_t, std::size_t) {
    const int now = ++working;
    int seen = most;
    while (seen < now && !most.compare_exchange_weak(seen, now)) {
    }
    std::this_thread::yield();
    --working;
  });
  EXPECT_LE(most, threadCount());
}

TEST_P(Parallel, LoopsNest) {
  std::vector<std::atomic<int>> visits(32 * 32);
  parallelFor(32, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      parallelFor(32, 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t n = first; n < last; ++n) ++visits[row * 32 + n];
      });
    }
  });
  for (const auto& count : visits) ASSERT_EQ(count, 1);
}

INSTANTIATE_TEST_SUITE_P(Threads, Parallel, testing::Values(1, 2, 3, 8, 0));

TEST(ParallelSettings, ZeroMeansTheMachine) {
  setThreadCount(0);
  const int machine = threadCount();
  EXPECT_GE(machine, 1);
  setThreadCount(5);
  EXPECT_EQ(threadCount(), 5);
  setThreadCount(-3);
  EXPECT_EQ(threadCount(), machine);
  setThreadCount(0);
}

TEST(ParallelSettings, ShortLoopsStayOnTheCaller) {
  setThreadCount(4);
  int calls = 0;
  std::thread::id where;
  parallelFor(64, 64, [&](std::size_t begin, std::size_t end) {
    ++calls;
    where = std::this_thread::get_id();
    EXPECT_EQ(begin, 0u);
    EXPECT_EQ(end, 64u);
  });
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(where, std::this_thread::get_id());
  setThreadCount(0);
}

}  // namespace
}  // namespace bozzetto
