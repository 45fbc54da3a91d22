// Clay made of solids: volume, place, colour, and what it leaves alone.
#include "bozzetto/solid/bake.hpp"

#include <gtest/gtest.h>

#include "bozzetto/base/parallel.hpp"
#include "bozzetto/solid/block.hpp"
#include "bozzetto/solid/boundary.hpp"
#include "bozzetto/solid/refine.hpp"

namespace bozzetto {
namespace {

// A twisted 5×5×5 block with some cells carved out.
Lattice twisted(double edge) {
  Lattice lattice =
      makeBlock({{5, 5, 5}, glm::dvec3(edge), {3, -7, 11}, {{0, 0, 0}, {2, 4, 2}, {4, 4, 4}}})
          .lattice;
  for (auto& p : lattice.points) {
    const double t = 0.6 * p.z / (5 * edge);
    p = {p.x * std::cos(t) - p.y * std::sin(t), p.x * std::sin(t) + p.y * std::cos(t), p.z};
  }
  return lattice;
}

template <int Side>
BakeReport bakeInto(Field<Side>& field, const Lattice& lattice, const BakeOptions& options) {
  Edit<CornerBlock<Side>> edit(field.tree);
  const BakeReport report = bake<Side>(edit, field.scale, lattice, options);
  edit.commit();
  return report;
}

double massOf(const Clay& clay) {
  return static_cast<double>(massUnits(clay)) * kMassUnit * std::pow(clay.scale.spacing, 3);
}

TEST(Bake, VolumeIsTheSolidsOwn) {
  for (int levels = 0; levels <= 3; ++levels) {
    const Lattice lattice = twisted(44);  // some 256 cells across
    Clay clay;
    const auto report = bakeInto(clay, lattice, {levels, {}});
    EXPECT_EQ(validate(clay), std::nullopt);
    EXPECT_NEAR(report.volume / volume(refine(lattice, levels).lattice), 1, 1e-12);
    EXPECT_NEAR(massOf(clay) / report.volume, 1, 1e-4) << levels;
  }
}

TEST(Bake, DensityIsTheDistanceToTheSurface) {
  // Level 0 of a cube is the cube.
  const Lattice cube = makeBlock({{1, 1, 1}, glm::dvec3(20), {0.25, 0, 0}, {}}).lattice;
  Clay clay;
  bakeInto(clay, cube, {0, {1, 2, 3}});
  EXPECT_FLOAT_EQ(clay.value({10, 0, 0}), 0.625f);
  EXPECT_FLOAT_EQ(clay.value({11, 0, 0}), 0.125f);
  EXPECT_FLOAT_EQ(clay.value({-10, 3, 5}), 0.375f);
  EXPECT_FLOAT_EQ(clay.value({0, 10, 0}), 0.5f);
  EXPECT_FLOAT_EQ(clay.value({0, 0, 0}), 1.0f);
  EXPECT_EQ(clay.value({12, 0, 0}), 0.0f);
  EXPECT_EQ(colourOf(clay.attributes({0, 0, 0})), (Colour{1, 2, 3}));
}

TEST(Bake, SameOnOneThreadManyThreadsAndBothSides) {
  const Lattice lattice = twisted(6);
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 3}) {
    setThreadCount(threads);
    Clay clay;
    bakeInto(clay, lattice, {2, {}});
    hashes.push_back(fieldHash(clay));
  }
  setThreadCount(0);
  Field<1> corners;
  bakeInto(corners, lattice, {2, {}});
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], fieldHash(corners));
}

TEST(Bake, RaisesAndNeverLowers) {
  Clay clay;
  bakeInto(clay, makeBlock({{2, 2, 2}, glm::dvec3(20), glm::dvec3(0), {}}).lattice, {1, {9, 9, 9}});
  const Clay before = clay;
  bakeInto(clay, makeBlock({{1, 1, 1}, glm::dvec3(20), {20, 0, 0}, {}}).lattice, {1, {1, 1, 1}});
  EXPECT_EQ(validate(clay), std::nullopt);
  EXPECT_EQ(colourOf(clay.attributes({5, 0, 0})), (Colour{9, 9, 9}));
  EXPECT_EQ(colourOf(clay.attributes({25, 0, 0})), (Colour{1, 1, 1}));
  for (int i = -30; i < 40; ++i)
    for (int j = -30; j < 30; ++j) EXPECT_GE(clay.value({i, j, 3}), before.value({i, j, 3}));
  const std::uint64_t hash = fieldHash(clay);
  const auto again =
      bakeInto(clay, makeBlock({{1, 1, 1}, glm::dvec3(20), {20, 0, 0}, {}}).lattice, {1, {}});
  EXPECT_EQ(again.dirty, 0);
  EXPECT_EQ(fieldHash(clay), hash);
}

TEST(Bake, FarAwayIsTheSame) {
  const Key shift{1 << 20, -(1 << 20), 1 << 21};
  Lattice lattice = makeBlock({{2, 1, 1}, glm::dvec3(16), glm::dvec3(0), {}}).lattice;
  Clay here, there;
  bakeInto(here, lattice, {2, {}});
  for (auto& p : lattice.points) p += glm::dvec3(shift.i, shift.j, shift.k);
  bakeInto(there, lattice, {2, {}});
  for (int n = -20; n < 20; ++n)
    EXPECT_NEAR(here.value({n, n / 3, n / 5}), there.value(Key{n, n / 3, n / 5} + shift), 1e-6);
}

TEST(Bake, BadOptionsChangeNothing) {
  Clay clay;
  EXPECT_THROW(bakeInto(clay, twisted(5), {7, {}}), Error);
  EXPECT_THROW(bakeInto(clay, twisted(1e10), {1, {}}), Error);
  EXPECT_TRUE(clay.tree.empty());
}

}  // namespace
}  // namespace bozzetto
