#include "bozzetto/mesh/check.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "bozzetto/base/error.hpp"
#include "bozzetto/mesh/weld.hpp"
#include "mesh/shapes.hpp"

namespace bozzetto {
namespace {

TEST(CheckMesh, KnowsTheCube) {
  const auto report = checkMesh(shapes::cube());
  EXPECT_TRUE(isSolid(report));
  EXPECT_EQ(report.vertices, 8u);
  EXPECT_EQ(report.edges, 18u);
  EXPECT_EQ(report.eulerCharacteristic, 2);
  EXPECT_EQ(report.genus(), 0);
  EXPECT_EQ(report.components, 1u);
  EXPECT_DOUBLE_EQ(report.volume, 1);
  EXPECT_DOUBLE_EQ(report.area, 6);
  EXPECT_EQ(report.bounds.max, glm::dvec3(1));
}

TEST(CheckMesh, KnowsTheTorusAndPairs) {
  const auto torus = shapes::torus(24, 12);
  EXPECT_TRUE(isSolid(checkMesh(torus)));
  EXPECT_EQ(checkMesh(torus).genus(), 1);
  EXPECT_GT(checkMesh(torus).volume, 0);
  const auto two = checkMesh(shapes::together(torus, shapes::ball(9)));
  EXPECT_EQ(two.components, 2u);
  EXPECT_EQ(two.genus(), 1);
}

TEST(CheckMesh, FlippingChangesTheSignOfTheVolumeOnly) {
  const auto report = checkMesh(shapes::flipped(shapes::cube()));
  EXPECT_TRUE(isSolid(report));
  EXPECT_DOUBLE_EQ(report.volume, -1);
}

TEST(CheckMesh, VolumeIsGoodFarFromTheOrigin) {
  auto mesh = shapes::cube();
  for (auto& p : mesh.positions) p += glm::dvec3(1e9, -1e9, 1e9);
  EXPECT_NEAR(signedVolume(mesh), 1, 1e-6);
}

TEST(CheckMesh, SeesAHole) {
  auto mesh = shapes::cube();
  mesh.triangles.pop_back();
  const auto report = checkMesh(mesh);
  EXPECT_FALSE(report.closed());
  EXPECT_TRUE(report.manifold());
  EXPECT_TRUE(report.oriented());
  EXPECT_EQ(report.openEdges, 3u);
  EXPECT_FALSE(report.genus().has_value());
}

TEST(CheckMesh, SeesOneFlippedTriangle) {
  auto mesh = shapes::cube();
  std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
  const auto report = checkMesh(mesh);
  EXPECT_FALSE(report.oriented());
  EXPECT_FALSE(report.closed());
  EXPECT_TRUE(report.manifold());
  EXPECT_EQ(report.repeatedEdges, 3u);
}

TEST(CheckMesh, SeesCubesThatShareACornerOrAnEdge) {
  auto corner = shapes::cube();
  for (auto& p : corner.positions) p += glm::dvec3(1);
  auto atCorner = shapes::together(shapes::cube(), corner);
  weldVertices(atCorner);
  EXPECT_EQ(checkMesh(atCorner).pinchedVertices, 1u);
  EXPECT_EQ(checkMesh(atCorner).crowdedEdges, 0u);
  EXPECT_EQ(checkMesh(atCorner).components, 1u);

  auto edge = shapes::cube();
  for (auto& p : edge.positions) p += glm::dvec3(1, 1, 0);
  auto atEdge = shapes::together(shapes::cube(), edge);
  weldVertices(atEdge);
  EXPECT_EQ(checkMesh(atEdge).crowdedEdges, 1u);
  EXPECT_TRUE(checkMesh(atEdge).closed());
  EXPECT_FALSE(checkMesh(atEdge).oriented());
}

TEST(CheckMesh, CountsUnusedVerticesAndDegenerateTriangles) {
  auto mesh = shapes::cube();
  mesh.positions.push_back({7, 7, 7});
  mesh.triangles.push_back({0, 0, 1});
  const auto report = checkMesh(mesh);
  EXPECT_EQ(report.unusedVertices, 1u);
  EXPECT_EQ(report.degenerateTriangles, 1u);
  EXPECT_FALSE(report.manifold());
  EXPECT_EQ(report.bounds.max, glm::dvec3(1));
  EXPECT_EQ(boundsOf(mesh).max, glm::dvec3(7));
}

TEST(CheckMesh, EmptyMeshIsNoSolid) {
  EXPECT_FALSE(isSolid(checkMesh({})));
  EXPECT_EQ(checkMesh({}).components, 0u);
}

TEST(WeldVertices, MakesTheSolidAgain) {
  auto mesh = shapes::soup(shapes::torus(24, 12));
  EXPECT_EQ(checkMesh(mesh).openEdges, mesh.triangles.size() * 3);
  weldVertices(mesh);
  EXPECT_EQ(mesh.positions.size(), 24u * 12u);
  EXPECT_TRUE(isSolid(checkMesh(mesh)));
}

TEST(WeldVertices, TakesMinusZeroForZeroAndDropsWhatCollapses) {
  TriangleMesh mesh;
  mesh.positions = {{0.0, 1, 2}, {-0.0, 1, 2}, {5, 5, 5}, {6, 5, 5}};
  mesh.colours = {Colour{1, 2, 3}, Colour{4, 5, 6}, Colour{7, 8, 9}, Colour{}};
  mesh.triangles = {{0, 1, 2}, {1, 2, 3}};
  weldVertices(mesh);
  ASSERT_EQ(mesh.positions.size(), 3u);
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.triangles[0], (TriangleMesh::Triangle{0, 1, 2}));
  EXPECT_EQ(mesh.colours[0], (Colour{1, 2, 3}));
  EXPECT_EQ(mesh.colours[1], (Colour{7, 8, 9}));
}

TEST(Validate, RefusesWhatCannotBeUsed) {
  EXPECT_NO_THROW(validate(shapes::cube()));
  auto mesh = shapes::cube();
  mesh.triangles[3][1] = 8;
  EXPECT_THROW(validate(mesh), Error);
  mesh = shapes::cube();
  mesh.positions[2].y = std::numeric_limits<double>::infinity();
  EXPECT_THROW(validate(mesh), Error);
  mesh = shapes::cube();
  mesh.colours.resize(3);
  EXPECT_THROW(validate(mesh), Error);
}

TEST(CheckMesh, HandlesMillionsInAboutASecond) {
  const auto report = checkMesh(shapes::torus(1250, 1000));
  EXPECT_EQ(report.triangles, 2'500'000u);
  EXPECT_EQ(report.genus(), 1);
}

}  // namespace
}  // namespace bozzetto
