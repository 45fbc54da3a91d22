#include "tool/eikonal.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "bozzetto/base/parallel.hpp"

namespace bozzetto {
namespace {

// From the nearest neighbour on each axis.
float upwind(float a, float b, float c) {
  if (a > b) std::swap(a, b);
  if (b > c) std::swap(b, c);
  if (a > b) std::swap(a, b);
  float d = a + 1;
  if (d <= b) return d;
  const float difference = b - a;
  d = 0.5f * (a + b + std::sqrt(std::max(2 - difference * difference, 0.0f)));
  if (d <= c) return d;
  const float sum = a + b + c, squares = a * a + b * b + c * c;
  return (sum + std::sqrt(std::max(sum * sum - 3 * (squares - 1), 0.0f))) / 3;
}

class Sweeper {
 public:
  Sweeper(const std::array<int, 3>& wide, const std::vector<std::uint8_t>& fixed,
          std::vector<float>& distance)
      : wide_(wide), fixed_(fixed), distance_(distance) {}

  // Rows along k of one diagonal i + j do not see each other: threads may share them out, and it
  // is the same as one after the other.
  bool sweep(int order) {
    constexpr std::size_t nodesAThread = 8192;
    const std::size_t rowsAThread = nodesAThread / std::size_t(wide_[2]) + 1;
    std::atomic<bool> changed = false;
    for (int diagonal = 0; diagonal <= wide_[0] + wide_[1] - 2; ++diagonal) {
      const int first = std::max(0, diagonal - wide_[1] + 1),
                last = std::min(diagonal, wide_[0] - 1);
      const auto rows = std::size_t(last - first + 1);
      parallelFor(rows, rowsAThread, [&](std::size_t begin, std::size_t end) {
        bool some = false;
        for (std::size_t n = begin; n < end; ++n) {
          const int i = first + int(n), j = diagonal - i;
          some = row((order & 1) != 0 ? wide_[0] - 1 - i : i,
                     (order & 2) != 0 ? wide_[1] - 1 - j : j, (order & 4) != 0) ||
                 some;
        }
        if (some) changed = true;
      });
    }
    return changed;
  }

 private:
  bool row(int i, int j, bool backwards) {
    const std::ptrdiff_t nextI = std::ptrdiff_t{wide_[1]} * wide_[2], nextJ = wide_[2];
    const std::ptrdiff_t base = i * nextI + j * nextJ;
    const auto nearer = [&](std::ptrdiff_t at, std::ptrdiff_t step, bool below, bool above) {
      return std::min(below ? distance_[std::size_t(at - step)] : kFarAway,
                      above ? distance_[std::size_t(at + step)] : kFarAway);
    };
    bool changed = false;
    for (int n = 0; n < wide_[2]; ++n) {
      const int k = backwards ? wide_[2] - 1 - n : n;
      const std::ptrdiff_t at = base + k;
      if (fixed_[std::size_t(at)] != 0) continue;
      const float a = nearer(at, nextI, i > 0, i + 1 < wide_[0]);
      const float b = nearer(at, nextJ, j > 0, j + 1 < wide_[1]);
      const float c = nearer(at, 1, k > 0, k + 1 < wide_[2]);
      float& own = distance_[std::size_t(at)];
      if (std::min({a, b, c}) >= own) continue;
      const float d = upwind(a, b, c);
      if (d >= own) continue;
      own = d;
      changed = true;
    }
    return changed;
  }

  const std::array<int, 3>& wide_;
  const std::vector<std::uint8_t>& fixed_;
  std::vector<float>& distance_;
};

}  // namespace

void sweepDistances(const std::array<int, 3>& wide, const std::vector<std::uint8_t>& fixed,
                    int orders, std::vector<float>& distance) {
  Sweeper sweeper(wide, fixed, distance);
  int quiet = 0;
  for (int order = 0; order < orders && quiet < 8; ++order)
    quiet = sweeper.sweep(order & 7) ? 0 : quiet + 1;
}

}  // namespace bozzetto
