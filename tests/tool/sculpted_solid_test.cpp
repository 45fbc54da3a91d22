// How far a sculpted tool's surface is: against a ball's, and the same on any number of threads.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "bozzetto/base/parallel.hpp"
#include "bozzetto/tool/fill.hpp"
#include "bozzetto/tool/solid.hpp"
#include "tool/sculpted_solid.hpp"

namespace bozzetto {
namespace {

std::shared_ptr<const Sculpture> solidOf(Shape shape, glm::dvec3 radii) {
  Clay clay;
  Edit<CornerBlock<8>> edit(clay.tree);
  Primitive primitive;
  primitive.shape = shape;
  primitive.radii = radii;
  fill<8>(edit, clay.scale, primitive);
  edit.commit();
  return std::make_shared<const Sculpture>(std::move(clay));
}

// Every place of a lattice that does not fall on nodes.
template <class Callback>
void forPlaces(double reach, const Callback& callback) {
  for (double x = -reach; x <= reach; x += 1.7)
    for (double y = -reach; y <= reach; y += 1.7)
      for (double z = -reach; z <= reach; z += 1.7) callback(glm::dvec3(x, y, z));
}

TEST(SculptedSolid, ABallsDistanceIsThatToItsSurface) {
  const auto ball = solidOf(Shape::ellipsoid, glm::dvec3(10));
  forPlaces(15, [&](const glm::dvec3& p) {
    const double d = glm::length(p) - 10;
    if (d < -8) return;  // a kink, which a grid rounds
    EXPECT_NEAR(ball->distance().at(p), d, 0.2 + 0.06 * std::abs(d)) << p.x << " " << p.y;
  });
}

TEST(SculptedSolid, ALargeBallIsRightToACellOfItsCoarserGrid) {
  const auto ball = solidOf(Shape::ellipsoid, glm::dvec3(150));
  for (double x = -160; x < 160; x += 7.3) {
    const glm::dvec3 p(x, x / 2, 2);
    const double d = glm::length(p) - 150;
    EXPECT_NEAR(ball->distance().at(p), d, 0.5 + 0.06 * std::abs(d)) << x;
  }
}

TEST(SculptedSolid, ThreadsDoNotShow) {
  const auto bitsOn = [](int threads) {
    setThreadCount(threads);
    const auto box = solidOf(Shape::box, {30, 12, 21});
    std::vector<double> found;
    forPlaces(34, [&](const glm::dvec3& p) { found.push_back(box->distance().at(p)); });
    setThreadCount(0);
    return found;
  };
  const auto one = bitsOn(1);
  for (const int threads : {2, 3, 5}) EXPECT_EQ(bitsOn(threads), one) << threads;
}

TEST(SculptedSolid, StandsAtItsPoseScaledAndTurned) {
  const auto rod = solidOf(Shape::cylinder, {4, 12, 4});
  DabPose pose;
  pose.origin = {100, -50, 7};
  pose.position = {0.25, 0, 0};
  pose.orientation = glm::dmat3({0, -1, 0}, {1, 0, 0}, {0, 0, 1});  // y to x
  pose.radii = 2.0 * rod->halfExtents();
  const auto solid = makeSolid(rod, pose);
  const auto distance = [&](Key key) {
    const Key local = key - solid->cell;
    return solid->distance({local.i, local.j, local.k});
  };
  EXPECT_NEAR(distance({100, -50, 7}), -8, 1);
  EXPECT_NEAR(distance({122, -50, 7}), -2.25, 0.7);
  EXPECT_NEAR(distance({100, -40, 7}), 2, 0.7);
}

}  // namespace
}  // namespace bozzetto
