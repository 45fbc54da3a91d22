// stroke: a live one that gets all its points at once.
#include "bozzetto/sculptor/live_stroke.hpp"
#include "sculptor/run.hpp"

namespace bozzetto {

template <int Side>
void run(const StrokeOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  LiveStroke<Side> stroke(bench, operation.stroke);
  const std::string notice = stroke.notice();
  if (!notice.empty()) telling.progress.note(notice);
  const auto count = static_cast<double>(stroke.plannedDabs());
  for (double n = 0; stroke.dab(); ++n) telling.progress.step("stroke", n / count);
  telling.report = stroke.finish();
  const std::string remark = stroke.notice();
  if (!remark.empty() && remark != notice) telling.progress.note(remark);
}

BOZZETTO_RUNS(StrokeOperation);

}  // namespace bozzetto
