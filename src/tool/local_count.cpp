#include "tool/local_count.hpp"

#include <algorithm>
#include <cmath>

namespace bozzetto {
namespace {

// Positions along one grid line: base + n·step on each tool axis.
struct Line {
  std::array<float, 3> base, step;

  bool inside(std::int32_t n) const {
    const auto at = static_cast<float>(n);
    for (int axis = 0; axis < 3; ++axis)
      if (!(std::abs(base[axis] + at * step[axis]) <= 1)) return false;
    return true;
  }
};

// The n in [low, high] inside are an interval: rounding is monotone. Solve it in double, then let
// the float positions decide at its ends.
std::int64_t countOnLine(const Line& line, std::int32_t low, std::int32_t high) {
  double from = low, until = high;
  for (int axis = 0; axis < 3; ++axis) {
    const double base = line.base[axis], step = line.step[axis];
    if (step == 0 && std::abs(base) > 1) return 0;
    if (step == 0) continue;
    const double a = (-1 - base) / step, b = (1 - base) / step;
    from = std::max(from, std::min(a, b));
    until = std::min(until, std::max(a, b));
  }
  auto first = static_cast<std::int32_t>(std::ceil(std::min(from, high + 1.0)));
  auto last = static_cast<std::int32_t>(std::floor(std::max(until, low - 1.0)));
  while (first > low && line.inside(first - 1)) --first;
  while (first <= last && !line.inside(first)) ++first;
  while (last < high && line.inside(last + 1)) ++last;
  while (last >= first && !line.inside(last)) --last;
  return std::max(0, last - first + 1);
}

// Rows along k of one frame, most of them counted without a look at float positions: an end that
// is not within rounding of a corner is where the double says.
class Rows {
 public:
  Rows(const LocalFrame& frame, Key low, Key high) : frame_(&frame), low_(low.k), high_(high.k) {
    for (int axis = 0; axis < 3; ++axis) {
      const double step = frame.step[2][axis];
      flat_ = flat_ || step == 0;
      perStep_[axis] = 1 / step;
      half_[axis] = std::abs(perStep_[axis]);
      slack_ = std::max(slack_, kRounding * half_[axis]);
    }
  }

  std::int64_t count(std::int32_t i, std::int32_t j) const {
    Line line{{}, frame_->step[2]};
    double from = low_, until = high_;
    for (int axis = 0; axis < 3; ++axis) {
      line.base[axis] = (frame_->first[axis] + static_cast<float>(i) * frame_->step[0][axis]) +
                        static_cast<float>(j) * frame_->step[1][axis];
      const double middle = static_cast<double>(-line.base[axis]) * perStep_[axis];
      from = std::max(from, middle - half_[axis]);
      until = std::min(until, middle + half_[axis]);
    }
    if (flat_) return countOnLine(line, low_, high_);
    if (from - until > 2 * slack_) return 0;
    const std::int32_t first = ceiling(from - slack_), last = -ceiling(-(until + slack_));
    const bool sure = first == ceiling(from + slack_) && last == -ceiling(slack_ - until);
    const bool ends = first <= low_ || last >= high_;
    return sure && !ends ? std::max(0, last - first + 1) : countOnLine(line, low_, high_);
  }

 private:
  static constexpr double kRounding = 1e-6;  // of local positions where they are 1
  // Of numbers that fit; cheaper than the library's, which is a call.
  static std::int32_t ceiling(double x) {
    const auto whole = static_cast<std::int32_t>(x);
    return whole + (static_cast<double>(whole) < x ? 1 : 0);
  }

  const LocalFrame* frame_;
  std::int32_t low_, high_;
  std::array<double, 3> perStep_{}, half_{};
  double slack_ = 0;
  bool flat_ = false;  // a tool axis that does not change along the rows
};

// True when every tool axis varies along one grid axis only.
bool axisAligned(const LocalFrame& frame) {
  for (int axis = 0; axis < 3; ++axis) {
    int varying = 0;
    for (int grid = 0; grid < 3; ++grid) varying += frame.step[grid][axis] != 0;
    if (varying > 1) return false;
  }
  return true;
}

std::int64_t countAligned(const LocalFrame& frame, Key low, Key high) {
  std::int64_t count = 1;
  for (const Axis grid : kAxes) {
    Line line{{}, frame.step[index(grid)]};
    for (int axis = 0; axis < 3; ++axis)
      line.base[axis] = line.step[axis] != 0 ? frame.first[axis] : 0;
    count *= countOnLine(line, low[grid], high[grid]);
  }
  return count;
}

}  // namespace

std::int64_t countLocal(const LocalFrame& frame, Key low, Key high) {
  if (axisAligned(frame)) return countAligned(frame, low, high);
  std::int64_t count = 0;
  const Rows rows(frame, low, high);
  for (std::int32_t i = low.i; i <= high.i; ++i)
    for (std::int32_t j = low.j; j <= high.j; ++j) count += rows.count(i, j);
  return count;
}

}  // namespace bozzetto
