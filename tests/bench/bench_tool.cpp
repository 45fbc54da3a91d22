// The brush kernel alone: a stroke of 50 dabs on the ball, field and copy-on-write only. Time is
// per dab; closing the edit (the delta that undo keeps) is the counter commit_ms, per dab too.
#include <benchmark/benchmark.h>

#include "bozzetto/tool/stroke.hpp"
#include "rows.hpp"
#include "scenes.hpp"

namespace bozzetto {
namespace {

double secondsSince(double start) { return workload::seconds() - start; }

struct Job {
  ActionKind kind;
  Colour colour;
  double radius;
  int threads;
};

constexpr Colour kSame = colourOf(scenes::kClay), kOther{200, 100, 60};

Stroke strokeOn(double radius) {
  Stroke stroke;
  for (const workload::Point& p : workload::stroke(radius))
    stroke.points.push_back({{p[0], p[1], p[2]}, 1});
  stroke.spacing = 0.25 * (1 - 1e-3);  // a dab at each point, none in between
  return stroke;
}

ToolShape toolOf(double radius) {
  ToolShape tool;
  tool.radii = {radius, radius, radius};
  return tool;
}

template <int Side>
Field<Side>& ball() {
  static Field<Side> field = scenes::ball<Side>();
  return field;
}

template <int Side>
void dab(benchmark::State& state, const Job& job) {
  setThreadCount(job.threads);
  Field<Side>& field = ball<Side>();
  const Stroke path = strokeOn(job.radius);
  const ActionOptions action{job.kind, workload::kStrength, job.colour};
  DabReport counts;
  double dabs = 0, committing = 0;
  std::string hash;
  for (auto _ : state) {
    Edit<CornerBlock<Side>> edit(field.tree);
    StrokeRunner<Side> runner(edit, field.scale, toolOf(job.radius), action, path);
    const double start = workload::seconds();
    for (std::int64_t n = 0; n < runner.dabCount(); ++n) {
      const DabReport dab = runner.dab(n);
      counts.visited += dab.visited;
      counts.computed += dab.computed;
      counts.dirty += dab.dirty;
    }
    state.SetIterationTime(secondsSince(start) / static_cast<double>(runner.dabCount()));
    dabs += static_cast<double>(runner.dabCount());
    const double closing = workload::seconds();
    const auto delta = edit.commit();
    committing += secondsSince(closing);
    if (hash.empty()) hash = scenes::hashOf(field);
    delta.apply(field.tree, Direction::backward);
  }
  state.counters["visited"] = static_cast<double>(counts.visited) / dabs;
  state.counters["computed"] = static_cast<double>(counts.computed) / dabs;
  state.counters["dirty"] = static_cast<double>(counts.dirty) / dabs;
  state.counters["commit_ms"] = committing * 1e3 / dabs;
  state.SetLabel(hash);
  setThreadCount(0);
}

template <int Side>
void add(const std::string& what, const Job& job) {
  rows::add(rows::nameOf(what, job.radius, Side, job.threads), dab<Side>, job)
      ->Iterations(job.radius < 64 ? 20 : 4);  // strokes of 50 dabs
}

template <int Side>
void addDabs(double radius, int threads) {
  add<Side>("dab_add", {ActionKind::add, kSame, radius, threads});
  add<Side>("dab_add_tinted", {ActionKind::add, kOther, radius, threads});
  add<Side>("dab_remove", {ActionKind::remove, kSame, radius, threads});
  add<Side>("dab_smooth", {ActionKind::smooth, kSame, radius, threads});
  add<Side>("dab_paint", {ActionKind::paintSoft, kOther, radius, threads});
}

void addAll() {
  for (const int threads : {1, 2}) {
    addDabs<8>(4, threads);
    for (const double radius : workload::kRadii) addDabs<8>(radius, threads);
  }
}

}  // namespace
}  // namespace bozzetto

int main(int count, char** arguments) {
  return bozzetto::rows::run(bozzetto::addAll, count, arguments);
}
