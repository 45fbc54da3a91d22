#include "bozzetto/mesh/winding.hpp"

#include <gtest/gtest.h>

#include <random>

#include "bozzetto/mesh/check.hpp"
#include "bozzetto/mesh/orient.hpp"
#include "mesh/shapes.hpp"

namespace bozzetto {
namespace {

TEST(WindingTree, IsOneInsideAndZeroOutside) {
  const WindingTree winding(shapes::ball(1, 64, 128));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1.5, 1.5);
  for (int n = 0; n < 2000; ++n) {
    const glm::dvec3 p{coordinate(random), coordinate(random), coordinate(random)};
    const double radius = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    if (std::abs(radius - 1) < 0.01) continue;
    EXPECT_NEAR(winding.at(p), radius < 1 ? 1 : 0, 0.01) << radius;
  }
}

TEST(WindingTree, AddsUpOverlapsAndTakesAwayInwardBodies) {
  auto mesh = shapes::together(shapes::ball(1), shapes::ball(1, 32, 64, {1, 0, 0}));
  EXPECT_NEAR(WindingTree(mesh).at({0.5, 0, 0}), 2, 0.01);
  mesh = shapes::together(shapes::ball(1), shapes::flipped(shapes::ball(0.5)));
  EXPECT_NEAR(WindingTree(mesh).at({0.1, 0, 0}), 0, 0.03);
  EXPECT_NEAR(WindingTree(mesh).at({0.7, 0, 0}), 1, 0.01);
}

// A disc of radius 1 seen from height h fills (1 - h/√(h²+1))/2 of all directions.
TEST(WindingTree, OfADiscIsItsSolidAngle) {
  TriangleMesh disc;
  const int slices = 512;
  disc.positions.push_back({0, 0, 0});
  for (int n = 0; n < slices; ++n) {
    const double u = 2 * std::numbers::pi * n / slices;
    disc.positions.push_back({std::cos(u), 0, std::sin(u)});
    const auto at = [&](int m) { return static_cast<std::uint32_t>(1 + m % slices); };
    disc.triangles.push_back({0, at(n + 1), at(n)});  // normal +y
  }
  const WindingTree winding(disc);
  for (const double h : {0.05, 0.3, 1.0, 4.0}) {
    const double expected = (1 - h / std::sqrt(h * h + 1)) / 2;
    EXPECT_NEAR(winding.at({0, h, 0}), -expected, 1e-3) << h;
    EXPECT_NEAR(winding.at({0, -h, 0}), expected, 1e-3) << h;
  }
}

TEST(WindingTree, OfNothingIsZero) { EXPECT_EQ(WindingTree({}).at({1, 2, 3}), 0); }

TEST(OrientOutward, LeavesGoodMeshesAlone) {
  auto mesh =
      shapes::together(shapes::torus(24, 12), shapes::flipped(shapes::ball(0.2, 8, 8, {2, 0, 0})));
  const auto before = mesh.triangles;
  EXPECT_EQ(orientOutward(mesh), 0u);
  EXPECT_EQ(mesh.triangles, before);
}

TEST(OrientOutward, TurnsAnInwardMesh) {
  auto mesh = shapes::flipped(shapes::ball(1));
  EXPECT_EQ(orientOutward(mesh), mesh.triangles.size());
  EXPECT_GT(signedVolume(mesh), 0);
}

TEST(OrientOutward, TurnsSingleTriangles) {
  auto mesh = shapes::torus(24, 12);
  const double volume = signedVolume(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 5) {
    std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
  }
  EXPECT_FALSE(isSolid(checkMesh(mesh)));
  orientOutward(mesh);
  EXPECT_TRUE(isSolid(checkMesh(mesh)));
  EXPECT_DOUBLE_EQ(signedVolume(mesh), volume);
}

TEST(OrientOutward, TurnsAnInwardPartBesideOthersButKeepsACavity) {
  auto beside =
      shapes::together(shapes::ball(1), shapes::flipped(shapes::ball(0.5, 16, 32, {3, 0, 0})));
  EXPECT_EQ(orientOutward(beside), shapes::ball(0.5, 16, 32).triangles.size());
  auto cavity = shapes::together(shapes::ball(1), shapes::flipped(shapes::ball(0.5)));
  EXPECT_EQ(orientOutward(cavity), 0u);
}

TEST(OrientOutward, KnowsTheOutsideOfAnOpenBowl) {
  auto ball = shapes::ball(1);
  std::erase_if(ball.triangles, [&](auto& t) { return ball.positions[t[0]].y > 0.3; });
  auto mesh = shapes::flipped(ball);
  EXPECT_EQ(orientOutward(mesh), mesh.triangles.size());
  EXPECT_EQ(orientOutward(ball), 0u);
}

}  // namespace
}  // namespace bozzetto
