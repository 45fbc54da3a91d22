// What a person waits for: whole dabs (field, surface, undo), on the ball, in empty and in crowded
// scenes; and what the clay weighs.
#include <benchmark/benchmark.h>

#include <fstream>
#include <map>
#include <span>

#include "bozzetto/history/history.hpp"
#include "bozzetto/surface/surface.hpp"
#include "bozzetto/tool/fill.hpp"
#include "rows.hpp"
#include "scenes.hpp"
#include "strokes.hpp"

namespace bozzetto {
namespace {

double secondsSince(double start) { return workload::seconds() - start; }

// A field with its surface and history, as the Sculptor keeps them.
template <int Side>
struct Studio {
  using Block = CornerBlock<Side>;

  explicit Studio(Field<Side> content) : field(std::move(content)) { surface.rebuild(field); }

  Field<Side> field;
  Surface<Side> surface;
  History<Side> undo;

  // The sums of a stroke.
  struct Counts {
    DabReport dabs;
    std::size_t examined = 0, meshed = 0;
    std::int64_t treated = 0;
    double slowest = 0;  // dab, seconds
  };

  // Stands still while counts are taken that no program needs.
  double seconds() const { return workload::seconds() - counting; }
  double counting = 0;

  RefreshReport refresh(std::span<const ChangedRun> changed, Counts& counts) {
    RefreshReport report = surface.refresh(field, changed);
    const double start = workload::seconds();
    counts.treated += treatedCubes<Side>(changed);
    counting += workload::seconds() - start;
    return report;
  }

  // One stroke with a refresh after every dab and one undo step; returns its seconds.
  double stroke(const ToolShape& tool, const ActionOptions& action, const Stroke& path,
                Counts& counts) {
    const double start = seconds();
    Edit<Block> edit(field.tree);
    StrokeRunner<Side> runner(edit, field.scale, tool, action, path);
    for (std::int64_t n = 0; n < runner.dabCount(); ++n) {
      const double dabStart = seconds();
      const DabReport dab = runner.dab(n);
      const RefreshReport refreshed = refresh(dab.changed, counts);
      counts.slowest = std::max(counts.slowest, seconds() - dabStart);
      counts.dabs.visited += dab.visited;
      counts.dabs.computed += dab.computed;
      counts.dabs.dirty += dab.dirty;
      counts.examined += refreshed.examined;
      counts.meshed += refreshed.meshed;
    }
    undo.push(std::make_shared<const Delta<Block>>(edit.commit()), {"stroke", {}, {}});
    return seconds() - start;
  }

  void takeBack() {
    goTo(0);
    undo = History<Side>();
  }

