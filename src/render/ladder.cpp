#include "bozzetto/render/ladder.hpp"

#include <algorithm>

namespace bozzetto {
namespace {

constexpr double kUpBelow = .60, kDownAbove = 1.10;  // of the budget
constexpr double kUpSeconds = 2;
constexpr int kDownFrames = 3;

bool drawsOnProcessor(std::string_view name) {
  return name.find("llvmpipe") != name.npos || name.find("softpipe") != name.npos;
}

}  // namespace

QualityLadder::QualityLadder(std::string_view rendererName)
    : onProcessor_(drawsOnProcessor(rendererName)),
      quality_(onProcessor_ ? Quality::light : Quality::good) {}

double QualityLadder::medianMilliseconds() const {
  const int count = std::min<int>(count_, int(last_.size()));
  if (count == 0) return 0;
  std::array<double, 8> sorted = last_;
  std::nth_element(sorted.begin(), sorted.begin() + count / 2, sorted.begin() + count);
  return sorted[std::size_t(count / 2)];
}

void QualityLadder::change(int steps, double now) {
  const int top = int(onProcessor_ ? Quality::middle : Quality::best);
  quality_ = Quality(std::clamp(int(quality_) + steps, 0, top));
  count_ = slow_ = 0;
  fastSince_ = now;
}

void QualityLadder::measured(double milliseconds, double now) {
  last_[std::size_t(count_++) % last_.size()] = milliseconds;
  const double median = medianMilliseconds(), budget = budgetMilliseconds();
  if (median > kUpBelow * budget || fastSince_ < 0) fastSince_ = now;
  slow_ = median > kDownAbove * budget ? slow_ + 1 : 0;
  if (inStroke_) return;
  if (slow_ >= kDownFrames) {
    change(-1, now);
  } else if (now - fastSince_ >= kUpSeconds) {
    change(+1, now);
  }
}

}  // namespace bozzetto
