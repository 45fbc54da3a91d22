#include "bozzetto/render/camera.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "bozzetto/base/error.hpp"
#include "bozzetto/render/look.hpp"

namespace bozzetto {
namespace {

constexpr Viewpoint kAll[] = {Viewpoint::hero,   Viewpoint::front, Viewpoint::back,
                              Viewpoint::left,   Viewpoint::right, Viewpoint::top,
                              Viewpoint::bottom, Viewpoint::iso};

void expectNear(glm::dvec3 a, glm::dvec3 b) { EXPECT_LT(glm::length(a - b), 1e-12); }

// Where a point lands, in half pictures from the middle, counted in the lens's tangent.
glm::dvec2 projected(const Camera& camera, double aspect, glm::dvec3 point) {
  const glm::dmat3 axes = camera.worldFromView();
  const glm::dvec3 v = glm::transpose(axes) * (point - camera.eye());
  const bool perspective = camera.projection == Projection::perspective;
  const double scale = std::tan(camera.fieldOfView / 2) * (perspective ? -v.z : camera.distance);
  return {v.x / scale / aspect, v.y / scale};
}

std::vector<CellBounds> someBoxes(glm::dvec3 shift) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-100, 100), size(1, 20);
  std::vector<CellBounds> boxes;
  for (int n = 0; n < 40; ++n) {
    const glm::dvec3 low = shift + glm::dvec3(place(random), place(random) / 2, place(random) / 3);
    boxes.push_back({low, low + glm::dvec3(size(random), size(random), size(random))});
  }
  return boxes;
}

TEST(Camera, ViewpointsLookFromWhereTheySay) {
  const auto axes = [](Viewpoint viewpoint) {
    return framed(someBoxes({}), {.viewpoint = viewpoint}).worldFromView();
  };
  expectNear(axes(Viewpoint::front)[2], {0, 0, 1});
  expectNear(axes(Viewpoint::back)[2], {0, 0, -1});
  expectNear(axes(Viewpoint::right)[2], {1, 0, 0});
  expectNear(axes(Viewpoint::left)[2], {-1, 0, 0});
  expectNear(axes(Viewpoint::top)[2], {0, 1, 0});
  expectNear(axes(Viewpoint::top)[1], {0, 0, -1});
  expectNear(axes(Viewpoint::bottom)[2], {0, -1, 0});
  expectNear(axes(Viewpoint::iso)[2], glm::normalize(glm::dvec3(1)));
}

TEST(Camera, AxesAreRightHandedAndUpright) {
  for (const Viewpoint viewpoint : kAll) {
    const glm::dmat3 a = framed({}, {.viewpoint = viewpoint}).worldFromView();
    expectNear(glm::cross(a[0], a[1]), a[2]);
    EXPECT_NEAR(a[0].y, 0, 1e-12);
  }
}

TEST(Camera, FramedClayFillsThePictureAndNoMore) {
  for (const glm::dvec3 shift : {glm::dvec3(0), glm::dvec3(3e5, -7e5, 1e6)}) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
      for (const Viewpoint viewpoint : kAll) {
        const auto boxes = someBoxes(shift);
        const Camera camera = framed(boxes, {viewpoint, projection, 1.5, .8});
        glm::dvec2 most(0);
        for (const CellBounds& box : boxes) {
          for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 p((corner & 4 ? box.high : box.low).x,
                               (corner & 2 ? box.high : box.low).y,
                               (corner & 1 ? box.high : box.low).z);
            most = glm::max(most, glm::abs(projected(camera, 1.5, p)));
          }
        }
        EXPECT_NEAR(std::max(most.x, most.y), .8, 1e-6);
      }
    }
  }
}

TEST(Camera, EmptySceneHasAView) {
  EXPECT_GT(framed({}, {}).distance, 0);
  EXPECT_GT(Stage::around({}).unit, 0);
}

TEST(Camera, NamesOnTheCommandLine) {
  EXPECT_EQ(parseViewpoint("top"), Viewpoint::top);
  EXPECT_THROW(parseViewpoint("above"), Error);
  EXPECT_EQ(parseMode("glass"), Mode::glass);
  EXPECT_THROW(parseMode("Clay"), Error);
}

}  // namespace
}  // namespace bozzetto
