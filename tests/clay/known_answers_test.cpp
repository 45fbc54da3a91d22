// Known answers, worked out by hand or by a slow program of another kind (numpy).
#include <functional>

#include "clay/automaton.hpp"
#include "clay/clay_fixture.hpp"
#include "clay/clearing.hpp"
#include "clay/diffusion.hpp"
#include "clay/displacement.hpp"
#include "clay/influence.hpp"
#include "clay/paper.hpp"
#include "clay/projection.hpp"
#include "clay/thinc.hpp"
#include "clay/transport.hpp"

namespace bozzetto::clay {
namespace {

// A small region with room round it, and all a layer wants to be given.
struct Bench {
  Region region{KeyBox{{-16, -16, -16}, {31, 31, 31}}};
  std::vector<PlacedTool> moving, supports;
  Settings settings;
  StepReport report;
  Work work() { return {region, moving, supports, {}, settings, 0.5f, 0, report}; }

  float& at(Key key) { return region.value[region.index(key)]; }
  void fill(Key low, Key high, float value = 1) {
    for (Key key = low; key.i <= high.i; ++key.i)
      for (key.j = low.j; key.j <= high.j; ++key.j)
        for (key.k = low.k; key.k <= high.k; ++key.k) {
          at(key) = value;
          region.touch(region.index(key));
        }
    region.refreshRows();
    region.listBand();
  }
  double mass() const {
    double sum = 0;
    for (const Row& row : region.rows())
      for (std::int32_t n = 0; n < row.count; ++n) sum += region.value[row.base + n];
    return sum;
  }
};

TEST(KnownAnswers, SplatSharesAmongEightNodes) {
  Bench bench;
  bench.fill({4, 4, 4}, {4, 4, 4});
  const std::size_t cell = bench.region.index({4, 4, 4});
  bench.region.wish[0][cell] = 0.25f;
  bench.region.wish[1][cell] = 0.5f;
  splat(bench.region);
  EXPECT_EQ(bench.at({4, 4, 4}), 0.375f);
  EXPECT_EQ(bench.at({4, 5, 4}), 0.375f);
  EXPECT_EQ(bench.at({5, 4, 4}), 0.125f);
  EXPECT_EQ(bench.at({5, 5, 4}), 0.125f);
  EXPECT_EQ(bench.mass(), 1);
}

// A bar along k between a moving tool at its start and a static one at its end.
std::vector<float> leadsAlong(Bench& bench, int length, float weak) {
  bench.fill({4, 4, 0}, {4, 4, length - 1});
  bench.at({4, 4, 5}) = weak;
  bench.region.owner[bench.region.index({4, 4, 0})] = kMoving;
  bench.region.owner[bench.region.index({4, 4, length - 1})] = kStatic;
  Pieces pieces;
  pieces.find(bench.region, kThin);
  Cells<float> cost(bench.region.box().count());
  for (int n = 0; n < length; ++n) {
    const std::size_t cell = bench.region.index({4, 4, n});
    cost[cell] = 1 / bench.region.value[cell];
  }
  PseudoDistance path;
  Cells<float>& first = bench.region.scratch;
  Cells<float>& second = bench.region.scratch2;
  path.run(bench.region, kMoving, cost, first);
  const float between = path.contacts(pieces).front().distance;
  path.run(bench.region, kStatic, cost, second);
  const float back = path.contacts(pieces).front().distance;
  std::vector<float> leads;
  for (int n = 0; n < length; ++n) {
    const std::size_t cell = bench.region.index({4, 4, n});
    leads.push_back(leadOf(first[cell], second[cell], std::min(between, back)));
  }
  return leads;
}

TEST(KnownAnswers, LeadFadesAlongABar) {
  Bench even, weak;
  const float fading[] = {1, .9f, .8f, .7f, .6f, .5f, .4f, .3f, .2f, .1f, 0};
  const float tearing[] = {1,        .923077f, .846154f, .769231f, .692308f, .5f,
                           .307692f, .230769f, .153846f, .076923f, 0};
  const auto a = leadsAlong(even, 11, 1), b = leadsAlong(weak, 11, 0.25f);
  for (std::size_t n = 0; n < 11; ++n) {
    EXPECT_NEAR(a[n], fading[n], 1e-6) << n;
    EXPECT_NEAR(b[n], tearing[n], 1e-6) << n;
  }
}

TEST(KnownAnswers, ThreeToolsShareWithoutJumps) {
  const double expected[] = {1.25,     1.273224, 1.295455, 1.315789, 1.333333, 1.347305, 1.357143,
                             1.233533, 1.095238, .947368,  .795455,  .644809,  .5};
  const int place[3][2] = {{0, 0}, {12, 0}, {6, 12}};
  const float delta[] = {1, 0, 2};
  std::vector<float> between(9), distance(3), weight(3);
  const auto manhattan = [](int a, int b, int c, int d) {
    return static_cast<float>(std::abs(a - c) + std::abs(b - d));
  };
  for (int t = 0; t < 3; ++t)
    for (int u = 0; u < 3; ++u)
      between[t * 3 + u] = manhattan(place[t][0], place[t][1], place[u][0], place[u][1]);
  for (int x = 0; x < 13; ++x) {
    for (int t = 0; t < 3; ++t) distance[t] = manhattan(x, 6, place[t][0], place[t][1]);
    shareLead(distance, between, weight);
    EXPECT_NEAR(weight[0] * delta[0] + weight[1] * delta[1] + weight[2] * delta[2], expected[x],
                1e-5)
        << x;
  }
}

TEST(KnownAnswers, ThincOutflow) {
  struct Case {
    Steepness by;
    std::array<float, 3> falling, rising;
  };
  const Case cases[] = {{kSoft, {.034608f, .122851f, .284608f}, {.215392f, .377149f, .465392f}},
                        {kHard, {.018639f, .094771f, .268639f}, {.231361f, .405229f, .481361f}}};
  for (const Case& each : cases) {
    for (std::size_t n = 0; n < 3; ++n) {
      const float density = 0.25f * static_cast<float>(n + 1);
      EXPECT_NEAR(thincFlux(density, 0.5f, -1, each.by), each.falling[n], 2e-6);
      EXPECT_NEAR(thincFlux(density, 0.5f, 1, each.by), each.rising[n], 2e-6);
    }
  }
}

TEST(KnownAnswers, ExponentialAndLogarithmOverTheirRange) {
  for (int n = -400; n <= 400; ++n) {
    const float x = 0.0125f * static_cast<float>(n), e = std::exp(x);
    EXPECT_NEAR(exponential(x) / e, 1, 4e-7) << x;
    EXPECT_NEAR(logarithm(e), x, 1e-6) << x;
  }
}

TEST(KnownAnswers, QueueOfThePaperComesToRest) {
  Bench bench;
  bench.fill({4, 4, 4}, {8, 8, 8});
  bench.at({6, 6, 6}) = 2;
  Work work = bench.work();
  PaperConservation().run(work);
  EXPECT_NEAR(bench.at({6, 6, 6}), .9971517, 1e-4);
  for (const Key& out :
       {Key{3, 6, 6}, Key{9, 6, 6}, Key{6, 3, 6}, Key{6, 9, 6}, Key{6, 6, 3}, Key{6, 6, 9}})
    EXPECT_NEAR(bench.at(out), .014144, 1e-4);
  EXPECT_EQ(bench.mass(), 126);
}

// clay.md §11, case 6: a block of five cells a side whose middle holds two.
struct Pulled {
  double middle, side, outside;  // the middle, a cell beside it, one outside the middle of a face
  double most;
};

Pulled afterPulls(float over, int most) {
  Bench bench;
  bench.fill({4, 4, 4}, {8, 8, 8});
  bench.at({6, 6, 6}) = 2;
  bench.settings.iterations = most;
  Work work = bench.work();
  PaperConservation(Giving::sweeps, over).run(work);
  EXPECT_EQ(bench.mass(), 126);
  float highest = 0;
  for (Key key{3, 3, 3}; key.i < 10; ++key.i)
    for (key.j = 3; key.j < 10; ++key.j)
      for (key.k = 3; key.k < 10; ++key.k) highest = std::max(highest, bench.at(key));
  for (const Key& way : {Key{1, 0, 0}, Key{0, 1, 0}, Key{0, 0, 1}, Key{-1, 0, 0}, Key{0, 0, -1}}) {
    EXPECT_EQ(bench.at(Key{6, 6, 6} + way), bench.at({6, 5, 6})) << "the same on all six sides";
    EXPECT_EQ(bench.at(Key{6, 6, 6} + way * 3), bench.at({6, 3, 6}));
  }
  return {bench.at({6, 6, 6}), bench.at({6, 5, 6}), bench.at({6, 3, 6}), highest};
}

void expectPulled(const Pulled& found, const Pulled& known) {
  constexpr double rounding = 2e-5;  // shares are multiples of 2^-20
  EXPECT_NEAR(found.middle, known.middle, rounding);
  EXPECT_NEAR(found.side, known.side, rounding);
  EXPECT_NEAR(found.outside, known.outside, rounding);
}

TEST(KnownAnswers, PullsSweepBySweep) {
  // The first sweep is of one cell, the second of six or seven.
  expectPulled(afterPulls(1, 1), {1, 1.166667, 0, 0});
  expectPulled(afterPulls(1, 2), {1.166667, 1, 0, 0});
  expectPulled(afterPulls(1, 8), {1, 1.069444, .004630, 0});
  expectPulled(afterPulls(1.2f, 1), {.8, 1.2, 0, 0});
  expectPulled(afterPulls(1.2f, 2), {1.04, .96, 0, 0});
  expectPulled(afterPulls(1.2f, 8), {.992, 1.04, .008, 0});
  const Pulled rest = afterPulls(1, 200'000), over = afterPulls(1.2f, 200'000);
  expectPulled(rest, {1, 1.003075, .011638, 0});
  EXPECT_NEAR(rest.most, 1.00874, 1e-4);
  expectPulled(over, {.997152, .999666, .014144, 0});
  EXPECT_NEAR(over.most, 1.00923, 1e-4);
}

// Outflow through a face after the projection, with nothing wished.
float outflow(Bench& bench, Key from, std::size_t axis) {
  return bench.region.face[axis][bench.region.index(from)];
}

TEST(KnownAnswers, PressureInATube) {
  for (int middle : {2, 1}) {
    Bench bench;
    bench.fill({4, 4, 4}, {4, 4, 8});
    for (int n = 0; n < 5; ++n)
      for (const Key side : {Key{1, 0, 0}, Key{-1, 0, 0}, Key{0, 1, 0}, Key{0, -1, 0}})
        bench.region.hold[bench.region.index(Key{4, 4, 4 + n} + side)] = kFixed;
    bench.at({4, 4, 4 + middle}) = 2;
    Work work = bench.work();
    Projection().run(work, {20, 2, 4});
    const float far = middle == 2 ? .5f : .333333f, near = middle == 2 ? .5f : .666667f;
    EXPECT_NEAR(outflow(bench, {4, 4, 8}, 2), far, 1e-4);
    EXPECT_NEAR(-outflow(bench, {4, 4, 3}, 2), near, 1e-4);
    EXPECT_NEAR(bench.region.pressure[bench.region.index({4, 4, 4})], near, 1e-4);
  }
}

TEST(KnownAnswers, PressureInABlock) {
  Bench bench;
  bench.fill({4, 4, 4}, {8, 8, 8});
  bench.at({6, 6, 6}) = 2;
  Work work = bench.work();
  Projection().run(work, {20, 2, 4});
  EXPECT_NEAR(bench.region.pressure[bench.region.index({6, 6, 6})], .228956, 1e-4);
  EXPECT_NEAR(outflow(bench, {8, 6, 6}, 0), .0185185, 1e-5);
  EXPECT_NEAR(outflow(bench, {8, 6, 7}, 0), .0122054, 1e-5);
  EXPECT_NEAR(outflow(bench, {8, 8, 8}, 0), .0021044, 1e-5);
  double side = 0;
  for (int j = 4; j < 9; ++j)
    for (int k = 4; k < 9; ++k) side += outflow(bench, {8, j, k}, 0);
  EXPECT_NEAR(side, 1 / 6.0, 1e-4);
}

std::array<float, 8> shared(Bench& bench, float first, float rest, SharingRule rule) {
  std::array<std::size_t, 8> cells;
  std::array<float, 8> limit, full, result;
  for (int n = 0; n < 8; ++n) {
    cells[n] = bench.region.index({4 + (n >> 2), 4 + (n >> 1 & 1), 4 + (n & 1)});
    bench.region.value[cells[n]] = n == 0 ? first : rest;
    limit[n] = 1.05f;
    full[n] = 1;
  }
  shareBlock(bench.region, cells, limit, full, {0.3f, rule});
  for (int n = 0; n < 8; ++n) result[n] = bench.region.value[cells[n]];
  return result;
}

TEST(KnownAnswers, TakaisBlock) {
  Bench bench;
  const auto two = shared(bench, 2, 1, SharingRule::literal);
  EXPECT_NEAR(two[0], 1.4, 1e-5);
  for (int n = 1; n < 8; ++n) EXPECT_NEAR(two[n], 1.0857143, 1e-5);
  const auto literal = shared(bench, 1.2f, 1, SharingRule::literal);
  EXPECT_NEAR(literal[0], .84, 1e-5);
  EXPECT_NEAR(literal[1], 1.0514286, 1e-5);
  const auto capped = shared(bench, 1.2f, 1, SharingRule::capped);
  EXPECT_NEAR(capped[0], 1, 1e-5);
  EXPECT_NEAR(capped[7], 1.0285714, 1e-5);
}

TEST(KnownAnswers, SpreadingCurve) {
  EXPECT_NEAR(spreadAt(0.5f, {0.5, 0.5}), .5, 1e-6);
  EXPECT_NEAR(spreadAt(0.5f, {0.5, 0}), .25, 1e-6);
  EXPECT_NEAR(spreadAt(0.5f, {0.5, 1}), .75, 1e-6);
  EXPECT_EQ(spreadAt(0.9f, kUniform), 1);
  for (const auto& control : {kLinear, kGaussian}) {
    EXPECT_NEAR(spreadAt(0, control), 1, 1e-6);
    EXPECT_NEAR(spreadAt(1, control), 0, 1e-6);
  }
}

// A step front that is carried along keeps its edge.
TEST(KnownAnswers, SharpTransportKeepsEdgesAndMatter) {
  Bench bench;
  bench.fill({0, 0, -8}, {7, 7, 3});
  const double before = bench.mass();
  Work work = bench.work();
  for (int step = 0; step < 40; ++step) {
    for (const Row& row : bench.region.rows())
      std::fill_n(&bench.region.face[2][row.base], row.count, 0.25f);
    work.step = step;
    transport(work);
    bench.region.refreshRows();
    bench.region.listBand();
  }
  EXPECT_EQ(bench.mass(), before);
  float steepest = 0;
  for (int k = 8; k < 20; ++k)
    steepest = std::max(steepest, 0.5f * (bench.at({4, 4, k - 1}) - bench.at({4, 4, k + 1})));
  EXPECT_GT(steepest, 1 / 2.5);
}

// clay.md §11.4: what splatting does to a step front carried over 20 cells.
TEST(KnownAnswers, SplatSmearsAFront) {
  const float step[] = {0.1f, 0.25f, 0.5f, 1.0f}, thickness[] = {10.709f, 9.833f, 8.171f, 2.0f};
  for (int n = 0; n < 4; ++n) {
    Bench bench;
    bench.region = Region(KeyBox{{-16, -16, -56}, {31, 31, 63}});
    bench.fill({4, 4, -40}, {4, 4, 4});
    for (int made = 0; made < std::lround(20 / step[n]); ++made) {
      for (const Row& row : bench.region.rows())
        std::fill_n(&bench.region.wish[2][row.base], row.count, step[n]);
      splat(bench.region);
      bench.region.refreshRows();
    }
    float steepest = 0;
    for (int k = 0; k < 50; ++k)
      steepest = std::max(steepest, 0.5f * (bench.at({4, 4, k - 1}) - bench.at({4, 4, k + 1})));
    EXPECT_NEAR(1 / steepest, thickness[n], 0.01) << step[n];
  }
}

// clay.md §11.8: a soft rim keeps what it has room for, whatever the number of ways out.
TEST(KnownAnswers, RimsOfToolsAreNotEmptied) {
  for (int ways = 1; ways <= 3; ++ways) {
    Bench bench;
    bench.fill({4, 4, 4}, {4, 4, 4});
    const std::size_t cell = bench.region.index({4, 4, 4});
    bench.region.cover[cell] = 0.8f;
    bench.region.covered = {{static_cast<std::uint32_t>(cell), 1}};
    for (int n = ways; n < 6; ++n) bench.region.hold[cell + bench.region.neighbours()[n]] = kFixed;
    Work work = bench.work();
    Clearing().run(work);
    EXPECT_NEAR(bench.region.value[cell], 0.2, 1e-5);
    for (int n = 0; n < ways; ++n)
      EXPECT_NEAR(bench.region.value[cell + bench.region.neighbours()[n]], 0.8 / ways, 1e-5);
  }
}

// A solid whose surface faces (1, 2, 2).
class Slanted final : public Solid {
 public:
  double distance(const glm::dvec3& p) const override { return (p.x + 2 * p.y + 2 * p.z) / 3 - 1; }
  void evaluate(Key, int side, float* value) const override {
    std::fill_n(value, side * side * side, 1.0f);
  }
};

// clay.md §11.10: 0.9 goes out by 0.18, 0.36 and 0.36.
TEST(KnownAnswers, RaffinsPartsFollowTheNormal) {
  Bench bench;
  bench.fill({4, 4, 4}, {4, 4, 4}, 0.9f);
  const std::size_t cell = bench.region.index({4, 4, 4});
  bench.region.cover[cell] = 1;
  bench.region.covered = {{static_cast<std::uint32_t>(cell), 1}};
  PlacedTool tool;
  tool.solid = std::make_unique<Slanted>();
  tool.solid->cell = {4, 4, 4};
  bench.moving.push_back(std::move(tool));
  Work work = bench.work();
  Diffusion().run(work);
  EXPECT_NEAR(bench.at({5, 4, 4}), 0.18, 1e-5);
  EXPECT_NEAR(bench.at({4, 5, 4}), 0.36, 1e-5);
  EXPECT_NEAR(bench.at({4, 4, 5}), 0.36, 1e-5);
  EXPECT_EQ(bench.at({4, 4, 4}), 0);
}

// How far Σ(Pₙ − P) is from the right side, over all cells.
double residualOf(const Region& region) {
  double sum = 0;
  for (const Row& row : region.denseRows())
    for (std::size_t n = row.base; n < row.base + row.count; ++n) {
      if (region.inverse[n] <= 0) continue;
      double own = -region.rhs[n] - region.pressure[n] / region.inverse[n];
      for (const std::ptrdiff_t step : region.neighbours()) own += region.pressure[n + step];
      sum += own * own;
    }
  return std::sqrt(sum);
}

// A cycle leaves less than half of the error where plain sweeps would hardly see it.
TEST(KnownAnswers, CyclesReachFar) {
  Bench bench;
  bench.region = Region(KeyBox{{-16, -16, -16}, {79, 39, 79}});
  bench.fill({0, 0, 0}, {60, 20, 60});
  for (int n = 0; n < 61 * 61; ++n)
    bench.region.hold[bench.region.index({n / 61, 0, n % 61})] = kFixed;
  bench.at({30, 10, 30}) = 2;
  Work work = bench.work();
  Projection projection;
  projection.run(work, {2, 1, 2});
  const double before = residualOf(bench.region);
  projection.run(work, {3, 1, 2});
  EXPECT_LT(residualOf(bench.region), before / 8);
}

}  // namespace
}  // namespace bozzetto::clay
