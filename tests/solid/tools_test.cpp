// The sixteen tools: what they make is a solid, of the right size, and what it was made of stays.
#include "bozzetto/solid/tools.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "bozzetto/base/error.hpp"
#include "bozzetto/mesh/check.hpp"
#include "bozzetto/solid/boundary.hpp"
#include "bozzetto/solid/refine.hpp"

namespace bozzetto {
namespace {

Solid block(Key cells) {
  Solid solid;
  NamedLattice made = makeBlock({cells, glm::dvec3(1), glm::dvec3(0), {}});
  solid.control = std::move(made.lattice);
  solid.names = std::move(made.names);
  return solid;
}

Id at(const Solid& solid, Element element, glm::dvec3 place) {
  return nearest(solid.control, Topology(solid.control), element, place,
                 element == Element::cell ? PickFrom::everywhere : PickFrom::boundary);
}

void expectSound(const Solid& solid) {
  EXPECT_EQ(validate(solid.control), std::nullopt);
  EXPECT_EQ(solid.names.size(), solid.control.points.size());
  const Lattice refined = refine(solid.control, 1).lattice;
  EXPECT_EQ(validate(refined), std::nullopt);
  EXPECT_TRUE(checkMesh(triangulated(surfaceOf(refined))).closed());
}

TEST(Tools, CarveTakesOneCell) {
  const Solid carvedSolid =
      carved(block({3, 3, 3}), at(block({3, 3, 3}), Element::cell, {1, 1, 1}));
  expectSound(carvedSolid);
  EXPECT_EQ(carvedSolid.control.cells.size(), 26u);
  EXPECT_NEAR(volume(carvedSolid.control), 26, 1e-12);
  EXPECT_EQ(carvedSolid.names.size(), 63u);
  EXPECT_EQ(carvedSolid.control.points[carvedSolid.pointNamed({0, 1, 2})],
            glm::dvec3(-1.5, -0.5, 0.5));
  EXPECT_THROW(carved(block({1, 1, 1}), 0), Error);
}

TEST(Tools, ExtrudeGrowsAsFarAsTheCellIsDeep) {
  const Solid base = block({2, 2, 2});
  const Solid grown = extruded(base, at(base, Element::face, {0.5, 1, 0.5}), 0);
  expectSound(grown);
  EXPECT_NEAR(volume(grown.control), 9, 1e-12);
  const Solid longer = extruded(base, at(base, Element::face, {0.5, 1, 0.5}), 2.5);
  EXPECT_NEAR(volume(longer.control), 10.5, 1e-12);
  const Topology topology(base.control);
  const Id inner = nearest(base.control, topology, Element::face, {0, 0.5, 0.5});
  EXPECT_THROW(extruded(base, inner, 1), Error);
}

TEST(Tools, JoinMakesARing) {
  // Two towers on a base, their tops joined: one hole.
  Solid solid = block({3, 1, 1});
  for (const double x : {-1.0, 1.0})
    for (const double y : {0.5, 1.5})
      solid = extruded(solid, at(solid, Element::face, {x, y, 0}), 1);
  solid =
      joined(solid, at(solid, Element::face, {-0.5, 2, 0}), at(solid, Element::face, {0.5, 2, 0}));
  expectSound(solid);
  EXPECT_NEAR(volume(solid.control), 8, 1e-12);
  EXPECT_EQ(checkMesh(triangulated(surfaceOf(solid.control))).genus(), 1);
}

TEST(Tools, JoinOverACornerMakesAWedge) {
  Solid solid = block({2, 1, 1});
  solid = extruded(solid, at(solid, Element::face, {-0.5, 0.5, 0}), 1);
  std::string warning;
  solid = joined(solid, at(solid, Element::face, {0, 1, 0}),
                 at(solid, Element::face, {0.5, 0.5, 0}), &warning);
  expectSound(solid);
  EXPECT_FALSE(warning.empty());
  EXPECT_NEAR(volume(solid.control), 3.5, 1e-12);
}

TEST(Tools, JoinWorksOnlyOnTheSurfaceAndOnAlikeFaces) {
  const Solid solid = block({2, 2, 2});
  EXPECT_THROW(joined(solid, 0, 0), Error);
  const Id inner = nearest(solid.control, Topology(solid.control), Element::face, {0, 0.5, 0.5});
  EXPECT_THROW(joined(solid, 0, inner), Error);
  EXPECT_THROW(joined(solid, 0, 9999), Error);
}

TEST(Tools, SubdivideAsInFigureTen) {
  const Solid solid = block({2, 2, 2});
  const Solid split = subdivided(solid, at(solid, Element::cell, {0.5, 0.5, 0.5}));
  expectSound(split);
  EXPECT_NEAR(volume(split.control), 8, 1e-12);
  EXPECT_EQ(split.control.cells.size(), 15u);
  // A neighbour at a face has 13 corners: 12 hexahedra and one cell of type 4.
  const Lattice refined = refine(split.control, 1).lattice;
  std::map<std::size_t, int> types;
  for (Id n = 0; n < refined.cells.size(); ++n) ++types[refined.cells[n].size() / 2];
  EXPECT_EQ(types[4], 3);
  EXPECT_EQ(types[2], 3);
  expectSound(subdivided(split, at(split, Element::cell, {0.25, 0.25, 0.25})));
}

TEST(Tools, SharpFacesStayWhereTheyAre) {
  const Solid solid = block({1, 1, 1});
  const Solid sharp =
      sharpened(solid, Element::face, at(solid, Element::face, {0, 0.5, 0}), Sharp::yes);
  EXPECT_EQ(sharp.control.sharpEdges.size(), 4u);
  double top = 0;
  for (const auto& p : refine(sharp.control, 3).lattice.points) top = std::max(top, p.y);
  EXPECT_DOUBLE_EQ(top, 0.5);
  const Solid again =
      sharpened(sharp, Element::face, at(sharp, Element::face, {0, 0.5, 0}), Sharp::no);
  EXPECT_EQ(again, solid);
  const Solid corner = sharpened(solid, Element::point, 0, Sharp::yes);
  EXPECT_EQ(refine(corner.control, 2).lattice.points[0], solid.control.points[0]);
  EXPECT_THROW(sharpened(solid, Element::cell, 0, Sharp::yes), Error);
}

TEST(Tools, PaintAndInflateActInTheMiddleMost) {
  const Solid solid = block({3, 3, 3});
  const Solid heavy = painted(solid, Matter::mass, {0, 0, 0}, 1, 4);
  EXPECT_NEAR(*std::ranges::max_element(heavy.matter.mass), 4, 1e-12);
  EXPECT_EQ(*std::ranges::min_element(heavy.matter.mass), 1);
  const double soft =
      probedStiffness(painted(solid, Matter::hardness, {0, 0, 0}, 2, 0.1), {0, 0, 0}, 0.6);
  EXPECT_LT(soft, 0.3);
  EXPECT_EQ(probedStiffness(solid, {0, 0, 0}, 0.6), 1);

  RunReport report;
  const Solid grown = pulled(inflated(solid, {1.5, 0, 0}, 2, 0.5), {}, 0, 40, &report);
  const Solid shrunk = pulled(inflated(solid, {1.5, 0, 0}, 2, -0.4), {}, 0, 40);
  const double before = volume(refine(solid.control, 1).lattice);
  EXPECT_EQ(report.rolledBack, 0);
  EXPECT_GT(volume(refine(grown.control, 1).lattice), 1.05 * before);
  EXPECT_LT(volume(refine(shrunk.control, 1).lattice), 0.95 * before);
}

TEST(Tools, WindowAndTrimKeepTheRestStill) {
  const Solid solid = block({4, 2, 2});
  const Pull pull{{2, 1, 1}, {3, 2, 1}};
  const Solid whole = pulled(solid, std::span(&pull, 1), 10, 30);
  const Solid window =
      pulled(windowed(solid, std::array{glm::dvec3(0.5, -9, -9), glm::dvec3(9, 9, 9)}),
             std::span(&pull, 1), 10, 30);
  const Solid trim =
      pulled(trimmed(solid, {-2, 0, 0}, 1.7, TakesPart::no), std::span(&pull, 1), 10, 30);
  const auto moved = [&](const Solid& after, Key name) {
    const Id n = solid.pointNamed(name);
    return glm::distance(after.control.points[n], solid.control.points[n]);
  };
  EXPECT_GT(moved(whole, {0, 0, 0}), 1e-3);
  EXPECT_EQ(moved(window, {0, 0, 0}), 0);
  EXPECT_EQ(moved(window, {2, 2, 2}), 0);
  EXPECT_EQ(moved(trim, {0, 0, 0}), 0);
  EXPECT_GT(moved(window, {4, 2, 2}), 0.1);
  EXPECT_GT(moved(trim, {4, 2, 2}), 0.1);
  EXPECT_THROW(trimmed(solid, {0, 0, 0}, 99, TakesPart::no), Error);
  EXPECT_THROW(windowed(solid, std::array{glm::dvec3(50), glm::dvec3(60)}), Error);
}

TEST(Tools, ElasticComesBackUnlessResetToRest) {
  Solid solid = block({2, 2, 2});
  solid.matter.fixed.assign(27, 0);
  for (std::size_t n = 0; n < 27; ++n) solid.matter.fixed[n] = solid.names[n].j == 0 ? 1 : 0;
  const Pull pull{{1, 1, 1}, {1.5, 1.5, 1}};
  const Solid bent = pulled(solid, std::span(&pull, 1), 10, 40);
  const Id corner = solid.pointNamed({2, 2, 2});
  const auto away = [&](const Solid& after) {
    return glm::distance(after.control.points[corner], solid.control.points[corner]);
  };
  EXPECT_LT(away(pulled(bent, {}, 0, 400)), 0.1 * away(bent));
  EXPECT_GT(away(pulled(atRest(bent), {}, 0, 400)), 0.9 * away(bent));
}

TEST(Tools, SplineGoesThroughItsPoints) {
  const std::vector<glm::dvec3> places{{0, 0, 0}, {1, 2, 0}, {3, 2, 1}, {4, 0, 0}, {5, 5, 5}};
  const auto again = splinePlaces(splineThrough(places));
  for (std::size_t n = 0; n < places.size(); ++n)
    EXPECT_LT(glm::distance(again[n], places[n]), 1e-13);
  EXPECT_EQ(splineThrough(std::vector<glm::dvec3>{{1, 2, 3}}).size(), 1u);

  const auto curve = splineCurve(splineThrough(places), 4);
  ASSERT_EQ(curve.size(), 17u);
  for (std::size_t n = 0; n < places.size(); ++n)
    EXPECT_LT(glm::distance(curve[4 * n], places[n]), 1e-13);
  // Straight places make a straight curve, evenly cut.
  const auto line = splineCurve(std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 2);
  for (std::size_t n = 0; n < line.size(); ++n) EXPECT_NEAR(line[n].x, 0.5 * double(n), 1e-15);

  const Solid solid = block({4, 1, 1});
  const std::vector<glm::dvec3> top{
      {-2, 0.5, 0}, {-1, 0.5, 0}, {0, 0.5, 0}, {1, 0.5, 0}, {2, 0.5, 0}};
  const std::vector<SplineDrag> drags{{2, {0, 0.8, 0}}};
  const Solid bent = splined(solid, top, drags, 60);
  EXPECT_GT(bent.control.points[bent.pointNamed({2, 1, 0})].y, 0.6);
  EXPECT_THROW(splined(solid, top, std::vector<SplineDrag>{{9, {0, 1, 0}}}, 1), Error);
}

TEST(Tools, TopologyKeepsMassHardnessAndRest) {
  Solid solid = painted(block({4, 1, 1}), Matter::mass, {-2, 0, 0}, 1.2, 3);
  solid = inflated(solid, {-2, 0, 0}, 1.2, 0.3);
  const Solid cut = carved(solid, at(solid, Element::cell, {1.5, 0, 0}));
  const Lattice before = refine(solid.control, 1).lattice, after = refine(cut.control, 1).lattice;
  ASSERT_EQ(cut.matter.mass.size(), after.points.size());
  for (std::size_t n = 0; n < after.points.size(); ++n)
    for (std::size_t m = 0; m < before.points.size(); ++m)
      if (after.points[n] == before.points[m]) {
        EXPECT_EQ(cut.matter.mass[n], solid.matter.mass[m]);
      }
  EXPECT_GT(*std::ranges::max_element(cut.matter.mass), 2);
  const auto strain = [](const Solid& s) {
    const auto list = tinted(s, Tint::strain);
    return *std::ranges::max_element(list);
  };
  EXPECT_NEAR(strain(cut), strain(solid), 1e-12);
  EXPECT_EQ(tinted(cut, Tint::mass), cut.matter.mass);
}

TEST(Tools, CoarseSolidOfClay) {
  const auto inside = [](const glm::dvec3& p) { return glm::length(p) < 10; };
  const NamedLattice made = coarseBlock({glm::dvec3(-10), glm::dvec3(10)}, 8, inside);
  EXPECT_EQ(validate(made.lattice), std::nullopt);
  EXPECT_NEAR(volume(made.lattice) / (4.0 / 3 * std::acos(-1.0) * 1000), 1, 0.1);
  EXPECT_THROW(coarseBlock({glm::dvec3(-10), glm::dvec3(10)}, 0, inside), Error);
}

TEST(Pick, AlongARayNearestFirst) {
  const Solid solid = block({3, 3, 3});
  const Topology topology(solid.control);
  const PickRay ray{{0.1, 0.05, 10}, {0, 0, -1}, 0.05};
  const auto cells = pickAlong(solid.control, topology, Element::cell, ray);
  ASSERT_EQ(cells.size(), 3u);
  for (std::size_t n = 0; n < 3; ++n) {
    const glm::dvec3 middle = middleOf(solid.control, topology, Element::cell, cells[n].element);
    EXPECT_NEAR(middle.z, 1 - double(n), 1e-12);
    EXPECT_NEAR(cells[n].depth, 8.5 + double(n), 1e-12);
  }
  EXPECT_EQ(pickAlong(solid.control, topology, Element::face, ray).size(), 4u);
  const auto points =
      pickAlong(solid.control, topology, Element::point, {{0.5, 0.5, 10}, {0, 0, -1}, 0.01});
  EXPECT_EQ(points.size(), 4u);
  EXPECT_TRUE(
      pickAlong(solid.control, topology, Element::cell, {{9, 9, 9}, {0, 0, 1}, 0.1}).empty());
}

}  // namespace
}  // namespace bozzetto
