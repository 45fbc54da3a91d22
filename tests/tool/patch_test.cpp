// What stands on a plane, taken without it.
#include "bozzetto/tool/patch.hpp"

#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "bozzetto/tool/sculpture.hpp"
#include "tool/tool_fixture.hpp"

namespace bozzetto {
namespace {

using namespace testing;

// A mushroom on a slab whose upper side is z = 0.
Clay mushroom() {
  Clay clay;
  fillInto(clay, Primitive{Shape::box, {0, 0, -6}, {30, 30, 6}, {1, 0, 0, 0}, {}});
  const glm::dquat upright = glm::angleAxis(1.5707963267948966, glm::dvec3(1, 0, 0));
  fillInto(clay, Primitive{Shape::cylinder, {0, 0, 6}, {3, 8, 3}, upright, kToolColour});
  fillInto(clay, Primitive{Shape::ellipsoid, {0, 0, 14}, {10, 10, 5}, {1, 0, 0, 0}, kToolColour});
  return clay;
}

TEST(Patch, hasUndercutsAndNoPlane) {
  const Clay patch = standingOn(mushroom(), {});
  EXPECT_EQ(validate(patch), std::nullopt);
  EXPECT_EQ(patch.value({0, 0, 14}), 1);
  EXPECT_EQ(patch.value({0, 0, 5}), 1) << "the stalk";
  EXPECT_EQ(patch.value({7, 0, 5}), 0) << "under the cap";
  const Key low = boundsOf(patch).low, high = boundsOf(patch).high;
  EXPECT_EQ(low.k, 0) << "nothing under the plane";
  EXPECT_EQ(high.i, 10) << "and nothing beside the cap";
  EXPECT_EQ(low.j, -10);
}

TEST(Patch, isClosedWhereItStood) {
  const Clay patch = standingOn(mushroom(), {});
  EXPECT_FLOAT_EQ(patch.value({0, 0, 0}), 0.5f) << "its root lies on the plane";
  EXPECT_EQ(patch.value({0, 0, -1}), 0);
  EXPECT_EQ(patch.value({3, 0, 1}), 0.5f) << "as wide as it stood";
}

TEST(Patch, sharesWhatIsWellOverThePlane) {
  const Clay clay = mushroom(), patch = standingOn(clay, {});
  EXPECT_EQ(patch.tree.find({0, 0, 1}), clay.tree.find({0, 0, 1}));
}

TEST(Patch, planesMayLieAskew) {
  const Clay clay = mushroom();
  const glm::dvec3 up = glm::normalize(glm::dvec3(0.3, 0, 1));
  const Clay patch = standingOn(clay, {{0, 0, 6}, 3.0 * up});
  EXPECT_EQ(patch.value({0, 0, 3}), 0);
  EXPECT_GT(patch.value({8, 0, 14}), 0.9f);
  EXPECT_EQ(patch.value({-25, 0, -3}), 0);
}

TEST(Patch, thePlaneIsFound) {
  for (const std::int32_t from : {-40, -4, 0}) {  // all of the slab, or a part of it
    const auto plane = planeUnder(partOf(mushroom(), {{-28, -28, from}, {28, 28, 40}}));
    ASSERT_TRUE(plane.has_value()) << from;
    EXPECT_EQ(plane->normal, glm::dvec3(0, 0, 1));
    EXPECT_NEAR(plane->at.z, 0, 0.01);
  }
  EXPECT_FALSE(planeUnder(clayBall<8>(20)));
  EXPECT_FALSE(planeUnder(Clay()));
  Clay slab;
  fillInto(slab, Primitive{Shape::box, {0, 0, 0}, {20, 20, 4}, {1, 0, 0, 0}, {}});
  EXPECT_FALSE(planeUnder(slab)) << "nothing stands on it";
}

TEST(Patch, badPlanesAreRefused) {
  EXPECT_THROW(standingOn(mushroom(), {{0, 0, 0}, {0, 0, 0}}), Error);
  EXPECT_THROW(standingOn(mushroom(), {{NAN, 0, 0}, {0, 0, 1}}), Error);
}

}  // namespace
}  // namespace bozzetto
