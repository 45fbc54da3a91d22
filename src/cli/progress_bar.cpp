#include "cli/progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>

namespace bozzetto::cli {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void onInterrupt(int) { interrupted = 1; }

// That nobody reads it is no reason to stop.
void tell(const std::string& text) { std::fputs(text.c_str(), stderr); }

}  // namespace

ProgressBar::ProgressBar() : terminal_(::isatty(STDERR_FILENO) != 0) {
  std::signal(SIGINT, onInterrupt);
}

ProgressBar::~ProgressBar() {
  wipe();
  std::signal(SIGINT, SIG_DFL);
}

bool ProgressBar::report(std::string_view what, double done) {
  if (interrupted != 0) return false;
  const auto now = std::chrono::steady_clock::now();
  if (!terminal_ || now - last_ < std::chrono::milliseconds(50)) return true;
  last_ = now;
  constexpr int width = 30;
  const int filled = std::clamp(static_cast<int>(done * width), 0, width);
  tell(fmt::format("\r{:<14} [{:=<{}}{: <{}}] {:3.0f} %", what, "", filled, "", width - filled,
                   100 * done));
  std::fflush(stderr);
  shown_ = true;
  return true;
}

void ProgressBar::note(std::string_view text) {
  wipe();
  tell(fmt::format("bozzetto: {}\n", text));
}

void ProgressBar::wipe() {
  if (shown_) tell(fmt::format("\r{:60}\r", ""));
  shown_ = false;
}

}  // namespace bozzetto::cli
