// What stands beside a furrow does not show the tiles that the pressure is solved in.
#include "clay_fixture.hpp"

namespace bozzetto::clay::testing {
namespace {

double heightAt(const Clay& clay, std::int32_t i, std::int32_t k) {
  double height = 0;
  for (std::int32_t j = 0; j <= 40; ++j) height += clay.value({i, j, k});
  return height;
}

TEST(Furrow, SlowRimsShowNoTiles) {
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
      for (const int side : {-k, k})
        wave = std::max(wave,
                        std::abs(heightAt(clay, i, side) -
                                 (heightAt(clay, i - 4, side) + heightAt(clay, i + 4, side)) / 2));
    }
  EXPECT_LT(apart, 0.55) << "0.71 with half as many sweeps of the solver";
  EXPECT_LT(wave, 0.4) << "0.74 with half as many sweeps";
}

}  // namespace
}  // namespace bozzetto::clay::testing
