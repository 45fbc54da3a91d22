// Surface refresh after a dab, and full extraction. Each row prints a hash of what it made.
#include <benchmark/benchmark.h>

#include <time.h>

#include <chrono>
#include <cmath>

#include "bozzetto/base/hash.hpp"
#include "bozzetto/base/parallel.hpp"
#include "bozzetto/surface/surface.hpp"

namespace bozzetto {
namespace {

constexpr double kBall = 256;
constexpr int kDabs = 50;

// Fills blocks of `low`…`high` from value(i, j, k); uniform ones become interned runs. skip(key)
// says which blocks are surely full, surely empty, or to be filled corner by corner.
enum class Content { empty, full, mixed };

template <class Value, class Skip>
Clay clayFrom(std::int32_t low, std::int32_t high, Value&& value, Skip&& skip) {
  Clay clay;
  Edit<Clay::Block> edit(clay.tree);
  const auto full = Clay::Block::uniform(1, packAttributes({}));
  for (std::int32_t i = low; i <= high; ++i)
    for (std::int32_t j = low; j <= high; ++j)
      for (std::int32_t k = low; k <= high; ++k) {
        const Content content = skip(Key{i, j, k});
        if (content == Content::full) edit.replace({{i, j, k}, 1}, full);
        if (content != Content::mixed) continue;
        Clay::Block& block = edit.write({i, j, k});
        for (int n = 0; n < 512; ++n)
          block.value[n] = value(i * 8 + (n >> 6), j * 8 + (n >> 3 & 7), k * 8 + (n & 7));
        block.attributes.fill(packAttributes({}));
      }
  edit.commit();
  return clay;
}

Clay solidBall() {
  const auto blocks = static_cast<std::int32_t>(kBall / 8) + 1;
  const auto distance = [](double x, double y, double z) {
    return std::sqrt(x * x + y * y + z * z);
  };
  return clayFrom(
      -blocks, blocks,
      [&](int i, int j, int k) {
        return static_cast<float>(std::clamp(0.5 + (kBall - distance(i, j, k)) / 3, 0.0, 1.0));
      },
      [&](Key b) {
        const double d = distance(b.i * 8 + 3.5, b.j * 8 + 3.5, b.k * 8 + 3.5) - kBall;
        return d > 9 ? Content::empty : d < -9 ? Content::full : Content::mixed;
      });
}

Clay gyroid(int size) {
  const double scale = 2 * 3.14159265358979 / 32;
  return clayFrom(
      0, size / 8 - 1,
      [scale](int i, int j, int k) {
        const double x = i * scale, y = j * scale, z = k * scale;
        const double g =
            std::sin(x) * std::cos(y) + std::sin(y) * std::cos(z) + std::sin(z) * std::cos(x);
        return static_cast<float>(std::clamp(0.5 + g, 0.0, 1.0));
      },
      [](Key) { return Content::mixed; });
}

struct Point {
  double x, y, z;
};

// Dab centres on a tilted great circle, a quarter radius apart.
std::vector<Point> stroke(double radius) {
  const double lengthU = std::sqrt(1 + 0.04 + 0.01);
  const Point u{1 / lengthU, 0.2 / lengthU, 0.1 / lengthU};
  const double along = -0.3 * u.x + u.y + 0.4 * u.z;
  Point v{-0.3 - along * u.x, 1 - along * u.y, 0.4 - along * u.z};
  const double lengthV = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  v = {v.x / lengthV, v.y / lengthV, v.z / lengthV};
  std::vector<Point> centres;
  for (int n = 0; n < kDabs; ++n) {
    const double angle = n * radius / 4 / kBall, c = kBall * std::cos(angle),
                 s = kBall * std::sin(angle);
    centres.push_back({c * u.x + s * v.x, c * u.y + s * v.y, c * u.z + s * v.z});
  }
  return centres;
}

void addTo(Clay::Block& block, Key first, Point centre, double radius) {
  for (int n = 0; n < 512; ++n) {
    const double x = first.i + (n >> 6) - centre.x, y = first.j + (n >> 3 & 7) - centre.y,
                 z = first.k + (n & 7) - centre.z;
    const double u = (x * x + y * y + z * z) / (radius * radius);
    if (u >= 1) continue;
    const double potential = 1 + u * (-22.0 / 9 + u * (17.0 / 9 - u * 4.0 / 9));
    block.value[n] = std::min(1.0f, block.value[n] + static_cast<float>(0.5 * potential));
    block.attributes[n] = packAttributes({200, 100, 60});
  }
}

// Wyvill add, strength one half. Full blocks stay as they are.
Delta<Clay::Block> dab(Clay& clay, Point centre, double radius) {
  const auto block = [](double x) { return static_cast<std::int32_t>(std::floor(x / 8)); };
  const Key low{block(centre.x - radius), block(centre.y - radius), block(centre.z - radius)};
  const Key high{block(centre.x + radius), block(centre.y + radius), block(centre.z + radius)};
  const auto far = [](double c, std::int32_t b) {
    const double lowest = b * 8, highest = b * 8 + 7;
    return c < lowest ? lowest - c : c > highest ? c - highest : 0.0;
  };
  Edit<Clay::Block> edit(clay.tree);
  for (std::int32_t i = low.i; i <= high.i; ++i)
    for (std::int32_t j = low.j; j <= high.j; ++j)
      for (std::int32_t k = low.k; k <= high.k; ++k) {
        const double x = far(centre.x, i), y = far(centre.y, j), z = far(centre.z, k);
        if (x * x + y * y + z * z >= radius * radius) continue;
        const Clay::Block* old = edit.read({i, j, k});
        if (old != nullptr && old->low >= 1) continue;
        addTo(edit.write({i, j, k}), Key{i, j, k} * 8, centre, radius);
      }
  return edit.commit();
}

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

double seconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

// What this thread itself worked: the figure to trust where other programs run beside.
double threadSeconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

const Clay& ball() {
  static const Clay clay = solidBall();
  return clay;
}

struct StrokeSums {
  double refresh = 0, worst = 0, work = 0;
  std::size_t dirty = 0, examined = 0, meshed = 0, changed = 0, triangles = 0;
};

// One stroke on the ball, undone again afterwards; time of the refreshes alone.
StrokeSums strokeOnce(Clay& clay, Surface<8>& surface, double radius, std::string* hash) {
  StrokeSums sums;
  std::vector<Delta<Clay::Block>> deltas;
  for (const Point& centre : stroke(radius)) {
    deltas.push_back(dab(clay, centre, radius));
    const double start = seconds(), startWork = threadSeconds();
    const RefreshReport report = surface.refresh(clay, deltas.back());
    const double took = seconds() - start;
    sums.work += threadSeconds() - startWork;
    sums.refresh += took;
    sums.worst = std::max(sums.worst, took);
    sums.dirty += deltas.back().changes.size();
    sums.examined += report.examined;
    sums.meshed += report.meshed;
    sums.changed += report.changed.size();
    sums.triangles += report.triangles;
  }
  if (hash->empty()) *hash = hashOf(surface);
  for (auto delta = deltas.rbegin(); delta != deltas.rend(); ++delta) {
    delta->apply(clay.tree, Direction::backward);
    surface.refresh(clay, *delta);
  }
  return sums;
}

void refreshPerDab(benchmark::State& state) {
  const auto radius = static_cast<double>(state.range(0));
  setThreadCount(static_cast<int>(state.range(1)));
  Clay clay = ball();
  Surface<8> surface;
  surface.rebuild(clay);
  std::string hash;
  StrokeSums sums;
  double leastWork = 1e9;
  for (auto _ : state) {
    sums = strokeOnce(clay, surface, radius, &hash);
    leastWork = std::min(leastWork, sums.work);
    state.SetIterationTime(sums.refresh / kDabs);
  }
  state.counters["thread_ms"] = leastWork / kDabs * 1e3;
  const auto perDab = [](std::size_t n) { return static_cast<double>(n) / kDabs; };
  state.counters["worst_ms"] = sums.worst * 1e3;
  state.counters["dirty"] = perDab(sums.dirty);
  state.counters["examined"] = perDab(sums.examined);
  state.counters["meshed"] = perDab(sums.meshed);
  state.counters["changed"] = perDab(sums.changed);
  state.counters["triangles"] = perDab(sums.triangles);
  state.SetLabel(hash);
}
BENCHMARK(refreshPerDab)
    ->ArgNames({"radius", "threads"})
    ->ArgsProduct({{8, 16, 32, 64, 128}, {1, 2}})
    ->UseManualTime()
    ->MinTime(0.02)
    ->Repetitions(3)
    ->ReportAggregatesOnly()
    ->Unit(benchmark::kMillisecond);

void extract(benchmark::State& state, const Clay& clay) {
  setThreadCount(static_cast<int>(state.range(0)));
  Surface<8> surface;
  surface.rebuild(clay);  // touches the memory; extractBallCold times that
  for (auto _ : state) surface.rebuild(clay);
  const auto triangles = static_cast<double>(surface.totals().triangles);
  state.counters["triangles"] = triangles;
  state.counters["MiB"] = static_cast<double>(surface.bytes()) / (1 << 20);
  state.counters["Mtri/s"] = benchmark::Counter(
      triangles * 1e-6 * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
  state.SetLabel(hashOf(surface));
}

void extractBall(benchmark::State& state) { extract(state, ball()); }
void extractGyroid(benchmark::State& state) {
  static const Clay clay = gyroid(256);
  extract(state, clay);
}
BENCHMARK(extractBall)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(extractGyroid)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

// What a single extraction costs whose memory was never touched before.
void extractBallCold(benchmark::State& state) {
  setThreadCount(static_cast<int>(state.range(0)));
  std::vector<Surface<8>> kept;
  for (auto _ : state) {
    kept.emplace_back();
    kept.back().rebuild(ball());
  }
}
BENCHMARK(extractBallCold)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->Iterations(3)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bozzetto

BENCHMARK_MAIN();
