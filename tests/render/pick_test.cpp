#include "bozzetto/render/pick.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <glm/geometric.hpp>
#include <random>

#include "bozzetto/field/sampler.hpp"
#include "loaded.hpp"

namespace bozzetto {
namespace {

using namespace test;

Shot shotOfBall(Projection projection) {
  Shot shot;
  shot.width = 300;
  shot.height = 200;
  shot.camera.distance = 150;
  shot.camera.yaw = .4;
  shot.camera.pitch = .3;
  shot.camera.roll = .2;
  shot.camera.projection = projection;
  return shot;
}

class Projections : public testing::TestWithParam<Projection> {};
INSTANTIATE_TEST_SUITE_P(Pick, Projections,
                         testing::Values(Projection::perspective, Projection::orthographic));

TEST_P(Projections, RaysAndPixelsAreInverse) {
  Shot shot = shotOfBall(GetParam());
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(0, 300), y(0, 200), depth(5, 400);
  for (const double sideways : {0., 3., -3.}) {
    shot.eye = {sideways, 150};
    for (int n = 0; n < 100; ++n) {
      const glm::dvec2 pixel(x(random), y(random));
      const auto seen = seenAt(shot, rayThrough(shot, pixel).at(depth(random)));
      ASSERT_TRUE(seen);
      EXPECT_NEAR(glm::distance(seen->pixel, pixel), 0, 1e-8);
    }
  }
}

// What the camera's target shows at, in every stereo eye: zero parallax there.
TEST_P(Projections, TheMiddleIsTheTarget) {
  Shot shot = shotOfBall(GetParam());
  shot.camera.target = {3, 4, 5};
  for (const double sideways : {0., 3., -3.}) {
    shot.eye = {sideways, shot.camera.distance};
    const auto seen = seenAt(shot, shot.camera.target);
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->pixel.x, 150, 1e-9);
    EXPECT_NEAR(seen->pixel.y, 100, 1e-9);
    EXPECT_NEAR(seen->depth, 150, 1e-9);
  }
}

// Nearer than the plane of zero parallax things stand apart crossed, farther uncrossed.
TEST(Stereo, ParallaxHasTheRightSign) {
  Shot left = shotOfBall(Projection::perspective), right = left;
  const Stereo stereo{StereoMode::anaglyph, 1 / 30.0, 1};
  left.eye = eyeShift(left.camera, stereo, Eye::left);
  right.eye = eyeShift(right.camera, stereo, Eye::right);
  EXPECT_NEAR(right.eye.sideways - left.eye.sideways, 5, 1e-9);
  const glm::dvec3 towards = left.camera.worldFromView()[2];
  const auto parallax = [&](double nearer) {
    return seenAt(right, towards * nearer)->pixel.x - seenAt(left, towards * nearer)->pixel.x;
  };
  EXPECT_LT(parallax(30), -1);
  EXPECT_NEAR(parallax(0), 0, 1e-9);
  EXPECT_GT(parallax(-30), 1);
}

TEST_P(Projections, HitsABallWhereItIs) {
  const Scene scene = sceneOf(ball({5, -3, 2}, 20), {.half = 40});
  const Shot shot = shotOfBall(GetParam());
  const glm::dvec3 centre(5, -3, 2);
  int hits = 0;
  for (int y = 5; y < 200; y += 10) {
    for (int x = 5; x < 300; x += 10) {
      const Ray ray = rayThrough(shot, {double(x), double(y)});
      const auto hit = pick(scene.clay, ray, 1000);
      const glm::dvec3 away = centre - ray.origin;
      const double missBy = glm::length(away - ray.direction * glm::dot(away, ray.direction)) - 20;
      if (std::abs(missBy) < .5) continue;
      ASSERT_EQ(hit.has_value(), missBy < 0) << x << " " << y;
      if (!hit) continue;
      ++hits;
      EXPECT_NEAR(glm::distance(hit->place, centre), 20, .12);
      EXPECT_GT(glm::dot(glm::dvec3(hit->normal), glm::normalize(hit->place - centre)), .98);
      FieldSampler<8> sampler(scene.clay);
      EXPECT_NEAR(sampler.value(cellPoint({}, hit->place)), .5, 2e-3);
    }
  }
  EXPECT_GT(hits, 20);
}

TEST(Pick, SamePlaceFarFromTheOrigin) {
  constexpr int far = 1 << 29;
  const Scene near = sceneOf(head()), away = sceneOf(head(), {.centre = {far, -far, far}});
  Shot shot = shotOfBall(Projection::perspective);
  const auto here = pick(near.clay, rayThrough(shot, {150, 90}), 1000);
  const glm::dvec3 shift(far, -far, far);
  shot.camera.target += shift;
  const auto there = pick(away.clay, rayThrough(shot, {150, 90}), 1000);
  ASSERT_TRUE(here && there);
  EXPECT_NEAR(glm::distance(there->place - shift, here->place), 0, 1e-4);
}

TEST(Pick, ARayFromInsideHitsAtOnce) {
  const Scene scene = sceneOf(ball({0, 0, 0}, 20), {.half = 40});
  const auto hit = pick(scene.clay, {{0, 0, 0}, {1, 0, 0}}, 100);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->distance, 0, 1e-6);
}

TEST(Pick, NothingWithinReachIsNothing) {
  const Scene scene = sceneOf(ball({0, 0, 0}, 20), {.half = 40});
  EXPECT_FALSE(pick(scene.clay, {{0, 0, 100}, {0, 0, -1}}, 70));
  EXPECT_TRUE(pick(scene.clay, {{0, 0, 100}, {0, 0, -1}}, 90));
  EXPECT_FALSE(pick(scene.clay, {{0, 0, 100}, {0, 0, 1}}, 1e6));
  EXPECT_FALSE(pick(Clay{}, {{0, 0, 100}, {0, 0, -1}}, 1e5));
}

// A sheet one cell thin is not jumped over, whatever the slant.
TEST(Pick, ThinSheetsAreHit) {
  const Scene scene = sceneOf(box({.3, 0, 0}, {.75, 30, 30}), {.half = 40});
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-20, 20);
  for (int n = 0; n < 200; ++n) {
    const glm::dvec3 from(60, place(random), place(random)), to(0, place(random), place(random));
    const auto hit = pick(scene.clay, {from, glm::normalize(to - from)}, 200);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->place.x, 1.05, .3);
  }
}

TEST(Pick, PlanesAreMet) {
  const auto met = meetPlane({{0, 0, 10}, {0, 0, -1}}, {5, 5, 2}, {0, 0, 1});
  ASSERT_TRUE(met);
  EXPECT_NEAR(glm::distance(*met, glm::dvec3(0, 0, 2)), 0, 1e-12);
  EXPECT_FALSE(meetPlane({{0, 0, 10}, {0, 0, 1}}, {5, 5, 2}, {0, 0, 1}));
  EXPECT_FALSE(meetPlane({{0, 0, 10}, {1, 0, 0}}, {5, 5, 2}, {0, 0, 1}));
}

TEST(Pick, CellsPerPixelIsTheSizeOfAPixel) {
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    const Shot shot = shotOfBall(projection);
    const glm::dvec3 place = shot.camera.target + shot.camera.worldFromView()[2] * 40.0;
    const double size = cellsPerPixel(shot, place);
    const auto seen = seenAt(shot, place + shot.camera.worldFromView()[0] * size);
    EXPECT_NEAR(seen->pixel.x, 151, 1e-6);
  }
}

}  // namespace
}  // namespace bozzetto
