#include "bozzetto/base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#ifdef BOZZETTO_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace bozzetto {
namespace {

using Body = FunctionRef<void(std::size_t, std::size_t)>;

std::atomic<int> requestedThreads{0};

// Asked once: it reads a file.
int machineThreads() {
  static const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return threads;
}

#ifdef BOZZETTO_WITH_TBB

// Lets TBB start more workers than the machine has cores, where somebody asks for them.
void allowThreads(int threads) {
  static std::mutex mutex;
  static std::unique_ptr<tbb::global_control> control;
  const std::lock_guard lock(mutex);
  const auto wanted = static_cast<std::size_t>(std::max(threads, machineThreads()));
  control =
      std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, wanted);
}

void runOnThreads(std::size_t count, std::size_t grain, int threads, Body body) {
  using Range = tbb::blocked_range<std::size_t>;
  auto loop = [&] {
    tbb::parallel_for(Range(0, count, grain),
                      [&](const Range& range) { body(range.begin(), range.end()); });
  };
  // The default arena starts at once; another one only where fewer threads are wanted.
  if (threads == machineThreads()) {
    loop();
  } else {
    tbb::task_arena(threads).execute(loop);
  }
}

#else

void allowThreads(int) {}

// Plain threads: what the thread sanitizer can see through (Debian's TBB is not instrumented).
void runOnThreads(std::size_t count, std::size_t grain, int threads, Body body) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failureMutex;
  auto work = [&] {
    try {
      for (;;) {
        const std::size_t begin = next.fetch_add(grain);
        if (begin >= count) return;
        body(begin, std::min(count, begin + grain));
      }
    } catch (...) {
      const std::lock_guard lock(failureMutex);
      if (!failure) failure = std::current_exception();
    }
  };
  std::vector<std::thread> workers;
  for (int t = 1; t < threads; ++t) workers.emplace_back(work);
  work();
  for (std::thread& worker : workers) worker.join();
  if (failure) std::rethrow_exception(failure);
}

#endif

}  // namespace

void setThreadCount(int threads) {
  requestedThreads = std::max(0, threads);
  allowThreads(threadCount());
}

int threadCount() {
  const int requested = requestedThreads;
  return requested == 0 ? machineThreads() : requested;
}

void parallelFor(std::size_t count, std::size_t grain, Body body) {
  if (count == 0) return;
  grain = std::max<std::size_t>(1, grain);
  const int threads = threadCount();
  if (threads == 1 || count <= grain) {
    body(0, count);
  } else {
    runOnThreads(count, grain, threads, body);
  }
}

}  // namespace bozzetto
