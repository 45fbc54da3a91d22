// Through the one door: a stroke handed to a Sculptor as a window does it, and whole recordings.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "bozzetto/sculptor/replay.hpp"
#include "rows.hpp"
#include "scenes.hpp"
#include "strokes.hpp"

namespace bozzetto {
namespace {

namespace fs = std::filesystem;

// Made once: benchmarks undo what they do.
Sculptor& sculptorOfBall() {
  static Sculptor sculptor(scenes::ball<8>(), SurfaceUpkeep::afterEachDab);
  return sculptor;
}

// Per dab; field, surface, counts and history of a stroke that is shown after every dab.
void stroke(benchmark::State& state, double radius, int threads) {
  setThreadCount(threads);
  Sculptor& sculptor = sculptorOfBall();
  sculptor.apply(ToolOperation{strokes::toolOf(radius)});
  sculptor.apply(ActionOperation{strokes::actionOf(ActionKind::add)});
  const StrokeOperation operation{strokes::onBall(radius)};
  OperationReport sum;
  double strokes = 0;
  for (auto _ : state) {
    const double start = workload::seconds();
    const OperationReport report = sculptor.apply(operation);
    state.SetIterationTime((workload::seconds() - start) / static_cast<double>(report.dabs));
    if (strokes++ == 0) state.SetLabel(scenes::hashOf(sculptor.field()));
    sum.msField += report.msField;
    sum.msSurface += report.msSurface;
    sum.msHistory += report.msHistory;
    sum.treated += report.treated;
    sculptor.apply(UndoOperation{1});
  }
  const double dabs = strokes * workload::kDabs;
  state.counters["ms_field"] = sum.msField / dabs;
  state.counters["ms_surface"] = sum.msSurface / dabs;
  state.counters["ms_history"] = sum.msHistory / dabs;
  state.counters["treated"] = static_cast<double>(sum.treated) / dabs;
  setThreadCount(0);
}

void replayFile(benchmark::State& state, const fs::path& path, SurfaceUpkeep upkeep, int threads) {
  setThreadCount(threads);
  const Recording recording = readRecording(path);
  OperationReport total;
  for (auto _ : state) {
    ReplayOptions options;
    options.upkeep = upkeep;
    const double start = workload::seconds();
    const ReplayResult result = replay(recording, {}, options);
    state.SetIterationTime(workload::seconds() - start);
    state.SetLabel(scenes::hashOf(result.field));
    total = totalOf(result.reports);
  }
  state.counters["operations"] = static_cast<double>(recording.operations.size());
  state.counters["dabs"] = static_cast<double>(total.dabs);
  state.counters["visited"] = static_cast<double>(total.visited);
  state.counters["computed"] = static_cast<double>(total.computed);
  state.counters["dirty"] = static_cast<double>(total.dirty);
  state.counters["treated"] = static_cast<double>(total.treated);
  setThreadCount(0);
}

std::vector<fs::path> sampleRecordings() {
  std::vector<fs::path> found;
  const fs::path folder = fs::path(BOZZETTO_SOURCE_DIR) / "data/recordings";
  if (!fs::is_directory(folder)) return found;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".jsonl") found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

void addAll() {
  for (const int threads : {1, 2}) {
    const std::string ending = "/threads:" + std::to_string(threads);
    for (const double radius : workload::kRadii) {
      const std::string size = "/radius:" + std::to_string(static_cast<int>(radius)) + "/side:8";
      rows::add("sculptor_dab" + size + ending, stroke, radius, threads);
    }
    for (const fs::path& path : sampleRecordings()) {
      const std::string name = path.stem().string() + ending;
      rows::add("replay/" + name, replayFile, path, SurfaceUpkeep::none, threads);
      rows::add("replay_shown/" + name, replayFile, path, SurfaceUpkeep::afterEachDab, threads);
    }
  }
}

}  // namespace
}  // namespace bozzetto

int main(int count, char** arguments) {
  return bozzetto::rows::run(bozzetto::addAll, count, arguments);
}
