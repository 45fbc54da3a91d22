// Surface refresh after a dab, as a Sculptor does it (what changed under the dab, then the
// refresh), and full extraction of the ball and of the dense gyroid.
#include <benchmark/benchmark.h>

#include <span>
#include <utility>
#include <vector>

#include "bozzetto/surface/surface.hpp"
#include "rows.hpp"
#include "scenes.hpp"
#include "strokes.hpp"

namespace bozzetto {
namespace {

std::string hashOf(const Surface<8>& surface) {
  Hasher hasher;
  for (const auto& [key, run] : surface.patches()) {
    const PatchContent content = run.block->content();
    hasher.add(std::as_bytes(std::span(&key, 1)));
    hasher.add(std::as_bytes(content.vertices));
    hasher.add(std::as_bytes(content.indices));
  }
  return hexDigits(hasher.result());
}

// Clay with its surface.
struct Shown {
  explicit Shown(Clay content) : clay(std::move(content)) { surface.rebuild(clay); }

  Clay clay;
  Surface<8> surface;
};

// Sums over the dabs of one or more strokes.
struct Sums {
  double seconds = 0, slowest = 0, dabs = 0;
  std::size_t examined = 0, meshed = 0, triangles = 0;
};

void addTo(Sums& sums, double seconds, const RefreshReport& report) {
  sums.seconds += seconds;
  sums.slowest = std::max(sums.slowest, seconds);
  sums.dabs += 1;
  sums.examined += report.examined;
  sums.meshed += report.meshed;
  sums.triangles += report.triangles;
}

// One stroke; returns the seconds of its refreshes alone. `after` sees the stroke's end, then it
// is taken back.
template <class After>
double strokeOnce(Shown& shown, double radius, Sums& sums, After after) {
  Edit<Clay::Block> edit(shown.clay.tree);
  StrokeRunner<8> runner(edit, shown.clay.scale, strokes::toolOf(radius),
                         strokes::actionOf(ActionKind::add), strokes::onBall(radius));
  const double before = sums.seconds;
  for (std::int64_t n = 0; n < runner.dabCount(); ++n) {
    const DabReport dab = runner.dab(n);
    const double start = workload::seconds();
    const RefreshReport report = shown.surface.refresh(shown.clay, dab.changed);
    addTo(sums, workload::seconds() - start, report);
  }
  after();
  const Delta<Clay::Block> delta = edit.commit();
  delta.apply(shown.clay.tree, Direction::backward);
  shown.surface.refresh(shown.clay, delta);
  return sums.seconds - before;
}

Clay& ball() {
  static Clay clay = scenes::ball<8>();
  return clay;
}

void refresh(benchmark::State& state, double radius, int threads) {
  static Shown shown(ball());
  setThreadCount(threads);
  Sums sums;
  for (auto _ : state) {
    const auto label = [&] {
      if (state.iterations() == 0) state.SetLabel(hashOf(shown.surface));
    };
    state.SetIterationTime(strokeOnce(shown, radius, sums, label) / workload::kDabs);
  }
  state.counters["examined"] = static_cast<double>(sums.examined) / sums.dabs;
  state.counters["meshed"] = static_cast<double>(sums.meshed) / sums.dabs;
  state.counters["triangles"] = static_cast<double>(sums.triangles) / sums.dabs;
  state.counters["worst_ms"] = sums.slowest * 1e3;
  setThreadCount(0);
}

// The dense cube of workload.hpp; its surface at ½.
Clay gyroid() {
  Clay clay;
  Edit<Clay::Block> edit(clay.tree);
  constexpr int kBlocks = workload::kGyroidSide / 8;
  for (int n = 0; n < kBlocks * kBlocks * kBlocks; ++n) {
    const Key key{n / kBlocks / kBlocks, n / kBlocks % kBlocks, n % kBlocks};
    Clay::Block& block = edit.write(key);
    for (int c = 0; c < Clay::Block::kCount; ++c) {
      const Key corner = key * 8 + Key{c / 64, c / 8 % 8, c % 8};
      const float value = 0.5f + workload::gyroid(corner.i, corner.j, corner.k) / 3.2f;
      block.value[c] = value;
      block.attributes[c] = scenes::kClay;
    }
    block.updateRange();
  }
  edit.commit();
  return clay;
}

// Warm memory was touched by an extraction before, as in an editor; cold never, as in a program
// that extracts once.
enum class Memory { warm, cold };

void extract(benchmark::State& state, Clay& (*scene)(), Memory memory, int threads) {
  const Clay& clay = scene();
  setThreadCount(threads);
  std::vector<Surface<8>> kept;  // what holds its memory, so that nobody gets it again
  Surface<8> surface;
  surface.rebuild(clay);
  for (auto _ : state) {
    if (memory == Memory::cold) kept.push_back(std::exchange(surface, {}));
    const double start = workload::seconds();
    surface.rebuild(clay);
    state.SetIterationTime(workload::seconds() - start);
  }
  const auto triangles = static_cast<double>(surface.totals().triangles);
  state.counters["triangles"] = triangles;
  state.counters["vertices"] = static_cast<double>(surface.totals().edges);
  state.counters["bytes"] = static_cast<double>(surface.bytes());
  state.SetLabel(hashOf(surface));
  setThreadCount(0);
}

Clay& gyroidClay() {
  static Clay clay = gyroid();
  return clay;
}

void addAll() {
  for (const int threads : {1, 2}) {
    const std::string ending = "/side:8/threads:" + std::to_string(threads);
    for (const double radius : workload::kRadii) {
      rows::add(rows::nameOf("refresh", radius, 8, threads), refresh, radius, threads);
    }
    rows::add("extract_ball" + ending, extract, ball, Memory::warm, threads);
    rows::add("extract_ball_cold" + ending, extract, ball, Memory::cold, threads);
    rows::add("extract_gyroid" + ending, extract, gyroidClay, Memory::warm, threads);
    rows::add("extract_gyroid_cold" + ending, extract, gyroidClay, Memory::cold, threads);
  }
}

}  // namespace
}  // namespace bozzetto

int main(int count, char** arguments) {
  return bozzetto::rows::run(bozzetto::addAll, count, arguments);
}
