#include "bozzetto/render/overlays.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "bozzetto/render/png.hpp"
#include "head_view.hpp"

namespace bozzetto {
namespace {

using namespace test;

constexpr PixelRect kPlace{0, 0, 240, 180};

// The head with overlays, as a moving frame shows them.
struct View : HeadView {
  View() : HeadView(kPlace, kPlace.width, kPlace.height) {}
  Image draw(const Overlays& overlays) {
    HeadView::draw(overlays);
    return picture();
  }
};

glm::dvec3 placeUnder(glm::dvec2 pixel) {
  const Loaded& head = theHead();
  return pick(head.scene.clay, rayThrough(head.shot(kPlace.width, kPlace.height), pixel), 1e4)
      ->place;
}

ToolGhost ballAt(const glm::dvec3& place, double radius, ToolDisplay display) {
  ToolGhost tool;
  tool.mesh = tool.limit = unitMesh(UnitShape::ball);
  tool.display = display;
  tool.cellsFromTool = glm::dmat4(glm::dmat3(radius));
  tool.cellsFromTool[3] = glm::dvec4(place, 1);
  tool.cellsFromLimit = glm::dmat4(glm::dmat3(radius * 1.4));
  tool.cellsFromLimit[3] = glm::dvec4(place, 1);
  return tool;
}

RingCursor ringAt(const glm::dvec3& place, RingCursor::On on) {
  RingCursor ring;
  ring.centre = place;
  ring.radius = 9;
  ring.on = on;
  return ring;
}

TEST(Overlays, LinesBehindTheClayFade) {
  View view;
  const Image plain = view.draw({});
  const glm::dvec3 front = placeUnder({120, 80}), back = theHead().bounds.centre();
  const glm::dvec3 right = view.frame.camera.worldFromView()[0];
  const auto change = [&](const glm::dvec3& at, float hidden) {
    Overlays overlays;
    Polyline line;
    line.points = {at - right * 6., at + right * 6.};
    line.ink = {0, 1, 0, 1};
    line.hidden = hidden;
    overlays.lines.push_back(line);
    return meanDifference(plain, view.draw(overlays));
  };
  const glm::dvec3 before = front + view.frame.camera.worldFromView()[2] * 8.;
  EXPECT_GT(change(before, 0), .1);
  EXPECT_EQ(change(back, 0), 0);
  EXPECT_GT(change(back, .5f), .02);
  EXPECT_LT(change(back, .5f), change(back, 1));
}

TEST(Overlays, ToolsShowAsAsked) {
  View view;
  const Image plain = view.draw({});
  const glm::dvec3 place = placeUnder({120, 80});
  std::vector<double> changes;
  for (const ToolDisplay display :
       {ToolDisplay::hidden, ToolDisplay::wire, ToolDisplay::transparent, ToolDisplay::solid}) {
    Overlays overlays;
    overlays.tools.push_back(ballAt(place, 10, display));
    changes.push_back(meanDifference(plain, view.draw(overlays)));
  }
  EXPECT_EQ(changes[0], 0);
  EXPECT_GT(changes[1], .1);
  EXPECT_GT(changes[2], .1);
  EXPECT_GT(changes[3], changes[2]);
}

// All at once, kept from a day it was looked at and liked.
TEST(Overlays, LookAsTheyDid) {
  View view;
  const Loaded& head = theHead();
  Overlays overlays;
  overlays.rings.push_back(ringAt(placeUnder({110, 75}), RingCursor::On::clay));
  overlays.rings.push_back(ringAt(head.bounds.high + glm::dvec3(6, -8, 0), RingCursor::On::air));
  overlays.tools.push_back(ballAt(placeUnder({150, 90}), 8, ToolDisplay::transparent));
  overlays.box = BoxOutline{head.bounds.low - 4., head.bounds.high + 4., true, 2, 1};
  const glm::dvec3 floor(view.frame.stage.centre.x, view.frame.stage.floor,
                         view.frame.stage.centre.z);
  overlays.grid = FloorGrid{floor, 8, 12, .25f};
  WorkingPlane plane;
  plane.centre = head.bounds.high + glm::dvec3(6, -8, 0);
  plane.shadowFloor = floor.y;
  overlays.plane = plane;
  LightMark light;
  light.place = lightMarkPlace(view.frame.stage, {-1, .5, .5});
  light.target = view.frame.stage.centre;
  overlays.lights.push_back(light);
  auto image = std::make_shared<Image>(2, 2);
  image->pixels = {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}, {255, 255, 0, 255}};
  overlays.pictures.push_back(
      {image, head.bounds.centre() - glm::dvec3(0, 0, 40), {30, 0, 0}, {0, 30, 0}, .4f, true});
  const Image drawn = view.draw(overlays);
  const std::string path = std::string(BOZZETTO_SOURCE_DIR) + "/tests/golden/render/overlays.png";
  if (std::getenv("BOZZETTO_UPDATE_GOLDEN") != nullptr) writePng(path, drawn);
  EXPECT_LT(meanDifference(drawn, readPng(path)), 1.5);
}

TEST(Overlays, HandlesAreFoundWhereTheyAre) {
  const Loaded& head = theHead();
  const Shot shot = head.shot();
  const BoxOutline box{head.bounds.low, head.bounds.high, true, {}, 1};
  for (int handle = 0; handle < 6; ++handle) {
    glm::dvec3 place = head.bounds.centre();
    place[handle / 2] = (handle % 2 ? box.high : box.low)[handle / 2];
    const auto found = handleAt(shot, box, seenAt(shot, place)->pixel);
    ASSERT_TRUE(found);
    glm::dvec3 other = head.bounds.centre();
    other[*found / 2] = (*found % 2 ? box.high : box.low)[*found / 2];
    EXPECT_LE(seenAt(shot, other)->depth, seenAt(shot, place)->depth + 1e-9);
  }
  EXPECT_FALSE(handleAt(shot, box, {1, 1}));
}

TEST(AxisBall, EndsPointWhereTheyLead) {
  Camera camera;
  camera.yaw = .7;
  camera.pitch = .4;
  for (const AxisEnd& end : axisEnds(camera)) {
    const Camera turned = lookingFrom(end, camera);
    glm::dvec3 axis(0);
    axis[end.axis] = end.positive ? 1 : -1;
    EXPECT_NEAR(glm::distance(turned.worldFromView()[2], axis), 0, 1e-12);
    EXPECT_LE(glm::length(end.at), 1 + 1e-12);
  }
  const auto ends = axisEnds(camera);
  for (std::size_t n = 1; n < ends.size(); ++n) EXPECT_LE(ends[n - 1].depth, ends[n].depth);
}

TEST(Camera, OrientIsTheInverseOfAxes) {
  for (const double yaw : {0., 1., -2.5}) {
    for (const double pitch : {0., .7, -1.2}) {
      for (const double roll : {0., .5, -3.}) {
        Camera camera, again;
        camera.yaw = yaw;
        camera.pitch = pitch;
        camera.roll = roll;
        again.orient(camera.worldFromView());
        const glm::dmat3 difference = again.worldFromView() - camera.worldFromView();
        for (int n = 0; n < 3; ++n) EXPECT_LT(glm::length(difference[n]), 1e-9);
      }
    }
  }
}

// Every triangle's normal points outwards, whatever the shape.
TEST(ToolMeshes, AreWoundOutwards) {
  for (const auto& mesh :
       {unitMesh(UnitShape::ball), unitMesh(UnitShape::box), unitMesh(UnitShape::cylinder),
        capsuleMesh({2, 5, 3}), unitMesh(UnitShape::ball, Rounding::wires),
        capsuleMesh({2, 5, 3}, Rounding::wires)}) {
    ASSERT_EQ(mesh->positions.size(), mesh->normals.size());
    for (std::size_t n = 0; n < mesh->indices.size(); n += 3) {
      const glm::vec3 a = mesh->positions[mesh->indices[n]];
      const glm::vec3 b = mesh->positions[mesh->indices[n + 1]];
      const glm::vec3 c = mesh->positions[mesh->indices[n + 2]];
      const glm::vec3 normal = glm::cross(b - a, c - a);
      if (glm::length(normal) < 1e-6f) continue;
      EXPECT_GT(glm::dot(normal, a + b + c), 0);
      EXPECT_GT(glm::dot(normal, mesh->normals[mesh->indices[n]]), 0);
    }
  }
}

}  // namespace
}  // namespace bozzetto
