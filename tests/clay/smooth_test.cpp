// What strokes leave is smooth: what grips stretch, and the rims beside a furrow.
#include "clay_fixture.hpp"

namespace bozzetto::clay::testing {
namespace {

// Clay above a place, in cells.
double heightAt(const Clay& clay, std::int32_t i, std::int32_t k) {
  double height = 0;
  for (std::int32_t j = 0; j <= 40; ++j) height += clay.value({i, j, k});
  return height;
}

// How far heights are from the mean of those two cells beside them, rms.
double roughness(const Clay& clay, Key low, Key high) {
  double sum = 0;
  int count = 0;
  for (std::int32_t i = low.i; i <= high.i; ++i)
    for (std::int32_t k = low.k; k <= high.k; ++k, ++count) {
      const double beside = heightAt(clay, i - 2, k) + heightAt(clay, i + 2, k) +
                            heightAt(clay, i, k - 2) + heightAt(clay, i, k + 2);
      sum += std::pow(heightAt(clay, i, k) - beside / 4, 2);
    }
  return std::sqrt(sum / count);
}

// Two ears pulled out of a ball by one mirrored stroke: what is between them is stretched.
TEST(Smooth, SlowBetweenMirroredGrips) {
  Clay clay;
  addSolid(clay, Shape::ellipsoid, {0, 0, 0}, {20, 20, 20});
  holdBox(clay, {-40, -50, -40}, {40, -15, 40});
  Push push{toolOf(Shape::ellipsoid, {5, 5, 5}), Role::grip, {}, {}};
  push.stroke.points = {{{18, 4, 0}, 1}, {{28, 12, 0}, 1}};
  push.stroke.symmetry.mirror[0] = true;
  run(clay, push);
  EXPECT_LT(roughness(clay, {-8, 0, -8}, {8, 0, 8}), 0.165) << "0.18 where it is not faired";
  EXPECT_EQ(measure(clay).pieces, 1);
}

// They do not show the tiles that the pressure is solved in.
TEST(Smooth, SlowRimsOfAFurrow) {
  Clay clay;
  addSolid(clay, Shape::box, {0, 0, 0}, {64, 14, 32});
  holdBox(clay, {-70, -20, -40}, {70, -9, 40});
  Push push{toolOf(Shape::ellipsoid, {9, 9, 9}), Role::push, {}, {}};
  push.setup.settings.stiffness = 0;
  push.stroke.points = {{{-50, 26, 0}, 1}, {{-50, 18, 0}, 1}, {{30, 18, 0}, 1}};
  run(clay, push);
  double apart = 0, wave = 0;  // cells: from side to side; from the mean of those four beside
  for (std::int32_t i = -30; i <= 16; ++i)
    for (std::int32_t k = 4; k <= 16; ++k) {
      apart = std::max(apart, std::abs(heightAt(clay, i, k) - heightAt(clay, i, -k)));
      for (const std::int32_t at : {-k, k}) {
        const double beside = heightAt(clay, i - 4, at) + heightAt(clay, i + 4, at);
        wave = std::max(wave, std::abs(heightAt(clay, i, at) - beside / 2));
      }
    }
  EXPECT_LT(apart, 0.55) << "0.71 with half as many sweeps of the solver";
  EXPECT_LT(wave, 0.4) << "0.74 with half as many sweeps";
}

}  // namespace
}  // namespace bozzetto::clay::testing
