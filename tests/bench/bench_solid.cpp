// Deformable solids: one step of each solver at the sizes of the paper's table 1 and at 10⁴ refined
// cells, building, baking at 256³, posing clay.
#include <benchmark/benchmark.h>

#include "bozzetto/solid/bake.hpp"
#include "bozzetto/solid/simulation.hpp"
#include "bozzetto/solid/wrap.hpp"
#include "bozzetto/tool/fill.hpp"

namespace bozzetto {
namespace {

// A block with so many of its cells, swinging.
Solid solidOf(int side, int cells, int levels, Solver solver) {
  BlockOptions options{{side, side, side}, glm::dvec3(1), glm::dvec3(0), {}};
  for (int n = cells; n < side * side * side; ++n)
    options.removed.push_back({n / side / side, n / side % side, n % side});
  NamedLattice made = makeBlock(options);
  Solid solid;
  solid.control = std::move(made.lattice);
  solid.names = std::move(made.names);
  solid.settings.solver = solver;
  solid.settings.levels = levels;
  solid.settings.timeStep = 1;
  solid = Simulation(solid).solid();
  for (auto& p : solid.control.points) p.x *= 1.05;
  return solid;
}

void step(benchmark::State& state, Solver solver) {
  const Solid solid = solidOf(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)),
                              static_cast<int>(state.range(2)), solver);
  Simulation simulation(solid);
  int steps = 0;
  for (auto _ : state) {
    if (++steps % 20 == 0) {
      state.PauseTiming();
      simulation = Simulation(solid);
      state.ResumeTiming();
    }
    benchmark::DoNotOptimize(simulation.step());
  }
  state.counters["refined_cells"] = double(simulation.refined().cells.size());
}

void sizes(benchmark::internal::Benchmark* bench) {
  // Cells as 8 a control cell, or 64: 552 chair, 816 mug, 1072 head, 1536 soccer player, 10⁴.
  for (const auto& size : {std::array<std::int64_t, 3>{5, 69, 1},
                           {5, 102, 1},
                           {6, 134, 1},
                           {3, 24, 2},
                           {11, 1250, 1},
                           {6, 156, 2}})
    bench->Args({size[0], size[1], size[2]});
  bench->Unit(benchmark::kMillisecond);
}

BENCHMARK_CAPTURE(step, standard, Solver::standard)->Apply(sizes);
BENCHMARK_CAPTURE(step, live, Solver::live)->Apply(sizes);
BENCHMARK_CAPTURE(step, paper_explicit, Solver::paperExplicit)->Apply(sizes);
BENCHMARK_CAPTURE(step, paper_implicit, Solver::paperImplicit)->Apply(sizes);

void build(benchmark::State& state) {
  const Solid solid = solidOf(5, 102, 1, Solver::standard);
  for (auto _ : state) benchmark::DoNotOptimize(Simulation(solid).points().size());
}
BENCHMARK(build)->Unit(benchmark::kMillisecond);

void bakeAt256(benchmark::State& state) {
  Lattice lattice =
      makeBlock({{5, 5, 5}, glm::dvec3(44), {3, -7, 11}, {{0, 0, 0}, {2, 4, 2}}}).lattice;
  for (auto& p : lattice.points) {
    const double t = 0.6 * p.z / 220;
    p = {p.x * std::cos(t) - p.y * std::sin(t), p.x * std::sin(t) + p.y * std::cos(t), p.z};
  }
  for (auto _ : state) {
    Clay clay;
    Edit<CornerBlock<8>> edit(clay.tree);
    benchmark::DoNotOptimize(bake<8>(edit, clay.scale, lattice, {2, {}}).dirty);
    edit.commit();
  }
}
BENCHMARK(bakeAt256)->Unit(benchmark::kMillisecond);

void poseBall(benchmark::State& state) {
  Clay ball;
  {
    Edit<CornerBlock<8>> edit(ball.tree);
    fill<8>(edit, ball.scale, {Shape::ellipsoid, {0, 0, 0}, {48, 48, 48}, {1, 0, 0, 0}, {}});
    edit.commit();
  }
  const auto box = clayBox(ball);
  const Lattice rest = wrapBlock(box[0], box[1], {4, 4, 4}).lattice;
  auto posed = rest.points;
  for (auto& p : posed) p.x += 0.004 * p.y * p.y;
  for (auto _ : state) {
    Clay clay = ball;
    Edit<CornerBlock<8>> edit(clay.tree);
    benchmark::DoNotOptimize(applyWrap<8>(edit, clay.scale, rest, posed, {}).massAfter);
    edit.commit();
  }
}
BENCHMARK(poseBall)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bozzetto

BENCHMARK_MAIN();
