// The pyramid against its own definition, worked out corner by corner.
#include "bozzetto/field/pyramid.hpp"

#include <gtest/gtest.h>

#include "field/test_fields.hpp"

namespace bozzetto {
namespace {

using testing::ball;

// Everything a level holds, corner by corner.
std::map<Key, float> contentOf(const DensityTree& tree) {
  std::map<Key, float> content;
  for (const auto& [key, run] : tree) {
    for (int n = 0; n < 512 * run.length; ++n) {
      const float value = run.block->value[n % 512];
      const Key in{n / 64 % 8, n / 8 % 8, n % 8 + n / 512 * 8};
      if (value != 0) content[key * 8 + in] = value;
    }
  }
  return content;
}

void expectEqual(const Pyramid& a, const Pyramid& b) {
  ASSERT_EQ(a.levels(), b.levels());
  for (int n = 1; n <= a.levels(); ++n) {
    ASSERT_EQ(a.level(n).validate(), std::nullopt);
    ASSERT_EQ(contentOf(a.level(n)), contentOf(b.level(n))) << "level " << n;
  }
}

TEST(Pyramid, eachCornerIsTheWeightedMeanOfSixCubed) {
  const auto field = testing::noise<8>(3, 21);
  Pyramid pyramid(2);
  pyramid.rebuild(field);
  const double weight[6] = {0.125, 0.125, 0.25, 0.25, 0.125, 0.125};
  PyramidSampler sampler(field, pyramid);
  for (const Key I : {Key{0, 0, 0}, Key{3, 4, 5}, Key{-1, 10, 2}, Key{7, 8, 11}, Key{4, 3, -2}}) {
    double mean = 0;
    for (int n = 0; n < 216; ++n) {
      const Key at{n / 36, n / 6 % 6, n % 6};
      mean += weight[at.i] * weight[at.j] * weight[at.k] * field.value(I * 2 - Key{2, 2, 2} + at);
    }
    const auto block = pyramid.level(1).find(BlockGeometry<8>::blockOf(I));
    const float stored = block ? block->value[BlockGeometry<8>::indexOf(I)] : 0.0f;
    EXPECT_NEAR(stored, mean, 1e-6) << toText(I);
    // The sample's centre lies at 2I + 1/2.
    const glm::vec3 centre = 2.0f * glm::vec3(I.i, I.j, I.k) + 0.5f;
    EXPECT_NEAR(sampler.sampleLevel(centre, 1), mean, 1e-6);
  }
}

TEST(Pyramid, insideOfASolidIsFullAndCostsRuns) {
  Clay field;
  for (std::int32_t i = -30; i < 30; ++i)
    for (std::int32_t j = -30; j < 30; ++j)
      field.tree.put({i, j, -1000000}, 2000000, CornerBlock<8>::uniform(1.0f, 7));
  Pyramid pyramid;
  pyramid.rebuild(field);
  PyramidSampler sampler(field, pyramid, {5, 6, 7});
  for (float level = 0; level <= 3; level += 0.3f) {
    EXPECT_EQ(sampler.sample({1.3f, -2.2f, 900.7f}, level), 1.0f);
    EXPECT_EQ(sampler.sample({1000.3f, -2.2f, 0.7f}, level), 0.0f);
  }
  EXPECT_LT(pyramid.bytes(), 20000000u);  // walls and ends: 60 × 60 × 2,000,000 blocks inside
}

TEST(Pyramid, anInclinedPlaneIsReproducedOnEveryLevel) {
  // value = linear in the place, far from the ends; means of linear functions are linear.
  Clay field;
  testing::fill<8>(field, {{-70, -70, -70}, {70, 70, 70}}, [](Key p) {
    return 0.5f + 0.001f * static_cast<float>(p.i) + 0.002f * static_cast<float>(p.j) -
           0.0005f * static_cast<float>(p.k);
  });
  Pyramid pyramid(4);
  pyramid.rebuild(field);
  PyramidSampler sampler(field, pyramid, {3, -2, 1});
  for (const glm::vec3 p : {glm::vec3(0), glm::vec3(3.3f, -8.1f, 4.7f), glm::vec3(-9, 2, 11.5f)}) {
    const float expected = 0.5f + 0.001f * (p.x + 3) + 0.002f * (p.y - 2) - 0.0005f * (p.z + 1);
    for (float level = 0; level <= 3; level += 0.25f) {
      EXPECT_NEAR(sampler.sample(p, level), expected, 2e-6) << level;
    }
  }
}

TEST(Pyramid, halfSpaceBlursSymmetricallyAboutItsSurface) {
  Clay field;
  // Surface at x = 0.5: the centre of level-1 corners there.
  testing::fill<8>(field, {{-100, -60, -60}, {0, 60, 60}}, [](Key) { return 1.0f; });
  Pyramid pyramid(3);
  pyramid.rebuild(field);
  PyramidSampler sampler(field, pyramid);
  for (float level = 0; level <= 3; level += 0.5f) {
    // Level 2 and up have their corners elsewhere: nearly symmetric only.
    const float tolerance = level <= 1 ? 1e-6f : 0.02f;
    EXPECT_NEAR(sampler.sample({0.5f, 0, 0}, level), 0.5f, tolerance);
    for (float d = 0.25f; d < 20; d *= 1.7f) {
      EXPECT_NEAR(sampler.sample({0.5f + d, 0, 0}, level),
                  1 - sampler.sample({0.5f - d, 0, 0}, level), tolerance);
    }
  }
}

TEST(Pyramid, massStaysOnEveryLevel) {
  const auto field = ball<8>(17.3f, {5, 60, -9});
  Pyramid pyramid(3);
  pyramid.rebuild(field);
  const double mass = statistics(field).mass;
  for (int n = 1; n <= 3; ++n) {
    double sum = 0;
    for (const auto& [key, value] : contentOf(pyramid.level(n))) sum += value;
    EXPECT_NEAR(sum * (1 << 3 * n), mass, 1e-5 * mass);
  }
}

TEST(Pyramid, refreshEqualsRebuildOverRandomEdits) {
  std::mt19937 random(5);
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  auto field = ball<8>(30);
  Pyramid refreshed(4);
  refreshed.rebuild(field);
  for (int step = 0; step < 60; ++step) {
    const Key low{pick(80) - 40, pick(80) - 40, pick(80) - 40};
    const Key size{pick(20), pick(20), pick(40)};
    const float value = static_cast<float>(pick(4)) / 3.0f;
    const bool rough = pick(3) == 0;
    const auto delta = testing::fill<8>(field, {low, low + size}, [&](Key) {
      return rough ? static_cast<float>(pick(100)) / 100.0f : value;
    });
    if (pick(5) == 0) delta.apply(field.tree, Direction::backward);
    refreshed.refresh(field, delta.keys());
    if (step % 6 != 0) continue;
    Pyramid rebuilt(4);
    rebuilt.rebuild(field);
    expectEqual(refreshed, rebuilt);
  }
  const auto delta =
      testing::fill<8>(field, {{-50, -50, -50}, {80, 80, 90}}, [](Key) { return 0.0f; });
  refreshed.refresh(field, delta.keys());
  for (int n = 1; n <= 4; ++n) EXPECT_TRUE(refreshed.level(n).empty());
}

TEST(Pyramid, refreshEqualsRebuildInsideLongRuns) {
  Clay field;
  for (std::int32_t i = -3; i < 3; ++i)
    for (std::int32_t j = -3; j < 3; ++j)
      field.tree.put({i, j, -100}, 200, CornerBlock<8>::uniform(1.0f, 7));
  Pyramid refreshed(4);
  refreshed.rebuild(field);
  const auto delta = testing::fill<8>(field, {{1, 2, 3}, {9, 4, 30}}, [](Key) { return 0.25f; });
  refreshed.refresh(field, delta.keys());
  Pyramid rebuilt(4);
  rebuilt.rebuild(field);
  expectEqual(refreshed, rebuilt);
}

TEST(Pyramid, doesNotDependOnThreads) {
  const auto field = testing::noise<8>(9, 70);
  Pyramid one, four;
  setThreadCount(1);
  one.rebuild(field);
  setThreadCount(4);
  four.rebuild(field);
  setThreadCount(0);
  expectEqual(one, four);
}

TEST(Pyramid, paintChangesNothing) {
  auto field = ball<8>(20);
  Pyramid pyramid(2);
  pyramid.rebuild(field);
  const DensityBlock* before = pyramid.level(1).find({0, 0, 1});
  ASSERT_NE(before, nullptr);
  const Clay old = field;
  const auto delta = testing::fill<8>(field, {{-25, -25, -25}, {25, 25, 25}},
                                      [&](Key p) { return old.value(p); }, {1, 2, 3});
  ASSERT_FALSE(delta.empty());
  pyramid.refresh(field, delta.keys());
  EXPECT_EQ(pyramid.level(1).find({0, 0, 1}), before);
}

}  // namespace
}  // namespace bozzetto
