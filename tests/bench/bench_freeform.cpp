// Freeform tools against ellipsoids of the same radius, in one run: the counter `ratio` is the time
// of a dab to that of the ellipsoid's, `per_corner` the same per corner changed. And stamps, and
// what duplicating a scene of 100,000 blocks takes.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "bozzetto/base/parallel.hpp"
#include "bozzetto/tool/fill.hpp"
#include "bozzetto/tool/sculpture.hpp"
#include "bozzetto/tool/stroke.hpp"
#include "workload.hpp"

namespace bozzetto {
namespace {

struct Job {
  ActionKind kind;
  glm::dquat rotation;
  double scale;
  bool conserving;
};

Clay ballOf(double radius) {
  Clay clay;
  Edit<CornerBlock<8>> edit(clay.tree);
  Primitive ball;
  ball.radii = glm::dvec3(radius);
  fill<8>(edit, clay.scale, ball);
  edit.commit();
  return clay;
}

struct Dab {
  double seconds, dirty;
};

Dab timed(const ToolShape& tool, const Job& job, double radius) {
  static const Clay body = ballOf(256);
  Clay clay = body;
  Edit<CornerBlock<8>> edit(clay.tree);
  Stroke path;
  path.points = {{{256.3, 0.2, 0.1}, 1}, {{256.3, 2.5 * radius, 0.7}, 1}};
  ActionOptions action{job.kind, 0.5, {}};
  action.stamp.conserving = job.conserving;
  StrokeRunner<8> runner(edit, clay.scale, tool, action, path);
  Dab dab{0, 0};
  const double start = workload::seconds();
  for (std::int64_t n = 0; n < runner.dabCount(); ++n) dab.dirty += double(runner.dab(n).dirty);
  dab.seconds = (workload::seconds() - start) / double(runner.dabCount());
  dab.dirty /= double(runner.dabCount());
  return dab;
}

void freeform(benchmark::State& state, const Job& job) {
  setThreadCount(1);
  const double radius = double(state.range(0));
  ToolShape plain, sculpted;
  plain.radii = glm::dvec3(radius);
  plain.rotation = sculpted.rotation = job.rotation;
  sculpted.shape = Shape::freeform;
  sculpted.scale = glm::dvec3(job.scale);
  sculpted.sculpture = std::make_shared<Sculpture>(ballOf(radius - 1));
  double ours = 0, theirs = 0, dirty = 0, theirDirty = 0;
  for (auto _ : state) {
    const Dab dab = timed(sculpted, job, radius), other = timed(plain, job, radius);
    state.SetIterationTime(dab.seconds);
    ours += dab.seconds;
    theirs += other.seconds;
    dirty += dab.dirty;
    theirDirty += other.dirty;
  }
  state.counters["ratio"] = ours / theirs;
  state.counters["per_corner"] = ours / dirty / (theirs / theirDirty);
  setThreadCount(0);
}

void duplicate(benchmark::State& state) {
  Clay clay;
  for (int n = 0; n < 100'000; ++n) {
    Ref<CornerBlock<8>> block(new CornerBlock<8>);
    block->value.fill(0.5f);
    block->value[7] = 0.25f;
    clay.tree.put({n / 2500, n / 50 % 50, n % 50}, CornerBlock<8>::canonical(block));
  }
  // The whole of it: copy of the tree, bounds, pivot.
  double best = 1e9;
  for (auto _ : state) {
    const double start = workload::seconds();
    const auto tool = std::make_unique<Sculpture>(clay);
    const double passed = workload::seconds() - start;
    state.SetIterationTime(passed);
    best = std::min(best, passed);
  }
  state.counters["best_ms"] = 1000 * best;
}

void add(const char* name, const Job& job) {
  benchmark::RegisterBenchmark(name, freeform, job)
      ->Arg(8)
      ->Arg(16)
      ->Arg(32)
      ->Arg(64)
      ->Iterations(3)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

void addAll() {
  const glm::dquat straight(1, 0, 0, 0), turned(0.83, 0.31, -0.41, 0.21);
  add("freeform_add", {ActionKind::add, straight, 1, false});
  add("freeform_add_scaled", {ActionKind::add, straight, 0.95, false});
  add("freeform_add_turned", {ActionKind::add, turned, 1, false});
  add("freeform_remove", {ActionKind::remove, straight, 1, false});
  add("freeform_remove_turned", {ActionKind::remove, turned, 1, false});
  add("freeform_stamp", {ActionKind::stamp, straight, 1, false});
  add("freeform_stamp_conserving", {ActionKind::stamp, straight, 1, true});
  benchmark::RegisterBenchmark("duplicate_100000_blocks", duplicate)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace bozzetto

int main(int count, char** arguments) {
  bozzetto::addAll();
  benchmark::Initialize(&count, arguments);
  benchmark::RunSpecifiedBenchmarks();
}
