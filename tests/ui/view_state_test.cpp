// The camera in the hand.
#include "ui/view_state.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace bozzetto::ui {
namespace {

constexpr Extent kExtent{932, 728};

ViewState someView(Projection projection) {
  ViewState view;
  view.turnTo(0.7, 0.3);
  view.target = {3, -2, 5};
  view.distance = 90;
  view.projection = projection;
  return view;
}

class Views : public ::testing::TestWithParam<Projection> {};
INSTANTIATE_TEST_SUITE_P(Both, Views,
                         ::testing::Values(Projection::perspective, Projection::orthographic));

TEST_P(Views, raysAndPixelsAreInverse) {
  const ViewState view = someView(GetParam());
  for (const glm::dvec2 pixel : {glm::dvec2(0, 0), glm::dvec2(466, 364), glm::dvec2(900, 20)}) {
    const Ray ray = rayThrough(view, kExtent, pixel);
    EXPECT_NEAR(glm::length(ray.direction), 1, 1e-12);
    for (const double distance : {30.0, 90.0, 200.0}) {
      const glm::dvec2 back = pixelOf(view, kExtent, ray.origin + ray.direction * distance);
      EXPECT_NEAR(glm::distance(back, pixel), 0, 1e-9);
    }
  }
}

TEST_P(Views, zoomKeepsWhatIsUnderThePointer) {
  ViewState view = someView(GetParam());
  const glm::dvec2 pixel(700, 200);
  const glm::dvec3 point = onFacingPlane(view, rayThrough(view, kExtent, pixel), view.target);
  zoom(view, kExtent, 5, pixel);
  EXPECT_LT(view.distance, 60);
  EXPECT_NEAR(glm::distance(pixelOf(view, kExtent, point), pixel), 0, 1e-6);
}

TEST_P(Views, panMovesTheClayWithThePointer) {
  ViewState view = someView(GetParam());
  const glm::dvec2 before = pixelOf(view, kExtent, view.target);
  const glm::dvec3 target = view.target;
  pan(view, kExtent, {40, -25});
  const glm::dvec2 after = pixelOf(view, kExtent, target);
  EXPECT_NEAR(after.x - before.x, 40, 1e-9);
  EXPECT_NEAR(after.y - before.y, -25, 1e-9);
}

TEST_P(Views, framingShowsAllAndFills) {
  ViewState view = someView(GetParam());
  const CellBounds boxes[] = {{{10, 0, -5}, {40, 8, 20}}, {{-30, -4, 2}, {-10, 30, 9}}};
  frame(view, boxes, kExtent.aspect(), 0.8);
  double widest = 0;
  for (const CellBounds& box : boxes) {
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 at((corner & 1 ? box.high : box.low).x, (corner & 2 ? box.high : box.low).y,
                          (corner & 4 ? box.high : box.low).z);
      const glm::dvec2 pixel = pixelOf(view, kExtent, at);
      widest = std::max({widest, std::abs(2 * pixel.x / kExtent.width - 1),
                         std::abs(2 * pixel.y / kExtent.height - 1)});
    }
  }
  EXPECT_NEAR(widest, 0.8, 1e-6);
}

TEST_P(Views, theRenderersCameraLooksTheSameWay) {
  ViewState view = someView(GetParam());
  orbit(view, kExtent, {400, 300}, {700, 650}, OrbitStyle::trackball);
  const Camera camera = cameraOf(view, 2);
  const glm::dmat3 axes = camera.worldFromView();
  EXPECT_NEAR(glm::distance(axes[0], view.right()), 0, 1e-9);
  EXPECT_NEAR(glm::distance(axes[1], view.up()), 0, 1e-9);
  EXPECT_NEAR(glm::distance(axes[2], view.back()), 0, 1e-9);
  EXPECT_NEAR(glm::distance(camera.eye() * 2.0, view.eye()), 0, 1e-9);
}

TEST_P(Views, surviveTheSceneFile) {
  const ViewState view = someView(GetParam());
  const ViewState back = viewOf(sceneCameraOf(view));
  EXPECT_EQ(back.projection, view.projection);
  EXPECT_NEAR(glm::distance(back.eye(), view.eye()), 0, 1e-9);
  EXPECT_NEAR(back.fieldOfView, view.fieldOfView, 1e-12);
}

TEST(Orbit, turntableKeepsTheHorizon) {
  ViewState view = someView(Projection::perspective);
  const double distance = glm::length(view.eye() - view.target);
  orbit(view, kExtent, {400, 300}, {520, 240}, OrbitStyle::turntable);
  EXPECT_NEAR(view.right().y, 0, 1e-12);
  EXPECT_NEAR(glm::length(view.eye() - view.target), distance, 1e-9);
}

TEST(Orbit, trackballComesBackOnTheSameWay) {
  ViewState view = someView(Projection::perspective);
  const ViewState before = view;
  orbit(view, kExtent, {400, 300}, {640, 420}, OrbitStyle::trackball);
  EXPECT_GT(glm::distance(view.back(), before.back()), 0.2);
  orbit(view, kExtent, {640, 420}, {400, 300}, OrbitStyle::trackball);
  EXPECT_NEAR(glm::distance(view.back(), before.back()), 0, 1e-9);
  EXPECT_NEAR(glm::distance(view.up(), before.up()), 0, 1e-9);
}

TEST(ViewHistory, movesThatFollowEachOtherAreOne) {
  ViewHistory history;
  Sight sight;
  const auto move = [&](double seconds) {
    history.moved(std::exchange(sight,
                                [&] {
                                  Sight next = sight;
                                  next.view.distance += 1;
                                  return next;
                                }()),
                  seconds);
  };
  sight.view.distance = 10;
  move(1.0);
  move(1.1);
  move(5.0);
  ASSERT_TRUE(history.undo(sight));
  EXPECT_EQ(sight.view.distance, 12);
  ASSERT_TRUE(history.undo(sight));
  EXPECT_EQ(sight.view.distance, 10);
  EXPECT_FALSE(history.undo(sight));
  ASSERT_TRUE(history.redo(sight));
  ASSERT_TRUE(history.redo(sight));
  EXPECT_EQ(sight.view.distance, 13);
  EXPECT_FALSE(history.redo(sight));
}

}  // namespace
}  // namespace bozzetto::ui
