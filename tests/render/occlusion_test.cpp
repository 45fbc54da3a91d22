#include "bozzetto/render/occlusion.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

#include "bozzetto/base/parallel.hpp"
#include "scenes.hpp"

namespace bozzetto {
namespace {

using namespace test;

VertexLight lightAt(const OcclusionVolume& volume, glm::vec3 p, glm::vec3 normal) {
  const Colour colour;
  const std::uint16_t none = 0;
  PatchVertices patch{{}, {&p, 1}, {&normal, 1}, {&colour, 1}, {&none, 1}, {}};
  return lightOf(volume, std::span(&patch, 1), 60)[0][0];
}

TEST(Occlusion, LevelsAreHalvedCopiesOfOccupancy) {
  const Scene scene = sceneOf(ball({0, 0, 0}, 20));
  const OcclusionVolume volume(scene.clay);
  for (int level = 0; level < OcclusionVolume::kLevels; ++level) {
    const int side = 128 >> level, low = -side / 2;
    std::vector<float> texels(std::size_t(side) * side * side);
    volume.read(level, {{low, low, low}, {low + side - 1, low + side - 1, low + side - 1}}, texels);
    double sum = 0;
    for (const float t : texels) sum += t;
    const double cells = sum * std::pow(8, level), expected = 4. / 3 * 3.14159265 * 8000;
    if (level < 5) {
      EXPECT_NEAR(cells, expected, expected * .01) << level;
    }
  }
}

TEST(Occlusion, ReadOfAPartIsThePartOfARead) {
  const Scene scene = sceneOf(ball({3, 1, -2}, 18));
  const OcclusionVolume volume(scene.clay);
  for (const int level : {0, 1, 2}) {
    const KeyBox all{{-20, -20, -20}, {19, 19, 19}}, part{{-7, 2, -13}, {4, 9, 11}};
    std::vector<float> whole(40 * 40 * 40), piece(std::size_t(part.count()));
    volume.read(level, all, whole);
    volume.read(level, part, piece);
    std::size_t n = 0;
    for (int i = part.low.i; i <= part.high.i; ++i) {
      for (int j = part.low.j; j <= part.high.j; ++j) {
        for (int k = part.low.k; k <= part.high.k; ++k) {
          ASSERT_EQ(piece[n++], whole[std::size_t(((i + 20) * 40 + j + 20) * 40 + k + 20)]);
        }
      }
    }
  }
}

TEST(Occlusion, PlaneIsOpenCreaseIsDarkPitIsDarker) {
  const Distance slab = box({0, -20, 0}, {36, 20, 36});
  const Distance step = blended(slab, box({-20, 0, 0}, {20, 30, 36}), 1);
  const Distance pit = cut(slab, box({0, 0, 0}, {5, 24, 5}));
  const glm::vec3 up(0, 1, 0);
  const VertexLight flat = lightAt(OcclusionVolume(sceneOf(slab).clay), {0, 0, 0}, up);
  const VertexLight crease = lightAt(OcclusionVolume(sceneOf(step).clay), {2, 0, 0}, up);
  const VertexLight deep = lightAt(OcclusionVolume(sceneOf(pit).clay), {0, -24, 0}, up);
  EXPECT_GT(flat.open, .93f);
  EXPECT_NEAR(flat.cavity, 0, .1);
  EXPECT_GT(glm::dot(flat.bent, up), .99f);
  EXPECT_LT(crease.open, .8f);
  EXPECT_GT(crease.cavity, .3f);
  EXPECT_GT(crease.bent.x, .1f);  // away from the wall
  EXPECT_LT(deep.open, .25f);
}

TEST(Occlusion, RidgesHaveNegativeCavity) {
  const OcclusionVolume volume(sceneOf(box({0, 0, 0}, {16, 16, 16})).clay);
  EXPECT_LT(lightAt(volume, {15.5f, 15.5f, 0}, glm::normalize(glm::vec3(1, 1, 0))).cavity, -.4f);
}

// The field's slope is a matter of which tool made it; shading must not tell.
TEST(Occlusion, SoftAndHardClayShadeAlike) {
  const Distance solid = blended(ball({-8, 0, 0}, 14), ball({10, 0, 0}, 12), 2);
  const Scene hard = sceneOf(solid, {.softness = 2}), soft = sceneOf(solid, {.softness = 16});
  const OcclusionVolume a(hard.clay), b(soft.clay);
  for (const glm::vec3 n : {glm::vec3(-1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(-.6, .8, 0)}) {
    const glm::vec3 p = glm::vec3(-8, 0, 0) + n * 14.f;
    EXPECT_NEAR(lightAt(a, p, n).open, lightAt(b, p, n).open, .04);
    EXPECT_NEAR(lightAt(a, p, n).cavity, lightAt(b, p, n).cavity, .08);
  }
}

TEST(Occlusion, RefreshEqualsMakingAnew) {
  Scene scene = sceneOf(ball({0, 0, 0}, 24));
  OcclusionVolume kept(scene.clay);
  std::mt19937 random(11);
  for (int round = 0; round < 5; ++round) {
    Edit<Clay::Block> edit(scene.clay.tree);
    for (int n = 0; n < 6; ++n) {
      const auto place = [&] { return int(random() % 8) - 4; };
      Clay::Block& block = edit.write({place(), place(), place()});
      for (float& v : block.value) v = float(random() % 3) / 2;
      block.updateRange();
    }
    const auto delta = edit.commit();
    kept.refresh(scene.clay, delta.keys());
    const OcclusionVolume made(scene.clay);
    const KeyBox box{{-40, -40, -40}, {39, 39, 39}};
    std::vector<float> a(std::size_t(box.count())), b(a.size());
    for (int level = 0; level < OcclusionVolume::kLevels; ++level) {
      kept.read(level, box, a);
      made.read(level, box, b);
      ASSERT_EQ(a, b) << "level " << level << " round " << round;
    }
  }
}

TEST(Occlusion, FloorIsDarkestUnderTheClay) {
  const Scene scene = sceneOf(ball({0, 0, 0}, 20));
  const CellBounds bounds{glm::dvec3(-20), glm::dvec3(20)};
  const auto floor = floorOcclusion(OcclusionVolume(scene.clay), Stage::around(bounds), bounds);
  const int side = FloorOcclusion::kSide;
  EXPECT_LT(floor.texels[std::size_t(side * side / 2 + side / 2)], 110);
  EXPECT_GT(floor.texels[0], 235);
  EXPECT_TRUE(floorOcclusion(OcclusionVolume(), Stage(), {}).texels.empty());
}

}  // namespace
}  // namespace bozzetto
