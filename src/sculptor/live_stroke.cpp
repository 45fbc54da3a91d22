#include "bozzetto/sculptor/live_stroke.hpp"

#include "sculptor/dab_counts.hpp"
#include "sculptor/dab_maker.hpp"
#include "sculptor/timer.hpp"

namespace bozzetto {

template <int Side>
LiveStroke<Side>::LiveStroke(Workbench<Side>& bench, Stroke stroke)
    : bench_(&bench),
      stroke_(std::move(stroke)),
      edit_(bench.tree()),
      stiffness_(bench.clay.stiffness),
      maker_(makeDabMaker<Side>(bench, edit_, stroke_)) {
  report_.op = "stroke";
  report_.massBefore = bench.mass();
}

template <int Side>
LiveStroke<Side>::~LiveStroke() {
  if (finished_) return;
  edit_.rollback();
  bench_->clay.stiffness = stiffness_;
  bench_->showAll();
}

template <int Side>
void LiveStroke<Side>::extend(std::span<const StrokePoint> points) {
  maker_->extend(points);
  stroke_.points.insert(stroke_.points.end(), points.begin(), points.end());
}

template <int Side>
std::int64_t LiveStroke<Side>::plannedDabs() const {
  return maker_->dabCount();
}

template <int Side>
std::string LiveStroke<Side>::notice() const {
  return maker_->notice();
}

template <int Side>
bool LiveStroke<Side>::dab() {
  if (report_.dabs >= maker_->sureDabs()) return false;
  makeDab();
  return true;
}

template <int Side>
void LiveStroke<Side>::makeDab() {
  DabReport dab;
  {
    const Timer timer(report_.msField);
    dab = maker_->dab(report_.dabs++);
  }
  addCounts(dab, bench_->field().scale.spacing, report_);
  bench_->refresh(sortedOnce(std::move(dab.changed)), report_);
  if (bench_->shows()) takeStiffness();
}

template <int Side>
void LiveStroke<Side>::takeStiffness() {
  if (auto stiffness = maker_->stiffness()) bench_->clay.stiffness = std::move(*stiffness);
}

template <int Side>
OperationReport LiveStroke<Side>::finish() {
  while (report_.dabs < maker_->dabCount()) makeDab();
  std::vector<ChangedRun> changed;
  {
    const Timer timer(report_.msField);
    changed = maker_->finish();
  }
  if (!changed.empty()) bench_->refresh(sortedOnce(std::move(changed)), report_);
  takeStiffness();
  bench_->keep(edit_, report_);
  finished_ = true;
  report_.massAfter = bench_->mass();
  return report_;
}

template class LiveStroke<1>;
template class LiveStroke<8>;

}  // namespace bozzetto
