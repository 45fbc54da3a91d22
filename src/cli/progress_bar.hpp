// A one-line bar on a terminal; silent where standard error is not one. Ctrl+C stops the job.
#pragma once
#include <chrono>

#include "bozzetto/base/progress.hpp"

namespace bozzetto::cli {

class ProgressBar : public Progress {
 public:
  ProgressBar();
  ~ProgressBar() override;
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  bool report(std::string_view what, double done) override;
  void note(std::string_view text) override;
  /// Takes the bar away: something else is going to be printed.
  void clear() { wipe(); }

 private:
  void wipe();

  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace bozzetto::cli
