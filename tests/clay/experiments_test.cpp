// The papers' experiments, held to what clay.md §11 asks for.
#include <ctime>
#include <iostream>

#include "clay/clay_fixture.hpp"

namespace bozzetto::clay::testing {
namespace {

void tell(const char* name, const Measures& a, const Measures& b, std::int64_t steps, double s) {
  std::cout << name << ": drift " << b.mass / a.mass - 1 << " V " << 100 * (b.volume / a.volume - 1)
            << " % th " << a.thickness << " -> " << b.thickness << " pieces " << b.pieces
            << " stored " << a.stored << " -> " << b.stored << " faint " << b.faint << " steps/s "
            << static_cast<double>(steps) / s << "\n";
}

template <class Body>
double seconds(const Body& body) {
  const auto start = std::clock();
  body();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

Settings stiff(double stiffness) {
  Settings settings;
  settings.stiffness = stiffness;
  return settings;
}

// Turns about z from angle 0 to `angle` round `hinge`, led from `start`.
Stroke arc(glm::dvec3 start, glm::dvec3 hinge, double angle, int points) {
  Stroke stroke;
  for (int n = 0; n <= points; ++n) {
    const glm::dquat turn = glm::angleAxis(angle * n / points, glm::dvec3(0, 0, 1));
    stroke.points.push_back({hinge + turn * (start - hinge), 1});
    stroke.rotations.push_back(turn);
  }
  return stroke;
}

TEST(Experiments, SlowBendByRotatingGrip) {
  Clay clay;
  addSolid(clay, Shape::box, {48, 65, 12}, {36, 5, 5});
  holdBox(clay, {8, 55, 0}, {23, 75, 24});
  const Measures before = measure(clay);
  Push push{toolOf(Shape::cylinder, {7, 9, 7}),
            Role::grip,
            arc({76, 65, 12}, {42, 53, 12}, -1.5, 120),
            {stiff(1), {}}};
  push.tool.rotation = glm::angleAxis(std::acos(-1.0) / 2, glm::dvec3(1, 0, 0));
  Support support{Shape::cylinder, {42, 53, 12}, {7, 9, 7}, push.tool.rotation};
  push.setup.supports = {support};
  std::int64_t steps = 0;
  const double s = seconds([&] { steps = run(clay, push); });
  const Measures after = measure(clay);
  tell("bend", before, after, steps, s);
  EXPECT_NEAR(after.mass / before.mass, 1, 1e-6);
  EXPECT_NEAR(after.volume / before.volume, 1, 0.008);
  EXPECT_EQ(after.pieces, 1);
  EXPECT_LT(after.thickness, 2.4);
}

TEST(Experiments, SlowPrintOfABall) {
  Clay clay;
  addSolid(clay, Shape::box, {36, 14.5, 36}, {30, 12.5, 30});
  holdBox(clay, {0, 0, 0}, {72, 4, 72});
  const Measures before = measure(clay);
  Push push{toolOf(Shape::ellipsoid, {10, 10, 10}), Role::push, {}, {stiff(0), {}}};
  push.stroke.points = {{{36, 38, 36}, 1}, {{36, 27, 36}, 1}};
  std::int64_t steps = 0;
  const double s = seconds([&] { steps = run(clay, push); });
  const Measures after = measure(clay);
  tell("print", before, after, steps, s);
  for (int i = 36; i < 68; i += 2) {
    double height = 0;
    for (int j = 50; j > 0 && height == 0; --j) {
      const float v = clay.value({i, j, 36}), above = clay.value({i, j + 1, 36});
      if (v >= 0.5f) height = j + (v - 0.5) / (v - above + 1e-9);
    }
    std::cout << height - 27 << " ";
  }
  std::cout << "\n";
}

TEST(Experiments, SlowPlough) {
  Clay clay;
  addSolid(clay, Shape::box, {48, 12, 32}, {44, 10, 26});
  holdBox(clay, {0, 0, 0}, {95, 4, 63});
  const Measures before = measure(clay);
  Push push{toolOf(Shape::ellipsoid, {7, 7, 7}), Role::push, {}, {stiff(0), {}}};
  push.stroke.points = {{{22, 32, 32}, 1}, {{22, 24, 32}, 1}, {{70, 24, 32}, 1}};
  std::int64_t steps = 0;
  const double s = seconds([&] { steps = run(clay, push); });
  tell("plough", before, measure(clay), steps, s);
}

TEST(Experiments, SlowStretch) {
  Clay clay;
  addSolid(clay, Shape::box, {32, 16, 16}, {24, 6, 6});
  holdBox(clay, {0, 0, 0}, {15, 31, 31});
  const Measures before = measure(clay);
  Push push{toolOf(Shape::box, {4, 9, 9}), Role::grip, {}, {stiff(1), {}}};
  push.stroke.points = {{{52, 16, 16}, 1}, {{85, 16, 16}, 1}};
  std::int64_t steps = 0;
  const double s = seconds([&] { steps = run(clay, push); });
  tell("stretch", before, measure(clay), steps, s);
}

}  // namespace
}  // namespace bozzetto::clay::testing
