#include "render/frame.hpp"

#include <gtest/gtest.h>

#include <cstring>

namespace bozzetto {
namespace {

Shot shotAt(glm::dvec3 centre) {
  Shot shot;
  shot.camera = {.target = centre, .yaw = .4, .pitch = .2, .distance = 192};
  shot.stage = {.centre = centre + glm::dvec3(1.5, 0, .25), .unit = 32, .floor = centre.y - 40};
  return shot;
}

// Whatever the GPU gets is relative to the eye: far away it is the same to the bit.
TEST(Frame, SameNumbersAnywhereInTheWorkspace) {
  const double far = 1 << 29;
  const Frame near = makeFrame(shotAt({0, 0, 0}), {}, {});
  const Frame away = makeFrame(shotAt({far, -far, far}), {}, {});
  EXPECT_EQ(std::memcmp(&near.block, &away.block, sizeof(FrameBlock)), 0);
  EXPECT_EQ(away.anchor.i - (1 << 29), near.anchor.i);
}

TEST(Frame, SlicesFillThePixelEvenly) {
  glm::dvec2 pixel(0), light(0);
  for (int n = 0; n < 12; ++n) {
    const Slice slice = sliceAt(n);
    EXPECT_LE(std::abs(slice.pixel.x), .5);
    EXPECT_LE(std::abs(slice.light.y), 1);
    pixel += slice.pixel / 12.;
    light += slice.light / 12.;
  }
  EXPECT_LT(std::abs(pixel.x) + std::abs(pixel.y), .2);
  EXPECT_LT(std::abs(light.x) + std::abs(light.y), .2);
}

TEST(Frame, FloorIsSeenFromAboveOnly) {
  Shot shot = shotAt({0, 0, 0});
  EXPECT_TRUE(makeFrame(shot, {}, {}).floorInSight);
  shot.camera.pitch = -1;
  EXPECT_FALSE(makeFrame(shot, {}, {}).floorInSight);
}

}  // namespace
}  // namespace bozzetto
