// Scene files of the ball: saving it whole, saving after a stroke, loading. Bytes and times stand
// against .vdb files of the same ball.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <filesystem>

#include "bozzetto/scene/scene_file.hpp"
#include "bozzetto/tool/stroke.hpp"
#include "rows.hpp"
#include "scenes.hpp"
#include "strokes.hpp"

namespace bozzetto {
namespace {

namespace fs = std::filesystem;

// A name in the temporary folder, gone at the end.
class ScratchFile {
 public:
  ScratchFile()
      : path_(fs::temp_directory_path() / ("bozzetto_bench_" + std::to_string(getpid()) + ".bzt")) {
  }
  ~ScratchFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

const Document& ballDocument() {
  static const Document document{scenes::ball<8>(), {}};
  return document;
}

void report(benchmark::State& state, const SaveReport& saved) {
  state.counters["bytes"] = static_cast<double>(saved.fileBytes);
  state.counters["bytes_written"] = static_cast<double>(saved.bytesWritten);
  state.counters["chunks_written"] = static_cast<double>(saved.chunksWritten);
}

void saveBall(benchmark::State& state, int threads) {
  setThreadCount(threads);
  const ScratchFile file;
  SaveReport saved;
  for (auto _ : state) {
    fs::remove(file.path());
    const double start = workload::seconds();
    saved = saveScene(file.path(), ballDocument());
    state.SetIterationTime(workload::seconds() - start);
  }
  report(state, saved);
  state.SetLabel(scenes::hashOf(ballDocument().field));
  setThreadCount(0);
}

void loadBall(benchmark::State& state, int threads) {
  setThreadCount(threads);
  const ScratchFile file;
  saveScene(file.path(), ballDocument());
  Document loaded;
  for (auto _ : state) {
    loaded = {};
    const double start = workload::seconds();
    loaded = loadScene(file.path());
    state.SetIterationTime(workload::seconds() - start);
  }
  state.SetLabel(scenes::hashOf(loaded.field));
  setThreadCount(0);
}

// A save after one stroke writes what the stroke touched.
void saveStroke(benchmark::State& state, double radius, int threads) {
  setThreadCount(threads);
  const ScratchFile path;
  SceneFile file;
  Document document = ballDocument();
  file.save(path.path(), document);
  SaveReport saved;
  for (auto _ : state) {
    Edit<CornerBlock<8>> edit(document.field.tree);
    StrokeRunner<8> runner(edit, document.field.scale, strokes::toolOf(radius),
                           strokes::actionOf(ActionKind::add), strokes::onBall(radius));
    applyStroke(runner);
    const auto delta = edit.commit();
    const double start = workload::seconds();
    saved = file.save(path.path(), document);
    state.SetIterationTime(workload::seconds() - start);
    delta.apply(document.field.tree, Direction::backward);
    file.save(path.path(), document);
  }
  report(state, saved);
  setThreadCount(0);
}

void addAll() {
  for (const int threads : {1, 2}) {
    const std::string ending = "/threads:" + std::to_string(threads);
    rows::add("save_ball" + ending, saveBall, threads);
    rows::add("load_ball" + ending, loadBall, threads);
    rows::add("save_stroke/radius:32" + ending, saveStroke, 32.0, threads);
  }
}

}  // namespace
}  // namespace bozzetto

int main(int count, char** arguments) {
  return bozzetto::rows::run(bozzetto::addAll, count, arguments);
}
