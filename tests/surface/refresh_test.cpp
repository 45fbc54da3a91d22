#include <gtest/gtest.h>

#include "bozzetto/base/parallel.hpp"
#include "surface/surface_fields.hpp"

namespace bozzetto {
namespace {

using testing::ball;
using testing::samePatches;
using testing::surfaceOf;

struct Box {
  Key low, high;
};

Box randomBox(std::mt19937& random, int span) {
  const auto pick = [&](int n) { return static_cast<std::int32_t>(random() % n); };
  const Key low{pick(span) - span / 2, pick(span) - span / 2, pick(span) - span / 2};
  return {low, low + Key{pick(7), pick(7), pick(7)}};
}

// Sets corners in a box to random values, to one value, or to nothing; or colours them.
template <int Side>
Delta<CornerBlock<Side>> randomEdit(Field<Side>& field, std::mt19937& random) {
  const auto [low, high] = randomBox(random, 30);
  const auto kind = random() % 5;
  const Colour colour{static_cast<std::uint8_t>(random()), 1, 2};
  Edit<CornerBlock<Side>> edit(field.tree);
  for (std::int32_t i = low.i; i <= high.i; ++i)
    for (std::int32_t j = low.j; j <= high.j; ++j)
      for (std::int32_t k = low.k; k <= high.k; ++k) {
        auto& block = edit.write(BlockGeometry<Side>::blockOf({i, j, k}));
        const int at = BlockGeometry<Side>::indexOf({i, j, k});
        const float any = static_cast<float>(random() % 1000) / 1000;
        if (kind < 4) block.value[at] = kind == 0 ? 0.0f : kind == 1 ? 1.0f : any;
        block.attributes[at] = packAttributes(colour);
      }
  if (kind == 1 && Side == 8) {
    const auto full = CornerBlock<Side>::uniform(1, packAttributes(colour));
    edit.replace({BlockGeometry<Side>::blockOf(low), 1 + static_cast<int>(random() % 4)},
                 random() % 2 == 0 ? full : nullptr);
  }
  return edit.commit();
}

template <int Side>
void editAndCompare(unsigned seed, int edits) {
  std::mt19937 random(seed);
  auto field = ball<Side>(7.5f, {1, 2, -1});
  Surface<Side> byKeys = surfaceOf(field), byDelta = surfaceOf(field);
  for (int n = 0; n < edits; ++n) {
    const auto delta = randomEdit(field, random);
    byKeys.refresh(field, delta.keys());
    byDelta.refresh(field, delta);
    const auto fresh = surfaceOf(field);
    ASSERT_TRUE(samePatches(fresh, byKeys)) << "seed " << seed << " edit " << n;
    ASSERT_TRUE(samePatches(fresh, byDelta)) << "seed " << seed << " edit " << n;
    ASSERT_EQ(byDelta.totals(), fresh.totals());
    ASSERT_EQ(byDelta.validate(), std::nullopt);
  }
}

TEST(Refresh, equalsARebuildAfterAnyEdits) {
  for (unsigned seed = 0; seed < 12; ++seed) editAndCompare<8>(seed, 25);
}

TEST(Refresh, equalsARebuildWithSideOne) {
  for (unsigned seed = 0; seed < 4; ++seed) editAndCompare<1>(seed, 8);
}

TEST(Refresh, undoAndRedoToo) {
  std::mt19937 random(77);
  auto field = ball<8>(12);
  Surface<8> surface = surfaceOf(field);
  const Surface<8> before = surfaceOf(field);
  std::vector<Delta<Clay::Block>> deltas;
  for (int n = 0; n < 10; ++n) {
    deltas.push_back(randomEdit(field, random));
    surface.refresh(field, deltas.back());
  }
  for (auto delta = deltas.rbegin(); delta != deltas.rend(); ++delta) {
    delta->apply(field.tree, Direction::backward);
    surface.refresh(field, *delta);
  }
  EXPECT_TRUE(samePatches(before, surface));
}

TEST(Refresh, reportsWhatChangedAndNothingElse) {
  auto field = ball<8>(40);
  Surface<8> surface = surfaceOf(field);
  const auto delta = testing::fill<8>(field, {{-2, 38, -2}, {2, 42, 2}}, [](Key) { return 1.0f; });
  std::vector<std::pair<Key, Ref<SurfacePatch>>> old;
  for (const auto& [key, run] : surface.patches()) old.emplace_back(key, run.block);
  const RefreshReport report = surface.refresh(field, delta);
  EXPECT_TRUE(std::is_sorted(report.changed.begin(), report.changed.end()));
  EXPECT_LE(report.meshed, report.examined);
  EXPECT_LE(report.examined, 27u);
  EXPECT_LT(report.changed.size(), 20u);
  EXPECT_FALSE(report.changed.empty());
  // Patches that somebody holds stay as they were; those not reported are the same objects.
  for (const auto& [key, patch] : old) {
    const bool changed = std::binary_search(report.changed.begin(), report.changed.end(), key);
    EXPECT_EQ(surface.patches().find(key) == patch.get(), !changed) << toText(key);
  }
}

TEST(Refresh, ofNothingDoesNothing) {
  auto field = ball<8>(20);
  Surface<8> surface = surfaceOf(field);
  const RefreshReport report = surface.refresh(field, Delta<Clay::Block>{});
  EXPECT_EQ(report.examined, 0u);
  EXPECT_TRUE(report.changed.empty());
}

TEST(Refresh, aNewIsoRebuilds) {
  auto field = ball<8>(20);
  Surface<8> surface = surfaceOf(field);
  field.scale.iso = 0.25f;
  surface.refresh(field, std::span<const KeyRun>{});
  EXPECT_TRUE(samePatches(surfaceOf(field), surface));
  EXPECT_EQ(surface.iso(), 0.25f);
}

TEST(Refresh, sameForAnyNumberOfThreads) {
  for (int threads = 1; threads <= 4; ++threads) {
    setThreadCount(threads);
    std::mt19937 random(5);
    auto field = ball<8>(30);
    Surface<8> surface = surfaceOf(field);
    std::vector<Key> changed;
    for (int n = 0; n < 5; ++n) {
      const auto report = surface.refresh(field, randomEdit(field, random));
      changed.insert(changed.end(), report.changed.begin(), report.changed.end());
    }
    static const auto expected = changed;
    EXPECT_EQ(changed, expected);
    EXPECT_TRUE(samePatches(surfaceOf(field), surface));
  }
  setThreadCount(0);
}

template <int Side>
std::int64_t treated(const Delta<CornerBlock<Side>>& delta) {
  return treatedCubes<Side>(changedRuns<Side>(delta));
}

TEST(Refresh, treatedCubesShareADirtyCorner) {
  Clay clay;
  const auto one = testing::fill<8>(clay, {{5, 5, 5}, {5, 5, 5}}, [](Key) { return 1.0f; });
  EXPECT_EQ(treated<8>(one), 8);
  const auto row = testing::fill<8>(clay, {{5, 5, 5}, {5, 5, 9}}, [](Key) { return 0.75f; });
  EXPECT_EQ(treated<8>(row), 2 * 2 * 6);
  const auto same = testing::fill<8>(clay, {{5, 5, 5}, {5, 5, 9}}, [](Key) { return 0.75f; });
  EXPECT_EQ(treated<8>(same), 0);
  const auto box = testing::fill<8>(clay, {{-20, 0, 3}, {-1, 15, 9}}, [](Key) { return 1.0f; });
  EXPECT_EQ(treated<8>(box), 21 * 17 * 8);
  Field<1> small;
  const auto box1 = testing::fill<1>(small, {{-3, 0, 3}, {-1, 5, 9}}, [](Key) { return 1.0f; });
  EXPECT_EQ(treated<1>(box1), 4 * 7 * 8);
}

}  // namespace
}  // namespace bozzetto
