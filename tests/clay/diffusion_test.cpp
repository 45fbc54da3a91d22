// Raffin's walks: where what comes out of them comes out.
#include <algorithm>

#include "clay/clay_fixture.hpp"

namespace bozzetto::clay::testing {
namespace {

struct Reach {
  double axes = 0, diagonals = 0;  // the farthest clay from the middle line, in their directions
};

Reach reachOf(const Clay& clay) {
  Reach reach;
  for (int i = -48; i <= 48; ++i)
    for (int k = -48; k <= 48; ++k)
      for (int j = -14; j <= 14; ++j) {
        if (clay.value({i, j, k}) < 0.5f) continue;
        const double near = std::min(std::abs(i), std::abs(k)),
                     far = std::max(std::abs(i), std::abs(k));
        double& farthest = near < 0.4142 * far ? reach.axes : reach.diagonals;
        farthest = std::max(farthest, std::hypot(near, far));
      }
  return reach;
}

Reach pressedOnATable(Scheme scheme) {
  Clay clay;
  addSolid(clay, Shape::ellipsoid, {0, 0, 0}, {14, 14, 14});
  Push push{toolOf(Shape::ellipsoid, {8, 8, 8}), Role::push, {}, {}};
  push.stroke.points = {{{0, 26, 0}, 1}, {{0, 8, 0}, 1}};
  push.setup.settings.layers = {LayerKind::diffusion};
  push.setup.settings.walk = 10;
  push.setup.settings.scheme = scheme;
  push.setup.supports.push_back({Shape::box, {0, -24, 0}, {60, 10, 60}});
  run(clay, push);
  EXPECT_EQ(measure(clay).pieces, 1);
  return reachOf(clay);
}

// By the paper's axes it has four ears.
TEST(Diffusion, ABallPressedOnATableBulgesToAllSides) {
  const Reach round = pressedOnATable(Scheme::projected), paper = pressedOnATable(Scheme::paper);
  EXPECT_LT(round.axes, 1.15 * round.diagonals);
  EXPECT_GT(round.axes, 0.85 * round.diagonals);
  EXPECT_GT(paper.axes, 1.2 * paper.diagonals);
}

}  // namespace
}  // namespace bozzetto::clay::testing
