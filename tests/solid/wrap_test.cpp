// Clay carried by a lattice: identity, mass, colours, what stays, what throws.
#include "bozzetto/solid/wrap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "bozzetto/base/error.hpp"
#include "bozzetto/base/parallel.hpp"
#include "bozzetto/solid/wrap_map.hpp"
#include "bozzetto/tool/fill.hpp"

namespace bozzetto {
namespace {

template <int Side>
void put(Field<Side>& field, const Primitive& primitive) {
  Edit<CornerBlock<Side>> edit(field.tree);
  fill<Side>(edit, field.scale, primitive);
  edit.commit();
}

// A red body with a blue end.
template <int Side = 8>
Field<Side> figure() {
  Field<Side> field;
  put(field, {Shape::ellipsoid, {0, 0, 0}, {12, 24, 10}, {1, 0, 0, 0}, {200, 30, 30}});
  put(field, {Shape::ellipsoid, {0, 22, 0}, {9, 9, 9}, {1, 0, 0, 0}, {30, 30, 200}});
  return field;
}

enum class Pose { none, twist, bend, stretch };

std::vector<glm::dvec3> posed(const Lattice& lattice, Pose pose) {
  auto points = lattice.points;
  for (auto& p : points) {
    if (pose == Pose::twist) {
      const double t = 0.03 * p.y;
      p = {p.x * std::cos(t) - p.z * std::sin(t), p.y, p.x * std::sin(t) + p.z * std::cos(t)};
    } else if (pose == Pose::bend) {
      const double t = 0.02 * p.y, r = 50 + p.x;
      p = {r * std::cos(t) - 50, r * std::sin(t), p.z};
    } else if (pose == Pose::stretch) {
      p *= glm::dvec3(1.3, 1, 0.9);
    }
  }
  return points;
}

template <int Side>
WrapReport wrapInto(Field<Side>& field, Pose pose, const WrapOptions& options = {}) {
  const auto box = clayBox(field);
  const Lattice rest = wrapBlock(box[0], box[1], {4, 4, 4}).lattice;
  Edit<CornerBlock<Side>> edit(field.tree);
  const auto report = applyWrap<Side>(edit, field.scale, rest, posed(rest, pose), options);
  edit.commit();
  return report;
}

double mass(const Clay& clay) { return double(massUnits(clay)) * kMassUnit; }

// Clay carried and places carried are one map: the surface lands where its vertices do.
TEST(WrapMap, CarriesPlacesAndNormalsAsClayGoes) {
  const Lattice rest = wrapBlock({-10, -20, -10}, {10, 20, 10}, {2, 4, 2}).lattice;
  WrapMap map(rest, 2, 0.5);
  const glm::dvec3 cell(7, -13, 4);
  const WrapPlace inside = map.find(cell);
  ASSERT_TRUE(inside.isInside());
  EXPECT_FALSE(map.find({200, 0, 0}).isInside());
  EXPECT_LT(glm::distance(map.carried(inside), cell), 1e-9);
  EXPECT_LT(glm::distance(map.turned(inside, {0, 1, 0}), glm::dvec3(0, 1, 0)), 1e-12);
  // A stretch: places by it, normals by its inverse.
  map.pose(posed(rest, Pose::stretch));
  EXPECT_LT(glm::distance(map.carried(inside), cell * glm::dvec3(1.3, 1, 0.9)), 1e-9);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(1, 2, 3));
  const glm::dvec3 expected = glm::normalize(normal / glm::dvec3(1.3, 1, 0.9));
  EXPECT_LT(glm::distance(map.turned(inside, normal), expected), 1e-12);
  // No place is lost between the corners of blocks.
  for (int n = 0; n < 4000; ++n) {
    const glm::dvec3 place(-18 + n % 37, -37 + n * 7 % 75, -18 + n * 11 % 37);
    EXPECT_TRUE(map.find(place + 0.37 * glm::dvec3(n % 3 - 1, n % 5 - 2, n % 4 - 1)).isInside());
  }
  // Neighbours help each other and change nothing.
  const WrapPlace again = map.find(cell, map.find(cell + 0.3));
  EXPECT_LT(glm::distance(map.carried(again), map.carried(inside)), 1e-8);
}

TEST(Wrap, PointsAreNamedFromZeroToCellsPlusTwo) {
  const NamedLattice block = wrapBlock({0, 0, 0}, {8, 4, 2}, {4, 2, 1});
  EXPECT_EQ(block.names.size(), 7u * 5 * 4);
  for (std::size_t n = 0; n < block.names.size(); ++n) {
    const Key key = block.names[n];
    EXPECT_EQ(block.lattice.points[n],
              glm::dvec3(2.0 * key.i - 2, 2.0 * key.j - 2, 2.0 * key.k - 2));
  }
}

TEST(Wrap, IdentityIsNoChangeToSpeakOf) {
  Clay clay = figure();
  const Clay before = clay;
  wrapInto(clay, Pose::none);
  EXPECT_EQ(validate(clay), std::nullopt);
  for (const auto& [key, run] : before.tree)
    for (int n = 0; n < 512; ++n) {
      const Key corner = key * 8 + Key{n / 64, n / 8 % 8, n % 8};
      ASSERT_NEAR(clay.value(corner), before.value(corner), 1e-4);
    }
}

TEST(Wrap, KeepsMassAndCarriesColours) {
  for (const Pose pose : {Pose::twist, Pose::bend, Pose::stretch}) {
    Clay clay = figure();
    const double before = mass(clay);
    const WrapReport report = wrapInto(clay, pose);
    EXPECT_EQ(validate(clay), std::nullopt);
    EXPECT_NEAR(mass(clay) / before, 1, 1e-6);
    EXPECT_NEAR(report.massAfter / report.massBefore, 1, 1e-6);

    const int top = pose == Pose::bend ? -4 : 0;
    EXPECT_EQ(colourOf(clay.attributes({top, 25, 0})), (Colour{30, 30, 200}));
    EXPECT_EQ(colourOf(clay.attributes({0, -10, 0})), (Colour{200, 30, 30}));
  }
}

TEST(Wrap, WithoutKeepingMassFollowsTheVolume) {
  Clay clay = figure();
  const double before = mass(clay);
  wrapInto(clay, Pose::stretch, {2, KeepMass::no});
  EXPECT_NEAR(mass(clay) / before, 1.3 * 0.9, 0.01);
}

TEST(Wrap, MovesAllAlongWithTheLattice) {
  Clay clay = figure();
  const Clay before = clay;
  const auto box = clayBox(clay);
  const Lattice rest = wrapBlock(box[0], box[1], {2, 3, 2}).lattice;
  auto moved = rest.points;
  for (auto& p : moved) p += glm::dvec3(64, -32, 8);
  Edit<CornerBlock<8>> edit(clay.tree);
  applyWrap<8>(edit, clay.scale, rest, moved, {1, KeepMass::no});
  edit.commit();
  for (int i = -14; i <= 14; ++i)
    for (int j = -26; j <= 34; ++j)
      ASSERT_NEAR(clay.value({i + 64, j - 32, 11}), before.value({i, j, 3}), 1e-5);
  EXPECT_EQ(clay.value({0, 0, 0}), 0);
}

TEST(Wrap, OutsideStays) {
  Clay clay = figure();
  put(clay, {Shape::ellipsoid, {200, 0, 0}, {9, 9, 9}, {1, 0, 0, 0}, {1, 2, 3}});
  const Lattice rest = wrapBlock({-16, -30, -16}, {16, 36, 16}, {3, 4, 3}).lattice;
  Edit<CornerBlock<8>> edit(clay.tree);
  applyWrap<8>(edit, clay.scale, rest, posed(rest, Pose::twist), {});
  edit.commit();
  EXPECT_EQ(clay.value({200, 0, 0}), 1);
  EXPECT_EQ(colourOf(clay.attributes({200, 0, 0})), (Colour{1, 2, 3}));
}

TEST(Wrap, SameOnAnyThreadsAndBothSides) {
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 3}) {
    setThreadCount(threads);
    Clay clay = figure();
    wrapInto(clay, Pose::bend);
    hashes.push_back(fieldHash(clay));
  }
  setThreadCount(0);
  Field<1> corners = figure<1>();
  wrapInto(corners, Pose::bend);
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], fieldHash(corners));
}

TEST(Wrap, BadInputChangesNothing) {
  Clay clay = figure();
  const std::uint64_t hash = fieldHash(clay);
  const Lattice rest = wrapBlock({-16, -30, -16}, {16, 36, 16}, {2, 2, 2}).lattice;
  Edit<CornerBlock<8>> edit(clay.tree);
  const std::vector<glm::dvec3> few(3);
  auto far = rest.points;
  far[0].x = 1e12;
  EXPECT_THROW(applyWrap<8>(edit, clay.scale, rest, few, {}), Error);
  EXPECT_THROW(applyWrap<8>(edit, clay.scale, rest, far, {}), Error);
  EXPECT_THROW(applyWrap<8>(edit, clay.scale, rest, rest.points, {0}), Error);
  EXPECT_THROW(wrapBlock({0, 0, 0}, {1, 0, 1}, {2, 2, 2}), Error);
  EXPECT_THROW(wrapBlock({0, 0, 0}, {1, 1, 1}, {0, 2, 2}), Error);
  EXPECT_THROW(clayBox(Clay{}), Error);
  edit.commit();
  EXPECT_EQ(fieldHash(clay), hash);
}

}  // namespace
}  // namespace bozzetto
