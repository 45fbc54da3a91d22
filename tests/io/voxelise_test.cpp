// Clay from meshes: the right shape, the right slope, whatever is wrong with the mesh.
#include "bozzetto/io/voxelise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <numbers>

#include "bozzetto/base/error.hpp"
#include "bozzetto/base/parallel.hpp"
#include "bozzetto/io/mesh_file.hpp"
#include "bozzetto/surface/welded.hpp"
#include "mesh/shapes.hpp"

namespace bozzetto {
namespace {

struct Imported {
  Clay clay;
  ImportReport report;
};

Imported import(const TriangleMesh& mesh, const ImportOptions& options) {
  Imported result;
  Edit<CornerBlock<8>> edit(result.clay.tree);
  result.report = voxelise(mesh, options, edit);
  edit.commit();
  result.clay.scale.spacing = result.report.spacing;
  EXPECT_EQ(validate(result.clay), std::nullopt);
  return result;
}

Imported importAt(const TriangleMesh& mesh, double spacing) {
  ImportOptions options;
  options.spacing = spacing;
  return import(mesh, options);
}

MeshReport surfaceOf(const Clay& clay) {
  Surface<8> surface;
  surface.rebuild(clay);
  return checkMesh(weld(surface, clay.scale));
}

double massOf(const Imported& imported) { return statistics(imported.clay).mass; }

TEST(Voxelise, ABallHasTheValuesOfItsDistance) {
  const double radius = 20;
  const auto ball = importAt(shapes::ball(radius, 128, 256), 1);
  for (int i = -24; i <= 24; ++i) {
    for (int j = -24; j <= 24; ++j) {
      for (int k = -24; k <= 24; ++k) {
        const double distance = std::sqrt(i * i + j * j + k * k) - radius;
        const double expected = std::clamp(0.5 - distance / 2, 0.0, 1.0);
        // Facets of 1.4° lie up to 0.003 cells inside the ball.
        ASSERT_NEAR(ball.clay.value({i, j, k}), expected, 0.004) << i << ' ' << j << ' ' << k;
      }
    }
  }
  EXPECT_LT(ball.report.fitMax, 0.05);
  EXPECT_EQ(ball.report.parts, 1u);
  EXPECT_EQ(ball.report.openEdges, 0u);
  // A slope of two cells adds 4πr/3 to the ball.
  EXPECT_NEAR(massOf(ball), 4.0 / 3 * std::numbers::pi * (radius * radius * radius + radius), 12);
}

TEST(Voxelise, ACubeOnTheGridFitsExactly) {
  ImportOptions options;
  options.cells = 64;
  const auto cube = import(shapes::cube(), options);
  EXPECT_EQ(cube.report.spacing, 1.0 / 64);
  EXPECT_EQ(cube.report.fitMax, 0);
  EXPECT_EQ(cube.clay.value({0, 10, 10}), 0.5f);
  EXPECT_EQ(cube.clay.value({1, 10, 10}), 1.0f);
  EXPECT_EQ(cube.clay.value({-1, 10, 10}), 0.0f);
}

TEST(Voxelise, InteriorCostsNoBlocks) {
  const auto ball = importAt(shapes::ball(120, 64, 128), 1);
  const auto statistics = bozzetto::statistics(ball.clay);
  EXPECT_GT(statistics.corners, 7'000'000);
  EXPECT_LT(statistics.blocks, 6'000u);
  EXPECT_EQ(ball.clay.value({0, 0, 0}), 1.0f);
}

TEST(Voxelise, TheSurfaceIsASolidOfTheSameGenus) {
  const auto torus = importAt(shapes::torus(96, 48, 20, 8), 1);
  const auto report = surfaceOf(torus.clay);
  EXPECT_TRUE(isSolid(report));
  EXPECT_EQ(report.genus(), 1);
  EXPECT_EQ(report.components, 1u);
  const double volume = 2 * std::numbers::pi * std::numbers::pi * 20 * 64;
  EXPECT_NEAR(report.volume / volume, 1, 0.01);
}

TEST(Voxelise, WindingDoesNotMatter) {
  const auto good = importAt(shapes::torus(96, 48, 20, 8), 1);
  const auto inward = importAt(shapes::flipped(shapes::torus(96, 48, 20, 8)), 1);
  EXPECT_EQ(fieldHash(good.clay), fieldHash(inward.clay));
  auto mixed = shapes::torus(96, 48, 20, 8);
  for (std::size_t t = 0; t < mixed.triangles.size(); t += 3) {
    std::swap(mixed.triangles[t][0], mixed.triangles[t][1]);
  }
  const auto turned = importAt(mixed, 1);
  EXPECT_EQ(turned.report.turned, (mixed.triangles.size() + 2) / 3);
  EXPECT_NEAR(massOf(turned), massOf(good), 1e-3 * massOf(good));
}

TEST(Voxelise, SoupIsWelded) {
  const auto good = importAt(shapes::ball(12), 1);
  const auto soup = importAt(shapes::soup(shapes::ball(12)), 1);
  EXPECT_EQ(soup.report.openEdges, 0u);
  EXPECT_EQ(fieldHash(good.clay), fieldHash(soup.clay));
}

TEST(Voxelise, OverlappingBodiesBecomeOneWithoutWallsInside) {
  const auto both = importAt(
      shapes::together(shapes::ball(16, 64, 128), shapes::ball(16, 64, 128, {16.3, 0.2, 0.1})), 1);
  EXPECT_EQ(both.report.parts, 2u);
  // Where one ball's skin runs through the other all is full.
  for (int i = -12; i <= 28; ++i) EXPECT_EQ(both.clay.value({i, 0, 0}), 1.0f) << i;
  const auto report = surfaceOf(both.clay);
  EXPECT_TRUE(isSolid(report));
  EXPECT_EQ(report.components, 1u);
  EXPECT_EQ(report.genus(), 0);
  const double d = 16.3, r = 16;  // two balls less their lens
  const double volume = 8.0 / 3 * std::numbers::pi * r * r * r -
                        std::numbers::pi * (4 * r + d) * (2 * r - d) * (2 * r - d) / 12;
  EXPECT_NEAR(report.volume / volume, 1, 0.005);
}

// Faces on the first or last corners of blocks, whose other side is the next block's.
TEST(Voxelise, FacesInsideOtherBodiesLeaveNoBubbles) {
  TriangleMesh mesh;
  for (const double at : {0.0, 2.0})
    for (const glm::dvec3 place : {glm::dvec3(0), {10, 0, 0}, {0, 10, 0}, {0, 0, 10}})
      mesh.positions.push_back(place + at);
  for (const std::uint32_t n : {0u, 4u})
    for (const TriangleMesh::Triangle& t :
         {TriangleMesh::Triangle{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}})
      mesh.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  for (const double spacing : {0.125, 0.25, 0.5}) {
    const auto report = surfaceOf(importAt(mesh, spacing).clay);
    EXPECT_EQ(report.components, 1u) << spacing;
  }
}

TEST(Voxelise, ACavityStaysHollow) {
  const auto hollow =
      importAt(shapes::together(shapes::ball(20), shapes::flipped(shapes::ball(10))), 1);
  EXPECT_EQ(hollow.clay.value({0, 0, 0}), 0.0f);
  EXPECT_EQ(hollow.clay.value({15, 0, 0}), 1.0f);
  EXPECT_EQ(surfaceOf(hollow.clay).components, 2u);
}

// The ½ level of the winding number of a bowl is the disc over its rim.
TEST(Voxelise, AnOpenBowlIsClosedFlatWithTheSameSlope) {
  auto bowl = shapes::ball(24, 64, 128);
  std::erase_if(bowl.triangles, [&](auto& t) {
    return bowl.positions[t[0]].y + bowl.positions[t[1]].y + bowl.positions[t[2]].y > 1e-9;
  });
  for (auto& p : bowl.positions) p += glm::dvec3(0.31, 0, 0.17);
  const auto half = importAt(bowl, 1);
  EXPECT_EQ(half.report.openEdges, 128u);
  for (int i = -15; i <= 15; ++i) {
    for (int k = -15; k <= 15; ++k) {
      ASSERT_NEAR(half.clay.value({i, 0, k}), 0.5, 0.1) << i << ' ' << k;
      ASSERT_NEAR(half.clay.value({i, -1, k}), 1, 0.1);
      ASSERT_NEAR(half.clay.value({i, 1, k}), 0, 0.1);
    }
  }
  const auto report = surfaceOf(half.clay);
  EXPECT_TRUE(isSolid(report));
  EXPECT_EQ(report.components, 1u);
  EXPECT_EQ(report.genus(), 0);
  EXPECT_NEAR(report.volume / (2.0 / 3 * std::numbers::pi * 24 * 24 * 24), 1, 0.01);
}

TEST(Voxelise, ColoursComeFromTheNearestSurface) {
  auto mesh = shapes::ball(16);
  for (const auto& p : mesh.positions) {
    mesh.colours.push_back(p.x > 0 ? Colour{200, 0, 0} : Colour{0, 0, 200});
  }
  ImportOptions options;
  options.spacing = 1;
  options.colour = {1, 2, 3};
  const auto ball = import(mesh, options);
  EXPECT_EQ(colourOf(ball.clay.attributes({16, 0, 0})), (Colour{200, 0, 0}));
  EXPECT_EQ(colourOf(ball.clay.attributes({-16, 0, 0})), (Colour{0, 0, 200}));
  EXPECT_EQ(colourOf(ball.clay.attributes({0, 0, 0})), (Colour{1, 2, 3}));
}

TEST(Voxelise, IsTheSameOnAnyNumberOfThreadsAndAnywhere) {
  auto mesh = shapes::torus(40, 20, 20, 8);
  for (auto& p : mesh.positions) p = glm::dvec3(glm::round(p * 16.0)) / 16.0;
  const auto here = importAt(mesh, 1);
  setThreadCount(1);
  EXPECT_EQ(fieldHash(importAt(mesh, 1).clay), fieldHash(here.clay));
  setThreadCount(0);
  for (auto& p : mesh.positions) p += glm::dvec3(1 << 29, -(1 << 29), 1 << 29);
  const auto far = importAt(mesh, 1);
  EXPECT_EQ(massOf(far), massOf(here));
  EXPECT_EQ(far.report.fitMax, here.report.fitMax);
}

TEST(Voxelise, KeepsTheGreaterOfOldAndNewClay) {
  Imported both;
  for (const double x : {0.0, 14.0}) {
    Edit<CornerBlock<8>> edit(both.clay.tree);
    ImportOptions options;
    options.spacing = 1;
    voxelise(shapes::ball(10, 64, 128, {x, 0, 0}), options, edit);
    edit.commit();
  }
  EXPECT_EQ(validate(both.clay), std::nullopt);
  const auto report = surfaceOf(both.clay);
  EXPECT_EQ(report.components, 1u);
  EXPECT_EQ(both.clay.value({-5, 0, 0}), 1.0f);
  EXPECT_EQ(both.clay.value({20, 0, 0}), 1.0f);
}

class Stopper : public Progress {
 public:
  bool report(std::string_view, double) override { return ++calls_ < 3; }

 private:
  int calls_ = 0;
};

TEST(Voxelise, StopsWhenAskedAndLeavesNothing) {
  Clay clay;
  {
    Edit<CornerBlock<8>> edit(clay.tree);
    Stopper stopper;
    EXPECT_THROW(voxelise(shapes::ball(50), {}, edit, stopper), Cancelled);
  }
  EXPECT_TRUE(clay.tree.empty());
}

void expectRefused(const TriangleMesh& mesh, const ImportOptions& options) {
  Clay clay;
  {
    Edit<CornerBlock<8>> edit(clay.tree);
    EXPECT_THROW(voxelise(mesh, options, edit), Error);
  }
  EXPECT_TRUE(clay.tree.empty());
}

TEST(Voxelise, RefusesWhatHasNoVolumeOrNoPlace) {
  auto flat = shapes::cube();
  for (auto& p : flat.positions) p.y = 3;
  expectRefused(flat, {});
  expectRefused({}, {});
  auto point = shapes::cube();
  for (auto& p : point.positions) p = {1, 2, 3};
  expectRefused(point, {});
  expectRefused(shapes::cube(), {.cells = -1});
  expectRefused(shapes::cube(), {.cells = 1e300});
  expectRefused(shapes::cube(), {.spacing = std::nan("")});
  auto far = shapes::cube();
  for (auto& p : far.positions) p.x += 1e12;
  expectRefused(far, {.spacing = 1});
  auto needle = shapes::cube();
  for (auto& p : needle.positions) p.x *= 1e300;
  expectRefused(needle, {.spacing = 1});
}

TEST(Voxelise, AScanBecomesOneSolid) {
  const char* folder = std::getenv("BOZZETTO_TEST_MESHES");
  ASSERT_NE(folder, nullptr) << "run ./test, or tests/fetch_meshes.sh DEST and set "
                                "BOZZETTO_TEST_MESHES=DEST";
  const auto mesh = readMesh(std::string(folder) + "/cgal/bunny00.off");
  const auto bunny = import(mesh, {});
  EXPECT_LT(bunny.report.fitMean, 0.05);
  const auto report = surfaceOf(bunny.clay);
  EXPECT_TRUE(isSolid(report));
  EXPECT_EQ(report.components, 1u);
  EXPECT_NEAR(report.volume / signedVolume(mesh), 1, 0.002);
}

// Scans with holes, with the size of what should come out.
TEST(Voxelise, AnOpenScanBecomesOneSolid) {
  const char* folder = std::getenv("BOZZETTO_TEST_MESHES");
  ASSERT_NE(folder, nullptr);
  for (const char* name : {"mannequin-devil.off", "head.off", "nefertiti.off"}) {
    const auto open = import(readMesh(std::string(folder) + "/cgal/" + name), {});
    EXPECT_GT(open.report.openEdges, 0u) << name;
    const auto report = surfaceOf(open.clay);
    EXPECT_TRUE(isSolid(report)) << name;
    EXPECT_EQ(report.components, 1u) << name;
    EXPECT_LT(open.report.fitMean, 0.1) << name;
  }
}

}  // namespace
}  // namespace bozzetto
