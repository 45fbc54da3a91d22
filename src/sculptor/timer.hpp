// Stopwatch of the reports.
#pragma once
#include <chrono>

namespace bozzetto {

/// Adds the milliseconds of its life to a number.
class Timer {
 public:
  explicit Timer(double& total) : total_(&total) {}
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;
  ~Timer() {
    const auto passed = std::chrono::steady_clock::now() - start_;
    *total_ += std::chrono::duration<double, std::milli>(passed).count();
  }

 private:
  double* total_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace bozzetto
