// Subdivision against exact answers and against laws that hold for every lattice.
#include "bozzetto/solid/refine.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

#include "bozzetto/base/error.hpp"
#include "bozzetto/solid/block.hpp"
#include "bozzetto/solid/boundary.hpp"
#include "solid/vectors.hpp"

namespace bozzetto {
namespace {

using testing::Json, testing::number, testing::place, testing::vectors;

class Vectors : public ::testing::TestWithParam<std::string> {};

TEST_P(Vectors, PointsRowsAndCounts) {
  const auto& json = vectors()["lattices"][GetParam()];
  const Lattice lattice = testing::lattice(GetParam());
  ASSERT_EQ(validate(lattice), std::nullopt);
  const Topology topology(lattice);
  const Refined refined = refineOnce(lattice);
  ASSERT_EQ(validate(refined.lattice), std::nullopt);
  const auto names = testing::rowNames(lattice, topology);

  const Json points = json.value("refined_points", Json::object());
  for (const auto& [name, expected] : points.items()) {
    const glm::dvec3 found = refined.lattice.points[names.at(name)];
    EXPECT_LT(glm::distance(found, place(expected)), 1e-15) << name;
  }
  const Json known = json.value("rows", Json::object());
  for (const auto& [name, expected] : known.items()) {
    const Id row = names.at(name);
    const auto& rows = refined.rows;
    ASSERT_EQ(rows.start[row + 1] - rows.start[row], expected.size()) << name;
    for (Id n = rows.start[row]; n < rows.start[row + 1]; ++n) {
      const double weight = number(expected.at(std::to_string(rows.columns[n])));
      EXPECT_NEAR(rows.weights[n], weight, 1e-16) << name << " " << rows.columns[n];
    }
  }

  const Topology after(refined.lattice);
  const auto& counts = json["refined_counts_VEFC"];
  EXPECT_EQ(refined.lattice.points.size(), counts[0]);
  EXPECT_EQ(after.edges.size(), counts[1]);
  EXPECT_EQ(refined.lattice.faces.size(), counts[2]);
  EXPECT_EQ(refined.lattice.cells.size(), counts[3]);

  // A corner with v faces makes a cell of 2v quads and 2v + 2 points.
  std::map<std::string, int> types;
  for (Id c = 0; c < refined.lattice.cells.size(); ++c) {
    const std::size_t faces = refined.lattice.cells[c].size();
    EXPECT_EQ(after.cellPoints[c].size(), faces + 2);
    ++types[std::to_string(faces / 2)];
  }
  EXPECT_EQ(Json(types), json["cell_types"]);
}

std::vector<std::string> latticeNames() {
  std::vector<std::string> names;
  for (const auto& [name, json] : vectors()["lattices"].items()) names.push_back(name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(All, Vectors, ::testing::ValuesIn(latticeNames()),
                         [](const auto& each) { return each.param; });

Lattice randomBlock(unsigned seed) {
  std::mt19937 random(seed);
  BlockOptions options{{5, 5, 5}, glm::dvec3(1), glm::dvec3(0), {}};
  for (int n = 0; n < 125; ++n)
    if (random() % 10 < 3) options.removed.push_back({n / 25, n / 5 % 5, n % 5});
  return makeBlock(options).lattice;
}

TEST(Refine, RowsSumToOneAndAreNeverNegative) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Refined refined = refine(randomBlock(seed), 2);
    ASSERT_EQ(validate(refined.lattice), std::nullopt);
    for (std::size_t row = 0; row < refined.rows.rowCount(); ++row) {
      double sum = 0;
      for (Id n = refined.rows.start[row]; n < refined.rows.start[row + 1]; ++n) {
        EXPECT_GT(refined.rows.weights[n], 0);
        sum += refined.rows.weights[n];
      }
      EXPECT_NEAR(sum, 1, 1e-14);
    }
  }
}

TEST(Refine, AffineMapsCommute) {
  Lattice lattice = randomBlock(7);
  const Refined before = refine(lattice, 2);
  const auto map = [](glm::dvec3 p) {
    return glm::dvec3(2 * p.x - p.y, 0.5 * p.y + p.z + 3, p.x - 4 * p.z);
  };
  for (auto& p : lattice.points) p = map(p);
  const Refined after = refine(lattice, 2);
  for (std::size_t n = 0; n < after.lattice.points.size(); ++n)
    EXPECT_LT(glm::distance(map(before.lattice.points[n]), after.lattice.points[n]), 1e-12);
}

TEST(Refine, MatrixEqualsRefiningTwice) {
  const Lattice lattice = randomBlock(3);
  const Refined both = refine(lattice, 2);
  std::vector<glm::dvec3> points(both.rows.rowCount());
  both.rows.apply(lattice.points, points);
  for (std::size_t n = 0; n < points.size(); ++n)
    EXPECT_LT(glm::distance(points[n], both.lattice.points[n]), 1e-13);
}

TEST(Refine, TransposeTwiceIsTheSame) {
  const WeightRows rows = refineOnce(randomBlock(2)).rows;
  const WeightRows again = rows.transposed().transposed();
  EXPECT_EQ(again.start, rows.start);
  EXPECT_EQ(again.columns, rows.columns);
  EXPECT_EQ(again.weights, rows.weights);
}

TEST(Refine, EulerNumberOfABallStaysOne) {
  for (int levels = 0; levels <= 3; ++levels) {
    const Lattice lattice = refine(testing::lattice("pyramid"), levels).lattice;
    const auto edges = Topology(lattice).edges.size();
    EXPECT_EQ(lattice.points.size() - edges + lattice.faces.size() - lattice.cells.size(), 1u);
  }
}

TEST(Refine, TypesOfCellsMultiplyAsSolidNotesSay) {
  // Pyramid → 4 hex + 1 type-4 → 40 hex + 2 type-4.
  const Lattice twice = refine(testing::lattice("pyramid"), 2).lattice;
  std::map<std::size_t, int> types;
  for (Id c = 0; c < twice.cells.size(); ++c) ++types[twice.cells[c].size() / 2];
  EXPECT_EQ(types, (std::map<std::size_t, int>{{3, 40}, {4, 2}}));
}

TEST(Refine, VolumeShrinksByKnownAmounts) {
  const Lattice cube = testing::lattice("cube");
  EXPECT_DOUBLE_EQ(volume(cube), 1);
  EXPECT_NEAR(volume(refine(cube, 1).lattice), 41.0 / 96, 1e-15);
  EXPECT_NEAR(volume(refine(cube, 2).lattice), 0.350, 5e-4);
  EXPECT_NEAR(volume(refine(testing::lattice("block_2x2x2"), 1).lattice) / 8, 0.835, 5e-4);
}

TEST(Refine, SurfaceAloneRefinesLikeTheSolid) {
  const Lattice lattice = randomBlock(4);
  const Lattice solid = surfaceOf(refine(lattice, 2).lattice);
  const Lattice surface = refine(surfaceOf(lattice), 2).lattice;
  ASSERT_EQ(solid.faces.size(), surface.faces.size());
  EXPECT_NEAR(enclosedVolume(solid), enclosedVolume(surface), 1e-11);
}

TEST(Refine, TooManyCellsAreRefused) {
  EXPECT_THROW(refine(testing::lattice("cube"), 8), Error);
  EXPECT_THROW(refine(testing::lattice("cube"), -1), Error);
}

}  // namespace
}  // namespace bozzetto
