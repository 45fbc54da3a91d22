// History: what the end of a stroke costs the one who sculpts, what a step costs on the disk, undo
// from the disk, depth, recovery.
#include <time.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "bozzetto/history/recovery.hpp"
#include "bozzetto/tool/stroke.hpp"
#include "history/undo_file.hpp"
#include "rows.hpp"
#include "scenes.hpp"
#include "strokes.hpp"

namespace bozzetto {
namespace {

namespace fs = std::filesystem;
using Block = CornerBlock<8>;
using DeltaPointer = std::shared_ptr<const Delta<Block>>;

constexpr HistoryIdentity kIdentity{1};

class ScratchFolder {
 public:
  ScratchFolder()
      : path_(fs::temp_directory_path() / ("bozzetto_bench_" + std::to_string(getpid()))) {
    fs::create_directory(path_);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  OpenedHistory<8> open(const Clay& clay, std::size_t steps = 0) const {
    HistoryLimits limits;
    limits.steps = steps;
    return openHistory<8>({path_ / "history", kIdentity}, SavedScene<8>{clay, kUnknownPlace},
                          HistoryAccess::write, limits);
  }

 private:
  fs::path path_;
};

const Clay& ballOnce() {
  static const Clay clay = scenes::ball<8>();
  return clay;
}

DeltaPointer strokeOn(Clay& clay, double radius, ActionKind kind) {
  Edit<Block> edit(clay.tree);
  StrokeRunner<8> runner(edit, clay.scale, strokes::toolOf(radius), strokes::actionOf(kind),
                         strokes::onBall(radius));
  applyStroke(runner);
  return std::make_shared<const Delta<Block>>(edit.commit());
}

// Of the calling thread's processor: what others on the machine take does not count.
double ownSeconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// What the caller waits for at the end of a stroke; the slowest is a counter.
void handOver(benchmark::State& state, double radius) {
  const ScratchFolder folder;
  Clay clay = ballOnce();
  auto opened = folder.open(clay);
  double slowest = 0, own = 0;
  for (auto _ : state) {
    DeltaPointer delta = strokeOn(clay, radius, ActionKind::add);
    const double start = workload::seconds(), ownStart = ownSeconds();
    opened.history.push(delta, {"stroke", clay.scale, clay.scale});
    const double seconds = workload::seconds() - start;
    own = std::max(own, ownSeconds() - ownStart);
    slowest = std::max(slowest, seconds);
    state.SetIterationTime(seconds);
    opened.history.waitDurable();
    opened.history.goTo(0, clay.tree, clay.scale);
  }
  state.counters["slowest_ms"] = 1e3 * slowest;
  state.counters["slowest_cpu_ms"] = 1e3 * own;
}

// Packing and compressing on one thread, and what comes out.
void packStroke(benchmark::State& state, double radius, ActionKind kind) {
  setThreadCount(1);
  Clay clay = ballOnce();
  const DeltaPointer delta = strokeOn(clay, radius, kind);
  undo::FileHead head;
  for (auto _ : state) {
    const double start = workload::seconds();
    benchmark::DoNotOptimize(undo::encodeUndoFile<8>(head, *delta));
    state.SetIterationTime(workload::seconds() - start);
  }
  state.counters["blocks"] = static_cast<double>(delta->changes.size());
  state.counters["bytes"] = static_cast<double>(head.fileBytes);
  state.counters["bytes_per_corner"] =
      static_cast<double>(head.fileBytes) / static_cast<double>(head.step.changedCorners);
  setThreadCount(0);
}

void unpackStroke(benchmark::State& state, double radius, int threads) {
  setThreadCount(threads);
  Clay clay = ballOnce();
  const DeltaPointer delta = strokeOn(clay, radius, ActionKind::add);
  undo::FileHead head;
  head.step.number = 1;
  const Bytes bytes = undo::encodeUndoFile<8>(head, *delta);
  for (auto _ : state) {
    const double start = workload::seconds();
    const undo::UndoFile<8> file(bytes, "");
    benchmark::DoNotOptimize(file.unpack(clay.tree, Direction::backward));
    state.SetIterationTime(workload::seconds() - start);
  }
  setThreadCount(0);
}

double residentMegabytes() {
  std::ifstream file("/proc/self/statm");
  double total = 0, resident = 0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

// Small steps without end, in memory where there is no disk to wait for.
void depth(benchmark::State& state, int steps) {
  for (auto _ : state) {
    const ScratchFolder folder;
    Clay clay = scenes::ball<8>(16);
    auto opened = folder.open(clay);
    const double before = residentMegabytes(), start = workload::seconds();
    for (int n = 0; n < steps; ++n) {
      Edit<Block> edit(clay.tree);
      edit.write({n % 7, 0, 0}).value[n % 512] = static_cast<float>(n % 100) / 100;
      opened.history.push(std::make_shared<const Delta<Block>>(edit.commit()),
                          {"stroke", clay.scale, clay.scale});
      if (n % 64 == 0) opened.history.waitDurable();
    }
    opened.history.waitDurable();
    state.SetIterationTime(workload::seconds() - start);
    state.counters["resident_mb"] = residentMegabytes() - before;
    state.counters["held_mb"] = static_cast<double>(opened.history.memoryBytes()) / 1e6;
  }
}

// A document that was never saved: all its clay from a checkpoint.
void recoverCheckpoint(benchmark::State& state, int threads) {
  setThreadCount(threads);
  const Clay clay = scenes::ball<8>(512);
  undo::FileHead head;
  head.step.number = 1;
  undo::CheckpointWriter<8> writer(head, clay.tree);
  Bytes bytes;
  double written = 0;
  for (Bytes part(1);;) {
    const double start = workload::seconds();
    part = writer.next();
    written += workload::seconds() - start;
    if (part.empty()) break;
    bytes.insert(bytes.end(), part.begin(), part.end());
  }
  const FieldStatistics matter = statistics(clay);
  for (auto _ : state) {
    const double start = workload::seconds();
    const auto tree = undo::UndoFile<8>(bytes, "").tree();
    state.SetIterationTime(workload::seconds() - start);
    benchmark::DoNotOptimize(tree.nodeCount());
  }
  state.counters["blocks"] = static_cast<double>(matter.blocks);
  state.counters["file_mb"] = static_cast<double>(bytes.size()) / 1e6;
  state.counters["write_s"] = written;
  setThreadCount(0);
}

void addAll() {
  for (const double radius : {32.0, 128.0}) {
    rows::add("hand_over/radius:" + std::to_string(int(radius)), handOver, radius)->Iterations(8);
  }
  const std::pair<const char*, ActionKind> kinds[] = {{"add", ActionKind::add},
                                                      {"remove", ActionKind::remove},
                                                      {"smooth", ActionKind::smooth},
                                                      {"paint", ActionKind::paint},
                                                      {"paint_soft", ActionKind::paintSoft}};
  for (const auto& [name, kind] : kinds) {
    rows::add(std::string("pack/") + name + "/radius:32", packStroke, 32.0, kind);
  }
  for (const int threads : {1, 2}) {
    rows::add(rows::nameOf("unpack", 32, 8, threads), unpackStroke, 32.0, threads);
    rows::add("recover_checkpoint/threads:" + std::to_string(threads), recoverCheckpoint, threads)
        ->Iterations(2);
  }
  rows::add("depth/steps:100000", depth, 100'000)->Iterations(1);
}

}  // namespace
}  // namespace bozzetto

int main(int count, char** arguments) {
  return bozzetto::rows::run(bozzetto::addAll, count, arguments);
}