  void goTo(StepNumber state) {
    surface.refresh(field, *undo.goTo(state, field.tree, field.scale).delta);
  }
};

enum class Ground { ball, empty, crowded };

// Scenes are made once: benchmarks undo what they do.
template <int Side>
Studio<Side>& studioOf(Ground ground) {
  static std::map<Ground, Studio<Side>> studios;
  const auto found = studios.find(ground);
  if (found != studios.end()) return found->second;
  Field<Side> field;
  if (ground == Ground::ball) field = scenes::ball<Side>();
  if (ground == Ground::crowded) scenes::crowd(field);
  return studios.try_emplace(ground, std::move(field)).first->second;
}

template <int Side>
void report(benchmark::State& state, const typename Studio<Side>::Counts& counts, double dabs) {
  state.counters["visited"] = static_cast<double>(counts.dabs.visited) / dabs;
  state.counters["computed"] = static_cast<double>(counts.dabs.computed) / dabs;
  state.counters["dirty"] = static_cast<double>(counts.dabs.dirty) / dabs;
  state.counters["treated"] = static_cast<double>(counts.treated) / dabs;
  state.counters["blocks_examined"] = static_cast<double>(counts.examined) / dabs;
  state.counters["blocks_meshed"] = static_cast<double>(counts.meshed) / dabs;
  state.counters["worst_ms"] = counts.slowest * 1e3;
}

// What is done, and where.
struct Job {
  Ground ground;
  ActionKind kind;
  Colour colour;
};

// Time is per dab, undo included, the way back not.
template <int Side>
void wholeDab(benchmark::State& state, const Job& job, double radius, int threads) {
  setThreadCount(threads);
  Studio<Side>& studio = studioOf<Side>(job.ground);
  const Stroke path = strokes::onBall(radius);
  const ActionOptions action{job.kind, workload::kStrength, job.colour};
  typename Studio<Side>::Counts counts;
  double dabs = 0;
  std::string hash;
  for (auto _ : state) {
    state.SetIterationTime(studio.stroke(strokes::toolOf(radius), action, path, counts) /
                           workload::kDabs);
    dabs += workload::kDabs;
    if (hash.empty()) hash = scenes::hashOf(studio.field);
    studio.takeBack();
  }
  report<Side>(state, counts, dabs);
  state.SetLabel(hash);
  setThreadCount(0);
}

// Undo and redo of a whole stroke, surface included; time is of both halves' mean.
void undoStroke(benchmark::State& state, double radius, int threads) {
  setThreadCount(threads);
  Studio<8>& studio = studioOf<8>(Ground::ball);
  Studio<8>::Counts counts;
  studio.stroke(strokes::toolOf(radius), strokes::actionOf(ActionKind::add),
                strokes::onBall(radius), counts);
  for (auto _ : state) {
    const double start = studio.seconds();
    studio.goTo(0);
    studio.goTo(1);
    state.SetIterationTime((studio.seconds() - start) / 2);
  }
  state.SetLabel(scenes::hashOf(studio.field));
  studio.takeBack();
  setThreadCount(0);
}

template <int Side>
double cornersOfSurface(const Field<Side>& field) {
  double count = 0;
  for (const auto& [key, run] : field.tree) {
    const auto& values = run.block->value;
    count +=
        run.length * static_cast<double>(std::count_if(values.begin(), values.end(),
                                                       [](float v) { return v > 0 && v < 1; }));
  }
  return count;
}

template <int Side>
void reportMemory(benchmark::State& state, const Field<Side>& field) {
  const FieldStatistics known = statistics(field);
  const auto bytes = static_cast<double>(known.bytes);
  const double stored = static_cast<double>(known.blocks) * BlockGeometry<Side>::kCount;
  const double surface = cornersOfSurface(field);
  state.counters["bytes"] = bytes;
  state.counters["bytes_without_colour"] = bytes - 4 * stored;
  state.counters["blocks"] = static_cast<double>(known.blocks);
  state.counters["nodes"] = static_cast<double>(known.nodes);
  state.counters["corners_stored"] = stored;
  state.counters["surface_corners"] = surface;
  state.counters["bytes_per_surface_corner"] = bytes / surface;
  state.SetLabel(scenes::hashOf(field));
}

void memoryBall(benchmark::State& state) {
  Studio<8>& studio = studioOf<8>(Ground::ball);
  for (auto _ : state) {
    const double start = workload::seconds();
    benchmark::DoNotOptimize(statistics(studio.field));
    state.SetIterationTime(secondsSince(start));
  }
  reportMemory(state, studio.field);
  state.counters["surface_bytes"] = static_cast<double>(studio.surface.bytes());
}

// A solid ball made at once: the inside must cost no corners.
void solid(benchmark::State& state, double radius) {
  for (auto _ : state) {
    Clay clay;
    Edit<CornerBlock<8>> edit(clay.tree);
    Primitive primitive;
    primitive.radii = {radius, radius, radius};
    const auto start = workload::seconds();
    fill(edit, clay.scale, primitive);
    edit.commit();
    state.SetIterationTime(secondsSince(start));
    reportMemory(state, clay);
  }
}

constexpr Colour kSame = colourOf(scenes::kClay), kOther{200, 100, 60};

template <int Side>
void addDabs(double radius, int threads) {
  const auto one = [&](const std::string& name, Ground ground, ActionKind kind, Colour colour) {
    rows::add(rows::nameOf(name, radius, Side, threads), wholeDab<Side>, Job{ground, kind, colour},
              radius, threads);
  };
  one("whole_dab", Ground::ball, ActionKind::add, kSame);
  one("whole_dab_tinted", Ground::ball, ActionKind::add, kOther);
  one("whole_remove", Ground::ball, ActionKind::remove, kSame);
  one("whole_smooth", Ground::ball, ActionKind::smooth, kSame);
  one("dab_lonely", Ground::empty, ActionKind::add, kSame);
  one("dab_crowded", Ground::crowded, ActionKind::add, kSame);
}

// Gigabytes that are free; the largest solid needs them.
double freeGigabytes() {
  std::ifstream stream("/proc/meminfo");
  std::string name;
  for (double kilobytes = 0; stream >> name >> kilobytes; stream.ignore(80, '\n')) {
    if (name == "MemAvailable:") return kilobytes / (1 << 20);
  }
  return 0;
}

void addAll() {
  for (const int threads : {1, 2}) {
    for (const double radius : workload::kRadii) {
      addDabs<8>(radius, threads);
      rows::add(rows::nameOf("undo_stroke", radius, 8, threads), undoStroke, radius, threads);
    }
  }
  for (const double radius : {8.0, 16.0, 32.0}) addDabs<1>(radius, 1);  // at 64: minutes a stroke
  rows::add("memory_ball", memoryBall);
  for (const double radius : {500.0, 2000.0}) {
    if (radius > 1000 && freeGigabytes() < 14) continue;
    const std::string name = "solid/radius:" + std::to_string(static_cast<int>(radius));
    rows::add(name, solid, radius)->Iterations(1)->Repetitions(1);
  }
}

}  // namespace
}  // namespace bozzetto

int main(int count, char** arguments) {
  return bozzetto::rows::run(bozzetto::addAll, count, arguments);
}
