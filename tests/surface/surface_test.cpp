#include "bozzetto/surface/surface.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "bozzetto/base/parallel.hpp"
#include "bozzetto/base/simd.hpp"
#include "surface/surface_fields.hpp"

namespace bozzetto {
namespace {

using testing::ball;
using testing::fieldOf;
using testing::samePatches;
using testing::solid;
using testing::surfaceOf;

// What random fields are made of: smooth, exactly iso, hard, and full next to nothing.
float randomValue(std::mt19937& random, int kind) {
  const float uniform = std::uniform_real_distribution<float>(0, 1)(random);
  const auto pick = random() % 4;
  switch (kind) {
    case 0:
      return uniform;
    case 1:
      return pick < 2 ? 0.0f : 1.0f;
    case 2:
      return pick == 0 ? 0.5f : pick == 1 ? 0.0f : pick == 2 ? 1.0f : uniform;
    case 3:
      return pick == 0 ? std::nextafter(0.5f, 0.0f) : pick == 1 ? 0.5f : 1e-30f;
    default:
      return pick == 0 ? 1.0f : 0.0f;
  }
}

TEST(Surface, ofNothingIsNothing) {
  const Clay clay;
  const auto surface = surfaceOf(clay);
  EXPECT_TRUE(surface.patches().empty());
  EXPECT_TRUE(weld(surface, clay.scale).triangles.empty());
  EXPECT_EQ(surface.validate(), std::nullopt);
}

TEST(Surface, randomFieldsAreClosedAndManifold) {
  for (unsigned seed = 0; seed < 3000; ++seed) {
    std::mt19937 random(seed);
    const int size = 2 + static_cast<int>(seed % 5);
    const auto field = fieldOf<8>(size, [&](Key) { return randomValue(random, seed % 5); });
    const auto mesh = weld(surfaceOf(field), field.scale);
    if (mesh.triangles.empty()) continue;
    ASSERT_TRUE(solid(mesh)) << "seed " << seed;
    ASSERT_GT(signedVolume(mesh), 0) << "seed " << seed;
  }
}

TEST(Surface, randomFieldsOverManyBlocksToo) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    std::mt19937 random(seed);
    const auto field = fieldOf<8>(19, [&](Key) { return randomValue(random, seed % 5); });
    const auto surface = surfaceOf(field);
    ASSERT_EQ(surface.validate(), std::nullopt);
    ASSERT_TRUE(solid(weld(surface, field.scale))) << "seed " << seed;
  }
}

TEST(Surface, fullBlocksNextToNothing) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    Clay clay;
    Edit<Clay::Block> edit(clay.tree);
    const auto full = Clay::Block::uniform(1, packAttributes({}));
    for (int n = 0; n < 64; ++n)
      if (random() % 3 == 0) edit.replace({{n / 16, n / 4 % 4, n % 4}, 1}, full);
    edit.replace({{9, 0, -5}, 300}, full);
    edit.commit();
    const auto surface = surfaceOf(clay);
    const auto mesh = weld(surface, clay.scale);
    ASSERT_TRUE(solid(mesh)) << "seed " << seed;
    // Half a cell more than the corners on every side, edges and corners of the box cut off.
    ASSERT_GT(signedVolume(mesh), 7.0 * 7 * 7);
  }
}

TEST(Surface, ballIsABall) {
  const double r = 30, pi = std::numbers::pi;
  const auto field = ball<8>(30, {3, -5, 7}, {10, 200, 30});
  const auto surface = surfaceOf(field);
  EXPECT_EQ(surface.validate(), std::nullopt);
  const auto mesh = weld(surface, {2.0, 0.5f});
  const MeshReport report = checkMesh(mesh);
  ASSERT_TRUE(isSolid(report));
  EXPECT_EQ(report.components, 1u);
  EXPECT_EQ(report.genus(), 0);
  EXPECT_EQ(report.unusedVertices, 0u);
  EXPECT_NEAR(report.volume, 8 * 4 / 3.0 * pi * r * r * r, 0.002 * report.volume);
  EXPECT_NEAR(report.area, 4 * 4 * pi * r * r, 0.002 * report.area);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const glm::dvec3 out = mesh.positions[v] / 2.0 - glm::dvec3(3, -5, 7);
    const double length = std::sqrt(out.x * out.x + out.y * out.y + out.z * out.z);
    ASSERT_NEAR(length, r, 0.01);
    const auto& n = mesh.normals[v];
    // Within 0.45 degrees, although the slope is cut off two cells from where differences reach.
    ASSERT_GT((out.x * n.x + out.y * n.y + out.z * n.z) / length, 0.99997);
    ASSERT_EQ(mesh.colours[v], (Colour{10, 200, 30}));
  }
}

