#include "bozzetto/mesh/decimate.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bozzetto/base/error.hpp"
#include "bozzetto/mesh/check.hpp"

namespace bozzetto {
namespace {

// A closed torus far from the origin.
TriangleMesh torus(std::uint32_t rings, std::uint32_t sides) {
  TriangleMesh mesh;
  for (std::uint32_t r = 0; r < rings; ++r) {
    for (std::uint32_t s = 0; s < sides; ++s) {
      const double a = 6.283185307 * r / rings, b = 6.283185307 * s / sides;
      const double reach = 10 + 3 * std::cos(b);
      mesh.positions.emplace_back(1e6 + reach * std::cos(a), 3 * std::sin(b), reach * std::sin(a));
      const std::uint32_t r1 = (r + 1) % rings, s1 = (s + 1) % sides;
      mesh.triangles.push_back({r * sides + s, r * sides + s1, r1 * sides + s1});
      mesh.triangles.push_back({r * sides + s, r1 * sides + s1, r1 * sides + s});
    }
  }
  mesh.colours.resize(mesh.positions.size());
  return mesh;
}

TEST(Decimate, halvesTrianglesAndKeepsTheShapeClosed) {
  const TriangleMesh mesh = torus(120, 60);
  const TriangleMesh half = decimate(mesh, 0.25);
  const MeshReport before = checkMesh(mesh), after = checkMesh(half);
  EXPECT_NEAR(double(after.triangles), 0.25 * double(before.triangles),
              0.03 * double(before.triangles));
  EXPECT_TRUE(after.closed());
  EXPECT_EQ(after.eulerCharacteristic, 0);
  EXPECT_EQ(after.unusedVertices, 0u);
  EXPECT_EQ(half.colours.size(), half.positions.size());
  EXPECT_NEAR(after.volume, before.volume, 0.01 * std::abs(before.volume));
}

TEST(Decimate, ratioOneChangesNothingAndNonsenseIsRefused) {
  const TriangleMesh mesh = torus(8, 8);
  EXPECT_EQ(decimate(mesh, 1).triangles, mesh.triangles);
  EXPECT_THROW(decimate(mesh, 0), Error);
  EXPECT_THROW(decimate(mesh, 1.5), Error);
  EXPECT_THROW(decimate(mesh, std::nan("")), Error);
}

}  // namespace
}  // namespace bozzetto
