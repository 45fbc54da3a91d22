#include "surface/key_runs.hpp"

#include <algorithm>

namespace bozzetto {
namespace {

bool sameColumn(Key a, Key b) { return a.i == b.i && a.j == b.j; }

bool before(const KeyRun& a, const KeyRun& b) { return a.key < b.key; }

// Runs that start at or after the start of `last` and touch it become part of it.
void appendJoined(std::vector<KeyRun>& runs, const KeyRun& run) {
  if (!runs.empty()) {
    KeyRun& last = runs.back();
    const std::int32_t end = last.key.k + last.length;
    if (sameColumn(last.key, run.key) && run.key.k <= end) {
      last.length = std::max(end, run.key.k + run.length) - last.key.k;
      return;
    }
  }
  runs.push_back(run);
}

bool reaches(Reach reach, int offset) {
  return offset == 0 || (offset < 0 ? reachesBelow(reach) : reachesAbove(reach));
}

// The touched runs moved by (a, b) columns, widened along k: sorted, since the input is.
void appendShifted(std::vector<KeyRun>& out, const std::vector<TouchedRun>& touched, Key offset,
                   int below, int above) {
  for (const auto& [run, reach] : touched) {
    if (!reaches(reach[0], offset.i) || !reaches(reach[1], offset.j)) continue;
    const int down = reachesBelow(reach[2]) ? below : 0, up = reachesAbove(reach[2]) ? above : 0;
    out.push_back({run.key + offset - Key{0, 0, down}, run.length + down + up});
  }
}

// Merges sorted pieces that lie one after the other; `ends` are their ends.
void mergePieces(std::vector<KeyRun>& runs, std::vector<std::size_t> ends) {
  while (ends.size() > 1) {
    std::vector<std::size_t> merged;
    for (std::size_t n = 0; n < ends.size(); n += 2) {
      const std::size_t start = n == 0 ? 0 : ends[n - 1], last = std::min(n + 1, ends.size() - 1);
      const auto at = [&](std::size_t place) {
        return runs.begin() + static_cast<std::ptrdiff_t>(place);
      };
      std::inplace_merge(at(start), at(ends[n]), at(ends[last]), before);
      merged.push_back(ends[last]);
    }
    ends = std::move(merged);
  }
}

}  // namespace

std::vector<TouchedRun> joined(std::vector<TouchedRun> touched) {
  std::size_t count = 0;
  for (const TouchedRun& next : touched) {
    if (count > 0) {
      auto& [run, reach] = touched[count - 1];
      const Key end{run.key.i, run.key.j, run.key.k + run.length};
      if (next.run.key == end && next.reach == reach) {
        run.length += next.run.length;
        continue;
      }
    }
    touched[count++] = next;
  }
  touched.resize(count);
  return touched;
}

std::vector<KeyRun> dilated(const std::vector<TouchedRun>& touched, int below, int above) {
  std::vector<KeyRun> all;
  all.reserve(touched.size() * static_cast<std::size_t>((below + above + 1) * (below + above + 1)));
  std::vector<std::size_t> ends;
  for (int a = -below; a <= above; ++a)
    for (int b = -below; b <= above; ++b) {
      appendShifted(all, touched, {a, b, 0}, below, above);
      ends.push_back(all.size());
    }
  mergePieces(all, std::move(ends));
  std::vector<KeyRun> result;
  result.reserve(all.size());
  for (const KeyRun& run : all) appendJoined(result, run);
  return result;
}

}  // namespace bozzetto