TEST(Surface, coloursAreMixedByPlace) {
  Clay clay;
  Edit<Clay::Block> edit(clay.tree);
  const auto put = [&](Key corner, float value, Colour colour, std::uint8_t hold) {
    auto& block = edit.write(Clay::Geometry::blockOf(corner));
    block.value[Clay::Geometry::indexOf(corner)] = value;
    block.attributes[Clay::Geometry::indexOf(corner)] = packAttributes(colour, hold);
  };
  put({2, 2, 2}, 1.0f, {100, 0, 255}, 255);
  put({3, 2, 2}, 0.25f, {0, 200, 255}, 55);
  edit.commit();
  const auto surface = surfaceOf(clay);
  const PatchContent content = surface.patches().find({0, 0, 0})->content();
  ASSERT_EQ(content.vertices.size(), 6u);
  for (std::size_t n = 0; n < 6; ++n) {
    const PatchVertex& vertex = content.vertices[n];
    const bool between = vertex.position[0] > 2;
    // Two thirds of the way to the pale corner; the other five ends of edges hold no clay.
    const std::array<std::uint8_t, 4> expected =
        between ? std::array<std::uint8_t, 4>{33, 134, 255, 121}
                : std::array<std::uint8_t, 4>{100, 0, 255, 255};
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(vertex.colour[c], expected[c], 1);
  }
}

float torus(Key p) {
  const double ring = std::hypot(p.i - 15.5, p.k - 15.2) - 9;
  return static_cast<float>(std::clamp(0.5 + (4.3 - std::hypot(ring, p.j - 15.1)) / 2, 0.0, 1.0));
}

TEST(Surface, torusHasOneHandle) {
  const auto field = fieldOf<8>(32, torus);
  const auto report = checkMesh(weld(surfaceOf(field), field.scale));
  ASSERT_TRUE(isSolid(report));
  EXPECT_EQ(report.genus(), 1);
  EXPECT_EQ(report.components, 1u);
}

TEST(Surface, measuresWhatTheWeldedMeshMeasures) {
  auto field = ball<8>(6.2f);
  testing::fill<8>(field, {{40, 0, 0}, {47, 7, 7}}, [](Key) { return 1.0f; });
  const auto surface = surfaceOf(field);
  const auto report = checkMesh(weld(surface, field.scale));
  EXPECT_NEAR(measure(surface).volume, report.volume, 1e-4 * report.volume);
  EXPECT_NEAR(measure(surface).area, report.area, 1e-4 * report.area);
  EXPECT_EQ(measure(Surface<8>()).volume, 0);
}

TEST(Surface, statisticsCountWhatIsThere) {
  auto field = ball<8>(6.2f);
  testing::fill<8>(field, {{40, 0, 0}, {47, 7, 7}}, [](Key) { return 1.0f; });
  const auto surface = surfaceOf(field);
  const SurfaceStatistics s = statistics(surface, field);
  const auto report = checkMesh(weld(surface, field.scale));
  EXPECT_EQ(s.components, 2);
  EXPECT_EQ(static_cast<std::size_t>(s.triangles), report.triangles);
  EXPECT_EQ(static_cast<std::size_t>(s.edges), report.vertices);
  std::int64_t cubes = 0;
  for (int i = -20; i < 60; ++i)
    for (int j = -20; j < 20; ++j)
      for (int k = -20; k < 20; ++k) {
        bool stored = false;
        for (int n = 0; n < 8; ++n)
          stored |= field.value({i + (n >> 2), j + (n >> 1 & 1), k + (n & 1)}) > 0;
        cubes += stored ? 1 : 0;
      }
  EXPECT_EQ(s.cubes, cubes);
  const auto one = withSide<1>(field);
  EXPECT_EQ(statistics(surfaceOf(one), one).cubes, cubes);
}

