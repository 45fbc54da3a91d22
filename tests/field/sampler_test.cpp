#include "bozzetto/field/sampler.hpp"

#include <gtest/gtest.h>

#include "field/test_fields.hpp"

namespace bozzetto {
namespace {

template <class T>
class SamplerOfSide : public ::testing::Test {};
using Sides = ::testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 8>>;
TYPED_TEST_SUITE(SamplerOfSide, Sides);

TYPED_TEST(SamplerOfSide, isTheCornersThemselvesAtIntegers) {
  const auto field = testing::noise<TypeParam::value>(4, 20);
  FieldSampler<TypeParam::value> sampler(field);
  for (int n = 0; n < 22 * 22 * 22; ++n) {
    const Key key{n / 484 - 1, n / 22 % 22 - 1, n % 22 - 1};
    ASSERT_EQ(sampler.value({key, {}}), field.value(key));
    ASSERT_EQ(sampler.attributes(key), field.attributes(key));
  }
}

TYPED_TEST(SamplerOfSide, isExactForTrilinearFunctions) {
  const auto f = [](double x, double y, double z) {
    return 0.2 + 0.01 * x + 0.02 * y + 0.005 * z + 0.001 * x * y * z;
  };
  Field<TypeParam::value> field;
  testing::fill<TypeParam::value>(field, {{0, 0, 0}, {20, 20, 20}},
                                  [&](Key p) { return static_cast<float>(f(p.i, p.j, p.k)); });
  FieldSampler<TypeParam::value> sampler(field);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(1, 18);
  for (int n = 0; n < 500; ++n) {
    const glm::dvec3 p(uniform(random), uniform(random), uniform(random));
    const CellPoint place = cellPoint({2, -3, 1}, p - glm::dvec3(2, -3, 1));
    EXPECT_NEAR(sampler.value(place), f(p.x, p.y, p.z), 1e-5);
    const glm::vec3 slope = sampler.gradient(place);
    EXPECT_NEAR(slope.x, 0.01 + 0.001 * p.y * p.z, 1e-5);
    EXPECT_NEAR(slope.y, 0.02 + 0.001 * p.x * p.z, 1e-5);
    EXPECT_NEAR(slope.z, 0.005 + 0.001 * p.x * p.y, 1e-5);
  }
}

TEST(Sampler, colourIsWeightedByDensity) {
  Clay field;
  testing::fill<8>(field, {{0, 0, 0}, {0, 0, 0}}, [](Key) { return 1.0f; }, {200, 100, 0});
  testing::fill<8>(field, {{1, 0, 0}, {1, 0, 0}}, [](Key) { return 0.5f; }, {50, 40, 30});
  FieldSampler<8> sampler(field);
  EXPECT_EQ(sampler.colour({{0, 0, 0}, {0.5f, 0, 0}}), (Colour{150, 80, 10}));
  EXPECT_EQ(sampler.colour({{0, 0, 0}, {0, 0.5f, 0.5f}}), (Colour{200, 100, 0}));
  EXPECT_EQ(sampler.colour({{5, 5, 5}, {0, 0, 0}}), (Colour{0, 0, 0}));
}

TEST(Sampler, placesFarAwayKeepTheirFraction) {
  const CellPoint place = cellPoint({1 << 29, -(1 << 29), 0}, {-0.25, 7.5, 0x1p-40 - 1});
  EXPECT_EQ(place.base, (Key{(1 << 29) - 1, 7 - (1 << 29), -1}));
  EXPECT_EQ(place.fraction, glm::vec3(0.75f, 0.5f, 0x1p-40f));
  const CellPoint nearlyOne = cellPoint({}, {-1e-12, 1e300, -1e300});
  EXPECT_EQ(nearlyOne.base, (Key{0, kWorkspaceRim, -kWorkspaceRim}));
}

}  // namespace
}  // namespace bozzetto
