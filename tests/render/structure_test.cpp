#include "bozzetto/render/structure.hpp"

#include <gtest/gtest.h>

#include <set>

#include "bozzetto/field/sampler.hpp"
#include "bozzetto/render/dresser.hpp"
#include "scenes.hpp"

namespace bozzetto {
namespace {

using namespace test;

// Area of all sides and the volume they close, in cells.
struct Measured {
  double area = 0, volume = 0;
};
Measured measure(const std::vector<UnpackedPatch>& patches) {
  Measured sum;
  for (const UnpackedPatch& patch : patches) {
    const glm::dvec3 corner(patch.origin.i, patch.origin.j, patch.origin.k);
    for (std::size_t n = 0; n < patch.indices.size(); n += 3) {
      const glm::dvec3 a = corner + glm::dvec3(patch.positions[patch.indices[n]]);
      const glm::dvec3 b = corner + glm::dvec3(patch.positions[patch.indices[n + 1]]);
      const glm::dvec3 c = corner + glm::dvec3(patch.positions[patch.indices[n + 2]]);
      sum.area += glm::length(glm::cross(b - a, c - a)) / 2;
      sum.volume += glm::dot(a, glm::cross(b, c)) / 6;
    }
  }
  return sum;
}

// The sides of the cubes close exactly as much space as there are cubes.
TEST(Structure, SidesCloseTheCubes) {
  const Scene scene = sceneOf(blended(ball({0, 0, 0}, 13), ball({14, 9, -7}, 6), 3), {.half = 30});
  FieldSampler<8> sampler(scene.clay);
  int cubes = 0, crossing = 0;
  for (int i = -31; i < 31; ++i) {
    for (int j = -31; j < 31; ++j) {
      for (int k = -31; k < 31; ++k) {
        int clay = 0, inside = 0;
        for (int n = 0; n < 8; ++n) {
          const float v = sampler.corner(Key{i, j, k} + Key{n >> 2 & 1, n >> 1 & 1, n & 1});
          clay += v > 0;
          inside += v >= .5f;
        }
        cubes += clay > 0;
        crossing += inside > 0 && inside < 8;
      }
    }
  }
  const auto volumeOf = [&](Structure structure) {
    return measure(structurePatches(scene.surface, scene.clay, structure)).volume;
  };
  EXPECT_NEAR(volumeOf(Structure::cubes), cubes, 1e-6);
  EXPECT_NEAR(volumeOf(Structure::crossingCubes), crossing, 1e-6);
  EXPECT_EQ(crossing, scene.surface.totals().crossingCubes);
}

TEST(Structure, NamesAreKnown) {
  EXPECT_EQ(parseStructure("crossing-cubes"), Structure::crossingCubes);
  EXPECT_THROW(parseStructure("bones"), Error);
}

using Named = std::map<std::pair<Key, Fineness>, std::vector<glm::vec3>>;
void take(Named& named, const std::vector<UnpackedPatch>& patches) {
  for (const UnpackedPatch& patch : patches) {
    const auto name = std::pair(patch.origin, patch.fineness);
    if (patch.indices.empty()) {
      named.erase(name);
    } else {
      named[name] = patch.positions;
    }
  }
}

// After a change the dresser's patches are those of a dresser that starts afresh.
TEST(Dresser, RefreshedEqualsRebuilt) {
  Scene scene = sceneOf(ball({0, 0, 0}, 20), {.half = 40});
  Dresser dresser;
  Named refreshed, rebuilt;
  take(refreshed, dresser.rebuild(scene.clay, scene.surface));
  Edit<CornerBlock<8>> edit(scene.clay.tree);
  for (const Key gone : {Key{1, 1, 1}, Key{-2, 0, 0}, Key{2, 0, 0}}) {
    edit.replace({gone, 1}, nullptr);
  }
  const auto delta = edit.commit();
  const auto report = scene.surface.refresh(scene.clay, delta);
  take(refreshed, dresser.refresh(scene.clay, scene.surface, delta.keys(), report.changed));
  Dresser other;
  take(rebuilt, other.rebuild(scene.clay, scene.surface));
  EXPECT_EQ(refreshed, rebuilt);
  EXPECT_FALSE(dresser.settle(scene.surface).empty());
  while (!dresser.settle(scene.surface, 16).empty()) {
  }
}

// Half as fine: a quarter of the triangles, close to the same place.
TEST(Dresser, CoarseClayIsNear) {
  const Scene scene = sceneOf(ball({3, -2, 5}, 24), {.half = 40});
  Dresser dresser;
  std::size_t fine = 0, coarse = 0;
  double worst = 0;
  for (const UnpackedPatch& patch : dresser.rebuild(scene.clay, scene.surface)) {
    (patch.fineness == Fineness::fine ? fine : coarse) += patch.indices.size() / 3;
    const glm::dvec3 corner(patch.origin.i, patch.origin.j, patch.origin.k);
    for (const glm::vec3& p : patch.positions) {
      const double radius = glm::distance(corner + glm::dvec3(p), glm::dvec3(3, -2, 5));
      worst = std::max(worst, std::abs(radius - 24));
    }
    ASSERT_EQ(patch.light.size(), patch.positions.size());
  }
  EXPECT_LT(coarse, fine / 3);
  EXPECT_GT(coarse, fine / 6);
  EXPECT_LT(worst, .35);
}

}  // namespace
}  // namespace bozzetto
