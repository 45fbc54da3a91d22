#include "bozzetto/field/changed_run.hpp"

#include <algorithm>

namespace bozzetto {
namespace {

bool before(const ChangedRun& a, const ChangedRun& b) { return a.key < b.key; }

}  // namespace

std::vector<ChangedRun> sortedOnce(std::vector<ChangedRun> runs) {
  if (!std::is_sorted(runs.begin(), runs.end(), before)) {
    std::sort(runs.begin(), runs.end(), before);
  }
  std::size_t count = 0;
  for (const ChangedRun& run : runs) {
    if (count == 0 || runs[count - 1].key != run.key) {
      runs[count++] = run;
      continue;
    }
    for (std::size_t i = 0; i < run.corners.size(); ++i)
      runs[count - 1].corners[i] |= run.corners[i];
  }
  runs.resize(count);
  return runs;
}

}  // namespace bozzetto
