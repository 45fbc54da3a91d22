// A stroke that is drawn point by point is the stroke that was drawn.
#include "bozzetto/sculptor/live_stroke.hpp"

#include <gtest/gtest.h>

#include <random>

#include "bozzetto/sculptor/sculptor.hpp"

namespace bozzetto {
namespace {

Stroke wanderingStroke(std::uint32_t seed, int count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> step(-2, 2), pressure(0.2, 1);
  Stroke stroke;
  glm::dvec3 at{0, 8, 0};
  for (int n = 0; n < count; ++n) {
    stroke.points.push_back({at, pressure(random)});
    if (n % 5 != 3) at += glm::dvec3{step(random), step(random), step(random)};
  }
  stroke.symmetry.mirror[0] = true;
  stroke.pressure.strength = stroke.pressure.size = true;
  return stroke;
}

Stroke touch() {
  Stroke stroke;
  stroke.points = {{{0, 8, 0}}};
  return stroke;
}

template <int Side>
BasicSculptor<Side> ball() {
  BasicSculptor<Side> sculptor({}, SurfaceUpkeep::afterEachDab);
  sculptor.apply(FillOperation{});
  sculptor.apply(ToolOperation{{.radii = {3, 4, 3}}});
  return sculptor;
}

template <int Side>
void drawLive(BasicSculptor<Side>& sculptor, const Stroke& whole, std::size_t pointsAtOnce) {
  Stroke begun = whole;
  begun.points.resize(1);
  const auto live = sculptor.begin(begun);
  for (std::size_t n = 1; n < whole.points.size(); n += pointsAtOnce) {
    const std::size_t count = std::min(pointsAtOnce, whole.points.size() - n);
    while (live->dab()) {
    }
    live->extend(std::span(whole.points).subspan(n, count));
  }
  const OperationReport report = live->finish();
  EXPECT_EQ(report.dabs, live->plannedDabs());
  EXPECT_EQ(toText(StrokeOperation{live->stroke()}), toText(StrokeOperation{whole}));
}

template <int Side>
void expectSameHoweverDrawn() {
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    const Stroke stroke = wanderingStroke(seed, 30);
    auto whole = ball<Side>();
    whole.apply(StrokeOperation{stroke});
    for (const std::size_t pointsAtOnce : {1u, 4u, 100u}) {
      auto live = ball<Side>();
      drawLive(live, stroke, pointsAtOnce);
      EXPECT_EQ(fieldHash(live.field()), fieldHash(whole.field())) << seed << ' ' << pointsAtOnce;
      EXPECT_EQ(live.surface().totals(), whole.surface().totals());
    }
  }
}

TEST(LiveStroke, isTheStrokeInOnePiece) {
  expectSameHoweverDrawn<8>();
  expectSameHoweverDrawn<1>();
}

TEST(LiveStroke, theFirstDabNeedsNoSecondPoint) {
  auto sculptor = ball<8>();
  const auto live = sculptor.begin(touch());
  EXPECT_TRUE(live->dab());
  EXPECT_FALSE(live->dab());
}

TEST(LiveStroke, leavesNothingBehindUnlessFinished) {
  auto sculptor = ball<8>();
  const auto before = fieldHash(sculptor.field());
  const auto totals = sculptor.surface().totals();
  {
    const auto live = sculptor.begin(wanderingStroke(4, 20));
    while (live->dab()) {
    }
    EXPECT_NE(fieldHash(sculptor.field()), before);
  }
  EXPECT_EQ(fieldHash(sculptor.field()), before);
  EXPECT_EQ(sculptor.surface().totals(), totals);
  EXPECT_EQ(sculptor.history().undoDepth(), 1u);
}

TEST(LiveStroke, badPointsLeaveItAsItWas) {
  auto sculptor = ball<8>();
  const auto live = sculptor.begin(touch());
  for (const StrokePoint bad :
       {StrokePoint{{0, 1e12, 0}}, StrokePoint{{0, 0, 0}, 2}, StrokePoint{{1e8, 0, 0}}}) {
    EXPECT_THROW(live->extend({&bad, 1}), Error);
  }
  EXPECT_EQ(live->plannedDabs(), 1);
  EXPECT_EQ(live->finish().dabs, 1);
  EXPECT_EQ(sculptor.history().undoDepth(), 2u);
}

}  // namespace
}  // namespace bozzetto