TEST(Surface, aLongSolidRunIsNotWalked) {
  Clay clay;
  Edit<Clay::Block> edit(clay.tree);
  const auto full = Clay::Block::uniform(1, packAttributes({}));
  constexpr std::int32_t length = 1 << 20;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) edit.replace({{i, j, 0}, length}, full);
  edit.commit();
  edit.replace({{1, 1, 1000}, 1}, nullptr);
  const Delta<Clay::Block> delta = edit.commit();
  // The surface of the outer rows is long and real; look at the hole alone.
  Surface<8> surface;
  surface.refresh(Clay{}, std::span<const KeyRun>{});
  const RefreshReport report = surface.refresh(clay, delta);
  EXPECT_LT(report.examined, 64u);
  const Surface<8> nothing;  // cubes are counted in the field
  constexpr std::int64_t inTheHole = 7 * 7 * 7;
  EXPECT_EQ(statistics(nothing, clay).cubes, 25LL * 25 * (8LL * length + 1) - inTheHole);
}

using PositionSet = std::set<std::array<double, 3>>;

template <int Side>
PositionSet positionsOf(const TriangleMesh& mesh) {
  PositionSet set;
  for (const auto& p : mesh.positions) set.insert({p.x, p.y, p.z});
  return set;
}

// Triangles as positions and colours, each turned so that its least vertex comes first.
template <int Side>
auto triangleSet(const Field<Side>& field) {
  const TriangleMesh mesh = weld(surfaceOf(field), field.scale);
  std::multiset<std::array<std::array<double, 7>, 3>> set;
  for (auto t : mesh.triangles) {
    std::array<std::array<double, 7>, 3> corners;
    for (int n = 0; n < 3; ++n) {
      const auto& p = mesh.positions[t[n]];
      const auto& v = mesh.normals[t[n]];
      const Colour c = mesh.colours[t[n]];
      corners[n] = {p.x, p.y, p.z, v.x, v.y, v.z, c.r * 65536.0 + c.g * 256.0 + c.b};
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    set.insert(corners);
  }
  return set;
}

TEST(Surface, sideOneAndSideEightGiveTheSameMesh) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    std::mt19937 random(seed);
    Clay eight;
    testing::fill<8>(
        eight, {{-3, 4, -9}, {9, 12, 5}}, [&](Key) { return randomValue(random, seed); },
        Colour{static_cast<std::uint8_t>(seed * 40), 90, 200});
    EXPECT_EQ(triangleSet(eight), triangleSet(withSide<1>(eight))) << seed;
  }
  const auto smooth = ball<8>(11.3f, {4, 1, -2});
  EXPECT_EQ(triangleSet(smooth), triangleSet(withSide<1>(smooth)));
}

Clay noiseAt(Key offset, unsigned seed) {
  std::mt19937 random(seed);
  Clay clay;
  testing::fill<8>(clay, {offset, offset + Key{14, 12, 17}},
                   [&](Key) { return randomValue(random, 2); });
  return clay;
}

TEST(Surface, farAwayIsTheSameBitForBit) {
  constexpr std::int32_t far = 1 << 29;
  const auto here = surfaceOf(noiseAt({0, 0, 0}, 5));
  const auto there = surfaceOf(noiseAt({far, -far, far}, 5));
  EXPECT_TRUE(samePatches(here, there, {far / 8, -far / 8, far / 8}));
  const auto rim = surfaceOf(noiseAt({kWorkspaceRim - 15, -kWorkspaceRim, kWorkspaceRim - 23}, 5));
  EXPECT_EQ(rim.validate(), std::nullopt);
}

TEST(Surface, movedByWholeCellsKeepsItsVertices) {
  const FieldScale scale;
  const Key step{(1 << 29) + 3, -(1 << 29) + 5, 7};
  const auto here = weld(surfaceOf(noiseAt({0, 0, 0}, 6)), scale);
  const auto there = weld(surfaceOf(noiseAt(step, 6)), scale);
  PositionSet moved;
  for (const auto& p : there.positions) moved.insert({p.x - step.i, p.y - step.j, p.z - step.k});
  EXPECT_EQ(moved, positionsOf<8>(here));
}

TEST(Surface, threadsAndInstructionSetsDoNotMatter) {
  const auto field = noiseAt({-5, -6, 3}, 9);
  const auto large = ball<8>(45);
  const auto expected = surfaceOf(field), expectedLarge = surfaceOf(large);
  for (int threads = 1; threads <= 4; ++threads) {
    setThreadCount(threads);
    forbidSimd(threads == 3);
    EXPECT_TRUE(samePatches(expected, surfaceOf(field))) << threads;
    EXPECT_TRUE(samePatches(expectedLarge, surfaceOf(large))) << threads;
  }
  setThreadCount(0);
  forbidSimd(false);
}

}  // namespace
}  // namespace bozzetto
