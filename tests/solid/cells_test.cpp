// Coordinates inside refined cells.
#include "bozzetto/solid/cells.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

#include "bozzetto/solid/boundary.hpp"
#include "bozzetto/solid/refine.hpp"
#include "solid/vectors.hpp"

namespace bozzetto {
namespace {

using testing::number, testing::place, testing::vectors;

CellPiece knownCell() {
  CellPiece piece;
  const auto& corners = vectors()["bridge"]["corner_cell_of_refined_cube"]["corners"];
  for (std::size_t n = 0; n < 8; ++n) piece.corner[n] = place(corners[n]);
  return piece;
}

TEST(CellPiece, KnownPlaceAndVolume) {
  const auto& known = vectors()["bridge"]["corner_cell_of_refined_cube"];
  const CellPiece piece = knownCell();
  const glm::dvec3 uvw = place(known["uvw"]), x = place(known["x"]);
  EXPECT_LT(glm::distance(piece.at(uvw), x), 1e-15);
  ASSERT_TRUE(piece.inverse(x));
  EXPECT_LT(glm::distance(*piece.inverse(x), uvw), 1e-9);
  EXPECT_NEAR(piece.volume(), number(known["cell_volume"]), 1e-15);
}

TEST(CellPiece, RoundTripsInDeformedCells) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> noise(-0.2, 0.2), inside(0, 1);
  for (int cell = 0; cell < 200; ++cell) {
    CellPiece piece;
    for (std::size_t n = 0; n < 8; ++n)
      piece.corner[n] = glm::dvec3(n & 1, n >> 1 & 1, n >> 2) +
                        glm::dvec3(noise(random), noise(random), noise(random));
    for (int n = 0; n < 50; ++n) {
      const glm::dvec3 uvw(inside(random), inside(random), inside(random));
      const auto found = piece.inverse(piece.at(uvw));
      ASSERT_TRUE(found);
      EXPECT_LT(glm::distance(*found, uvw), 1e-7);
    }
    EXPECT_FALSE(piece.inverse({2, 2, 2}));
  }
}

TEST(CellPieces, FillEveryKindOfCell) {
  for (const std::string name : {"cube", "pyramid", "cube_split_edge", "prism", "L_three_cubes"}) {
    Lattice lattice = testing::lattice(name);
    for (int levels = 0; levels <= 2; ++levels) {
      const Lattice refined = refine(lattice, levels).lattice;
      const CellPieces pieces = piecesOf(refined);
      const auto places = pieces.places(refined.points);
      double sum = 0;
      for (std::size_t n = 0; n < pieces.pieces.size(); ++n) {
        const CellPiece piece = pieces.at(n, places);
        EXPECT_GT(piece.volume(), 0) << name;
        sum += piece.volume();
      }
      EXPECT_NEAR(sum, volume(refined), 1e-12) << name << " " << levels;
    }
  }
}

}  // namespace
}  // namespace bozzetto
