// Steps per second of clay, beside a plain sweep over as many cells: what memory allows.
#include <benchmark/benchmark.h>

#include "bozzetto/clay/hold.hpp"
#include "bozzetto/clay/stroke.hpp"
#include "bozzetto/tool/fill.hpp"

namespace {

using namespace bozzetto;
using clay::LayerKind;

struct Scene {
  Clay field;
  ToolShape tool;
  clay::Role role = clay::Role::push;
  Stroke stroke;
  clay::Setup setup;

  void box(glm::dvec3 centre, glm::dvec3 radii) {
    Edit<CornerBlock<8>> edit(field.tree);
    Primitive primitive;
    primitive.shape = Shape::box;
    primitive.centre = centre;
    primitive.radii = radii;
    fill<8>(edit, field.scale, primitive);
    edit.commit();
  }
  void hold(Key low, Key high) {
    Edit<CornerBlock<8>> edit(field.tree);
    clay::holdClay<8>(edit, {low, high}, 1);
    edit.commit();
  }
  void line(glm::dvec3 from, glm::dvec3 to) { stroke.points = {{from, 1}, {to, 1}}; }
};

void steps(benchmark::State& state, const Scene& scene) {
  std::int64_t done = 0, cells = 0, visited = 0;
  for (auto _ : state) {
    state.PauseTiming();
    Clay field = scene.field;
    Edit<CornerBlock<8>> edit(field.tree);
    clay::ClayStroke<8> stroke(edit, field.scale, scene.tool, {scene.role, 1}, scene.stroke,
                               scene.setup);
    state.ResumeTiming();
    for (std::int64_t n = 0; n < stroke.stepCount(); ++n) {
      const clay::StepReport report = stroke.step(n);
      cells += report.clayCells;
      visited += report.cells;
    }
    stroke.finish();
    stroke.store();
    done += stroke.stepCount();
  }
  state.counters["steps/s"] =
      benchmark::Counter(static_cast<double>(done), benchmark::Counter::kIsRate);
  state.counters["clay"] = static_cast<double>(cells) / static_cast<double>(done);
  state.counters["visited"] = static_cast<double>(visited) / static_cast<double>(done);
}

// A bar in 32³ that is pushed over a support (Dewaele: about 50 steps a second in 2003).
Scene bar32(clay::Scheme scheme) {
  Scene scene;
  scene.box({16, 16, 16}, {14, 4, 4});
  scene.hold({0, 0, 0}, {8, 32, 32});
  scene.tool.radii = {4, 4, 4};
  scene.line({27, 26, 16}, {27, 12, 16});
  scene.setup.settings.scheme = scheme;
  scene.setup.settings.stiffness = 1;
  scene.setup.supports = {{Shape::ellipsoid, {13, 7, 16}, {5, 5, 5}, {1, 0, 0, 0}}};
  return scene;
}

Scene plough() {
  Scene scene;
  scene.box({48, 12, 32}, {44, 10, 26});
  scene.hold({0, 0, 0}, {95, 4, 63});
  scene.tool.radii = {7, 7, 7};
  scene.line({26, 24, 32}, {66, 24, 32});
  scene.setup.settings.stiffness = 0;
  return scene;
}

// A print in fluid clay on a body of this side: the cost must not know it.
Scene print(double side) {
  Scene scene;
  scene.box({0, -side / 2, 0}, glm::dvec3(side / 2));
  scene.tool.radii = {16, 16, 16};
  scene.line({0, 17, 0}, {0, 7, 0});
  scene.setup.settings.stiffness = 0;
  return scene;
}

// A grip on a body of 256³: as much of it as a region holds follows.
Scene bendVeryLarge() {
  Scene scene;
  scene.box({128, 128, 128}, glm::dvec3(128));
  scene.hold({-4, -4, -4}, {20, 260, 260});
  scene.tool.shape = Shape::box;
  scene.tool.radii = {20, 60, 60};
  scene.role = clay::Role::grip;
  scene.line({220, 128, 128}, {220, 129, 128});
  scene.setup.settings.stiffness = 1;
  return scene;
}

// Half of a body of 128 × 64 × 128 follows a grip.
Scene bendLarge() {
  Scene scene;
  scene.box({64, 32, 64}, {64, 32, 64});
  scene.hold({-4, -4, -4}, {20, 70, 140});
  scene.tool.shape = Shape::box;
  scene.tool.radii = {10, 40, 70};
  scene.role = clay::Role::grip;
  scene.line({110, 32, 64}, {110, 36, 64});
  scene.setup.settings.stiffness = 1;
  return scene;
}

Scene raffin() {
  Scene scene;
  scene.box({0, 0, 0}, {25, 25, 25});
  scene.tool.shape = Shape::box;
  scene.tool.radii = {10, 10, 10};
  scene.line({0, 35, 0}, {0, 27, 0});
  scene.setup.settings.layers = {LayerKind::diffusion};
  return scene;
}

// The tool put there at full depth: what the paper calls to act (Raffin §2, §4).
Scene raffinAtOnce() {
  Scene scene = raffin();
  scene.line({0, 27, 0}, {0, 27, 0});
  return scene;
}

Scene takai() {
  Scene scene;
  Edit<CornerBlock<8>> edit(scene.field.tree);
  Primitive column{Shape::cylinder, {0, 32, 0}, {16, 32, 16}, {1, 0, 0, 0}, {}};
  fill<8>(edit, scene.field.scale, column);
  edit.commit();
  scene.tool.shape = Shape::box;
  scene.tool.radii = {50, 4, 50};
  scene.line({0, 68, 0}, {0, 60, 0});
  scene.setup.settings.layers = {LayerKind::automaton};
  return scene;
}

std::shared_ptr<const Sculpture> sculptedBall(double radius) {
  Scene scene;
  Edit<CornerBlock<8>> edit(scene.field.tree);
  Primitive ball;
  ball.radii = glm::dvec3(radius);
  fill<8>(edit, scene.field.scale, ball);
  edit.commit();
  return std::make_shared<const Sculpture>(std::move(scene.field));
}

// What making a tool costs those who will push clay with it.
void distances(benchmark::State& state) {
  const auto ball = sculptedBall(static_cast<double>(state.range(0)));
  for (auto _ : state) {
    state.PauseTiming();
    const Sculpture fresh(ball->clay());
    state.ResumeTiming();
    benchmark::DoNotOptimize(&fresh.distance());
  }
}

// From the first point of a stroke to its first dab, with a sculpted tool of this radius on a slab.
void firstDab(benchmark::State& state, bool prepared) {
  Scene scene = plough();
  const auto ball = sculptedBall(static_cast<double>(state.range(0)));
  for (auto _ : state) {
    state.PauseTiming();
    scene.tool.shape = Shape::freeform;
    scene.tool.sculpture = std::make_shared<const Sculpture>(ball->clay());
    scene.tool.scale = glm::dvec3(7.0 / static_cast<double>(state.range(0)));
    scene.tool.radii = freeformRadii(*scene.tool.sculpture, scene.tool.scale);
    if (prepared) scene.tool.sculpture->distance();
    Clay field = scene.field;
    Edit<CornerBlock<8>> edit(field.tree);
    state.ResumeTiming();
    clay::ClayStroke<8> stroke(edit, field.scale, scene.tool, {scene.role, 1}, scene.stroke,
                               scene.setup);
    stroke.step(0);
    state.PauseTiming();
    stroke.store();
    state.ResumeTiming();
  }
}

void memorySweep(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  std::vector<float> a(count, 1), b(count, 2);
  for (auto _ : state) {
    for (std::size_t n = 0; n < count; ++n) a[n] = a[n] + 0.5f * (b[n] - a[n]);
    benchmark::DoNotOptimize(a.data());
    benchmark::ClobberMemory();
  }
  state.counters["sweeps/s"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

const auto kMs = benchmark::kMillisecond;
BENCHMARK_CAPTURE(steps, paper_32, bar32(clay::Scheme::paper))
    ->Unit(kMs)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(steps, projected_32, bar32(clay::Scheme::projected))
    ->Unit(kMs)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(steps, plough_100k_cells, plough())
    ->Unit(kMs)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(steps, print_16_on_128, print(128))
    ->Unit(kMs)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(steps, print_16_on_512, print(512))
    ->Unit(kMs)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(steps, bend_half_of_128, bendLarge())
    ->Unit(kMs)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(steps, print_16_on_256, print(256))
    ->Unit(kMs)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(steps, bend_on_256, bendVeryLarge())
    ->Unit(kMs)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(steps, raffin_50, raffin())->Unit(kMs)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK_CAPTURE(steps, raffin_at_once, raffinAtOnce())
    ->Unit(kMs)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(steps, takai_column, takai())->Unit(kMs)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(distances)->Unit(kMs)->Arg(8)->Arg(32)->Arg(75)->UseRealTime();
BENCHMARK_CAPTURE(firstDab, sculpted, false)->Unit(kMs)->Arg(32)->Arg(75)->UseRealTime();
BENCHMARK_CAPTURE(firstDab, sculpted_prepared, true)->Unit(kMs)->Arg(32)->Arg(75)->UseRealTime();
BENCHMARK(memorySweep)->Arg(100'000)->Arg(1'000'000)->Arg(8'000'000);

}  // namespace

BENCHMARK_MAIN();
