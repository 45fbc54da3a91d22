// Lattices, what is derived from them, and their surfaces.
#include "bozzetto/solid/lattice.hpp"

#include <gtest/gtest.h>

#include "bozzetto/base/error.hpp"
#include "bozzetto/mesh/check.hpp"
#include "bozzetto/solid/block.hpp"
#include "bozzetto/solid/boundary.hpp"
#include "bozzetto/solid/refine.hpp"
#include "solid/vectors.hpp"

namespace bozzetto {
namespace {

TEST(Block, CountsAndNames) {
  const NamedLattice block = makeBlock({{2, 3, 4}, glm::dvec3(20), {1, 2, 3}, {}});
  EXPECT_EQ(validate(block.lattice), std::nullopt);
  EXPECT_EQ(block.lattice.points.size(), 60u);
  EXPECT_EQ(block.lattice.cells.size(), 24u);
  EXPECT_EQ(Topology(block.lattice).edges.size(), 2u * 4 * 5 + 3 * 3 * 5 + 3 * 4 * 4);
  for (std::size_t n = 0; n < block.names.size(); ++n) {
    const Key key = block.names[n];
    EXPECT_EQ(block.lattice.points[n],
              glm::dvec3(1 + 20 * (key.i - 1), 2 + 20 * (key.j - 1.5), 3 + 20 * (key.k - 2)));
  }
}

TEST(Block, RemovedCellsAreGone) {
  const NamedLattice block = makeBlock({{2, 2, 2}, glm::dvec3(1), glm::dvec3(0), {{0, 0, 1}}});
  EXPECT_EQ(block.lattice.cells.size(), 7u);
  EXPECT_EQ(block.lattice.points.size(), 26u);
  EXPECT_DOUBLE_EQ(volume(block.lattice), 7);
}

TEST(Block, BadOptionsAreRefused) {
  EXPECT_THROW(makeBlock({{0, 1, 1}, glm::dvec3(1), glm::dvec3(0), {}}), Error);
  EXPECT_THROW(makeBlock({{257, 1, 1}, glm::dvec3(1), glm::dvec3(0), {}}), Error);
  EXPECT_THROW(makeBlock({{256, 256, 256}, glm::dvec3(1), glm::dvec3(0), {}}), Error);
  EXPECT_THROW(makeBlock({{1, 1, 1}, glm::dvec3(-1), glm::dvec3(0), {}}), Error);
  EXPECT_THROW(makeBlock({{1, 1, 1}, glm::dvec3(1), glm::dvec3(0), {{1, 0, 0}}}), Error);
  EXPECT_THROW(makeBlock({{1, 1, 1}, glm::dvec3(1), glm::dvec3(0), {{0, 0, 0}}}), Error);
}

TEST(Validate, FindsEachFault) {
  const Lattice good = testing::lattice("two_cubes");
  Lattice bad = good;
  bad.points[3].x = std::nan("");
  EXPECT_NE(validate(bad), std::nullopt);
  bad = good;
  bad.faces.at(0)[0] = 99;
  EXPECT_NE(validate(bad), std::nullopt);
  bad = good;
  bad.faces.at(0)[0] = bad.faces[0][1];
  EXPECT_NE(validate(bad), std::nullopt);
  bad = good;
  bad.cells.at(0)[0] = bad.cells[0][1];
  EXPECT_NE(validate(bad), std::nullopt);
  bad = good;
  bad.cells.add(good.cells[0]);
  bad.cells.add(good.cells[0]);
  EXPECT_NE(validate(bad), std::nullopt);
}

TEST(Compacted, DropsWhatNoCellUses) {
  Lattice lattice = testing::lattice("two_cubes");
  Lists one;
  one.add(lattice.cells[1]);
  lattice.cells = one;
  const Compacted result = compacted(lattice);
  EXPECT_EQ(validate(result.lattice), std::nullopt);
  EXPECT_EQ(result.lattice.points.size(), 8u);
  EXPECT_EQ(result.lattice.faces.size(), 6u);
  for (std::size_t n = 0; n < 8; ++n)
    EXPECT_EQ(result.lattice.points[n], lattice.points[result.oldPoints[n]]);
}

TEST(Surface, IsClosedOrientedAndOfTheRightVolume) {
  const Lattice ring = testing::lattice("ring_3x3x1_hole");
  for (int levels = 0; levels <= 2; ++levels) {
    const Lattice surface = surfaceOf(refine(ring, levels).lattice);
    for (const int cuts : {1, 3}) {
      const TriangleMesh mesh = triangulated(surface, cuts);
      const MeshReport report = checkMesh(mesh);
      EXPECT_TRUE(isSolid(report));
      EXPECT_EQ(report.genus(), 1);
      EXPECT_GT(report.volume, 0);
      EXPECT_NEAR(report.volume, enclosedVolume(surface), 1e-12);
    }
  }
}

}  // namespace
}  // namespace bozzetto
