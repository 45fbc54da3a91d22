#include "bozzetto/field/resample.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "bozzetto/field/sampler.hpp"
#include "field/test_fields.hpp"

namespace bozzetto {
namespace {

using testing::ball;

double massOf(const Clay& field) { return statistics(field).mass; }

// World volume of the region with value ≥ ½, counted on a lattice finer than the corners.
double insideOf(const Clay& field) {
  FieldSampler<8> sampler(field);
  const KeyBox box = grown(statistics(field).bounds, 1);
  const double cell = field.scale.spacing;
  std::int64_t count = 0;
  for (std::int32_t i = box.low.i; i < box.high.i; ++i)
    for (std::int32_t j = box.low.j; j < box.high.j; ++j)
      for (std::int32_t k = box.low.k; k < box.high.k; ++k)
        for (int n = 0; n < 8; ++n) {
          const glm::vec3 at(n & 1 ? .25f : .75f, n & 2 ? .25f : .75f, n & 4 ? .25f : .75f);
          count += sampler.value({{i, j, k}, at}) >= 0.5f ? 1 : 0;
        }
  return static_cast<double>(count) / 8 * cell * cell * cell;
}

TEST(Resample, theSameSpacingIsTheSameField) {
  const auto field = testing::noise<8>(4, 30);
  const Clay same = resample(field, field.scale.spacing);
  EXPECT_EQ(fieldHash(same), fieldHash(field));
  EXPECT_EQ(same.tree.find({0, 0, 0}), field.tree.find({0, 0, 0}));
}

class ResampledBall : public ::testing::TestWithParam<double> {};

TEST_P(ResampledBall, keepsMassVolumeColourAndPlace) {
  const auto field = ball<8>(24.3f, {40, -9, 3}, {10, 200, 77});
  const Clay other = resample(field, GetParam());
  ASSERT_EQ(validate(other), std::nullopt);
  EXPECT_EQ(other.scale.spacing, GetParam());
  EXPECT_NEAR(massOf(other), massOf(field), 0.01 * massOf(field));
  // A blur of variance r²/6 draws a ball of radius R in by r²/6R.
  const double drawnIn = 1.5 * std::pow(std::max(1.0, GetParam()) / 24.3, 2);
  EXPECT_NEAR(insideOf(other), insideOf(field), (0.01 + drawnIn) * insideOf(field));
  FieldSampler<8> sampler(other);
  for (const glm::dvec3 world : {glm::dvec3(40, -9, 3), glm::dvec3(50, -9, 10)}) {
    const CellPoint place = cellPoint({}, world / GetParam());
    EXPECT_EQ(sampler.value(place), 1.0f);
    EXPECT_EQ(sampler.colour(place), (Colour{10, 200, 77}));
  }
  EXPECT_EQ(sampler.value(cellPoint({}, glm::dvec3(40, -9, 37) / GetParam())), 0.0f);
}

TEST_P(ResampledBall, isPredicted) {
  const auto field = ball<8>(57, {4, 5, 6});
  const FieldStatistics made = statistics(resample(field, GetParam()));
  const ResamplePrediction prediction = predictResample(field, GetParam());
  const auto corners = static_cast<double>(made.corners), bytes = static_cast<double>(made.bytes);
  EXPECT_NEAR(static_cast<double>(prediction.corners), corners, 0.2 * corners);
  if (made.blocks > 100) {
    EXPECT_NEAR(static_cast<double>(prediction.bytes), bytes, 0.2 * bytes);
  }
}

INSTANTIATE_TEST_SUITE_P(Spacings, ResampledBall,
                         ::testing::Values(0.4, 0.5, 0.77, 1.01, 1.3, 2.0, 2.5, 3.9));

TEST(Resample, linearSlopesStayExact) {
  Clay field;
  testing::fill<8>(field, {{-36, -36, -36}, {36, 36, 36}}, [](Key p) {
    return 0.5f + 0.003f * static_cast<float>(p.i) - 0.002f * static_cast<float>(p.j) +
           0.001f * static_cast<float>(p.k);
  });
  for (const double spacing : {0.4, 1.37, 2.0, 4.6}) {
    const Clay other = resample(field, spacing);
    for (const Key key : {Key{0, 0, 0}, Key{3, -4, 2}, Key{-5, 1, 5}}) {
      const glm::dvec3 p = glm::dvec3(key.i, key.j, key.k) * spacing;
      EXPECT_NEAR(other.value(key), 0.5 + 0.003 * p.x - 0.002 * p.y + 0.001 * p.z, 1e-5);
    }
  }
}

TEST(Resample, finerTakesTheTrilinearValue) {
  const auto field = testing::noise<8>(11, 12);
  FieldSampler<8> sampler(field);
  const Clay fine = resample(field, 0.25);
  for (int n = 0; n < 48 * 48 * 48; n += 7) {
    const Key key{n / 2304, n / 48 % 48, n % 48};
    const glm::vec3 at = 0.25f * glm::vec3(key.i % 4, key.j % 4, key.k % 4);
    const float expected = sampler.value({{key.i / 4, key.j / 4, key.k / 4}, at});
    ASSERT_NEAR(fine.value(key), expected, 1e-6) << toText(key);
  }
}

TEST(Resample, finePatternsBecomeTheirMeanAndDoNotAlias) {
  Clay field;
  testing::fill<8>(field, {{0, 0, 0}, {79, 79, 79}}, [](Key p) { return p.i & 1 ? 1.0f : 0.0f; });
  for (const double spacing : {2.0, 3.0, 4.0}) {
    const Clay coarse = resample(field, spacing);
    for (std::int32_t i = 5; i < 15; ++i) EXPECT_NEAR(coarse.value({i, 9, 8}), 0.5f, 0.06f);
  }
}

TEST(Resample, coloursAreMeansOverTheClayAndHoldIsTheNearest) {
  Clay field;
  testing::fill<8>(field, {{0, 0, 0}, {20, 20, 9}}, [](Key) { return 1.0f; }, {200, 0, 90});
  testing::fill<8>(field, {{0, 0, 10}, {20, 20, 20}}, [](Key) { return 0.5f; }, {100, 50, 0});
  Edit<CornerBlock<8>> edit(field.tree);
  edit.write({1, 1, 1}).attributes[0] |= Attributes{99} << 24;  // corner (8, 8, 8)
  edit.commit();
  const Clay fine = resample(field, 0.5);
  // Half way between full red and half-dense other: two to one.
  EXPECT_EQ(colourOf(fine.attributes({16, 16, 19})), (Colour{167, 17, 60}));
  EXPECT_EQ(colourOf(fine.attributes({16, 16, 10})), (Colour{200, 0, 90}));
  EXPECT_EQ(holdOf(fine.attributes({16, 16, 16})), 99);
  EXPECT_EQ(holdOf(fine.attributes({15, 15, 15})), 99);
  EXPECT_EQ(holdOf(fine.attributes({17, 16, 16})), 0);
}

TEST(Resample, theInsideOfASolidGoesByRuns) {
  Clay field;
  for (std::int32_t i = -4; i < 4; ++i)
    for (std::int32_t j = -4; j < 4; ++j)
      field.tree.put({i, j, -300}, 600, CornerBlock<8>::uniform(1.0f, 7));
  const Clay coarse = resample(field, 1.5);
  ASSERT_EQ(validate(coarse), std::nullopt);
  EXPECT_EQ(coarse.tree.at({0, 0, 0})->second.length, 399);
  EXPECT_EQ(coarse.value({0, 0, 0}), 1.0f);
  EXPECT_NEAR(massOf(coarse), massOf(field), 0.01 * massOf(field));
}

TEST(Resample, doesNotDependOnThreads) {
  const auto field = testing::noise<8>(9, 50);
  setThreadCount(1);
  const auto one = fieldHash(resample(field, 0.7)), coarse = fieldHash(resample(field, 5));
  setThreadCount(4);
  EXPECT_EQ(fieldHash(resample(field, 0.7)), one);
  EXPECT_EQ(fieldHash(resample(field, 5)), coarse);
  setThreadCount(0);
}

TEST(Resample, refusesBadSpacingsAndWhatDoesNotFit) {
  const auto field = ball<8>(20);
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(), 1e-300, 1e300}) {
    EXPECT_THROW(resample(field, bad), Error) << bad;
    EXPECT_THROW(predictResample(field, bad), Error) << bad;
  }
  EXPECT_THROW(resample(ball<8>(5, {1 << 29, 0, 0}), 0.25), Error);
  EXPECT_THROW(resample(field, 0.001), Error);
  EXPECT_THROW(resample(field, 0.5, {.memoryLimit = 100000}), Error);
  EXPECT_GT(resample(field, 1000000.0).scale.spacing, 1.0);
  EXPECT_TRUE(resample(Clay{}, 0.5).tree.empty());
}

struct StopAt : Progress {
  double limit = 0;
  bool report(std::string_view, double done) override { return done < limit; }
};

TEST(Resample, stopsWhenAsked) {
  StopAt progress;
  progress.limit = 0.5;
  EXPECT_THROW(resample(ball<8>(20), 0.5, {}, progress), Cancelled);
}

}  // namespace
}  // namespace bozzetto
