#include "render/frame.hpp"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "render/studio.hpp"

namespace bozzetto {
namespace {

constexpr double kSceneRadius = 1.85;        // of what casts shadows, stage units
constexpr double kStageReach = 7.5;          // of all that is drawn, floor corners included
constexpr double kFloorHalf = 5;             // stage units
constexpr glm::dvec2 kKeyBoxHalf(.40, .30);  // tangent units, as in environment.cpp
// How much of the box the light comes from: the whole would be photographic but shapeless.
constexpr double kBoxUsed = .42;
constexpr double kFullTurn = 2 * std::numbers::pi;
constexpr double kBackgroundHeight = .52;  // where the paper roll is brightest

// The corner next to `cells`, counted from `base`; inside the workspace.
Key latticePoint(const glm::dvec3& cells, Key base = {}) {
  Key corner;
  for (const Axis axis : kAxes) {
    const double low = -double(kWorkspaceRim) - base[axis],
                 high = double(kWorkspaceRim) - base[axis];
    corner[axis] = std::int32_t(std::lround(std::clamp(cells[index(axis)], low, high)));
  }
  return corner;
}

glm::dvec3 place(Key corner) { return {corner.i, corner.j, corner.k}; }

// The shot counted from the lattice point next to the camera's target: exact, and from there on
// small numbers, the same wherever in the workspace the clay stands.
Shot countedFrom(Key base, Shot shot) {
  shot.camera.target -= place(base);
  shot.stage.centre -= place(base);
  shot.stage.floor -= base.j;
  return shot;
}

glm::dmat4 projectionOf(const Shot& shot, double depth) {
  const Camera& camera = shot.camera;
  const double aspect = double(shot.width) / shot.height;
  const double nearest = std::max(depth - kStageReach, .02), farthest = depth + kStageReach;
  if (camera.projection == Projection::perspective) {
    return glm::perspective(camera.fieldOfView, aspect, nearest, farthest);
  }
  const double half = camera.distance / shot.stage.unit * std::tan(camera.fieldOfView / 2);
  return glm::ortho(-half * aspect, half * aspect, -half, half, depth - kStageReach, farthest);
}

// The eye stands sideways of the camera; what lies in the plane of zero parallax stays where it
// was: a shear along the view, which makes the frustum lean (off-axis).
glm::dmat4 eyeShear(const Shot& shot) {
  glm::dmat4 shear(1);
  if (shot.eye.plane <= 0) return shear;
  shear[3].x = -shot.eye.sideways / shot.stage.unit;
  shear[2].x = -shot.eye.sideways / shot.eye.plane;
  return shear;
}

// The part of the picture that is drawn becomes the whole of clip space.
glm::dmat4 cropTo(const PixelRect& part, const Shot& shot) {
  const glm::dvec2 scale(double(shot.width) / part.width, double(shot.height) / part.height);
  const glm::dvec2 centre((2.0 * part.x + part.width) / shot.width - 1,
                          (2.0 * part.y + part.height) / shot.height - 1);
  glm::dmat4 crop(1);
  crop[0].x = scale.x;
  crop[1].y = scale.y;
  crop[3] = glm::dvec4(-centre * scale, 0, 1);
  return crop;
}

// Stage units in the frame of `axes` (columns), seen from `from` (cells), for cells from `anchor`.
glm::dmat4 unitsFromCells(const glm::dmat3& axes, const glm::dvec3& from, const glm::dvec3& anchor,
                          double unit) {
  const glm::dmat4 turn(glm::transpose(axes));
  const glm::dmat4 scale = glm::scale(glm::dmat4(1), glm::dvec3(1 / unit));
  return turn * scale * glm::translate(glm::dmat4(1), anchor - from);
}

// Near lights cast as far ones do, along the line through the stage's centre.
glm::dmat4 shadowMatrix(const Shot& shot, const glm::dvec3& key, const Slice& slice,
                        const glm::dvec3& anchor) {
  const glm::dmat3 worldFromView = shot.camera.worldFromView();
  const glm::dvec3 helper = std::abs(key.y) < .99 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -1);
  const glm::dvec3 right = glm::normalize(glm::cross(helper, key));
  const glm::dvec3 up = glm::cross(key, right);
  const glm::dvec2 shift = slice.light * kKeyBoxHalf * kBoxUsed;
  const glm::dvec3 towards = worldFromView * glm::normalize(key + right * shift.x + up * shift.y);
  const bool above = std::abs(glm::dot(worldFromView[1], towards)) > .99;
  const glm::dvec3 side =
      glm::normalize(glm::cross(above ? -worldFromView[2] : worldFromView[1], towards));
  const glm::dmat3 axes(side, glm::cross(towards, side), towards);
  const glm::dvec3 eye = shot.stage.centre + towards * ((kSceneRadius + 2) * shot.stage.unit);
  return glm::ortho(-kSceneRadius, kSceneRadius, -kSceneRadius, kSceneRadius, .1,
                    2 * kSceneRadius + 4) *
         unitsFromCells(axes, eye, anchor, shot.stage.unit);
}

// The n-th number of the additive recurrence of a ratio: even for every n.
double recurrence(double ratio, int n) {
  const double x = .5 + ratio * n;
  return x - std::floor(x) - .5;
}

// The n-th place in the disk of radius 1; any run of them is spread evenly.
glm::vec4 tapAt(int n) {
  const double radius = std::sqrt(recurrence(.7548776662466927, n) + .5);
  const double angle = kFullTurn * recurrence(.5698402909980532, n);
  return glm::vec4(radius * std::cos(angle), radius * std::sin(angle), 0, 0);
}

void setShadowing(FrameBlock& block, const Look& look, const Slice& slice) {
  const float cast = look.detail == Detail::baked || look.studio.lights.empty() ? 0
                     : look.mode == Mode::glass                                 ? .55f
                                                                                : 1;
  const int taps = slice.taps;
  for (int n = 0; n < taps; ++n) block.taps[n] = tapAt(slice.index * taps + n);
  block.shadowing =
      slice.one ? glm::vec4(.0085, .030, cast, taps) : glm::vec4(.0055, .024, cast, taps);
}

}  // namespace

// Roberts's R2 and R3-like sequences: the plastic number and its kin.
Slice sliceAt(int n) {
  Slice slice;
  slice.pixel = {recurrence(.7548776662466927, n), recurrence(.5698402909980532, n)};
  slice.light = {2 * recurrence(.8191725133961645, n), 2 * recurrence(.6710436067037893, n)};
  slice.index = n;
  slice.one = false;
  slice.taps = 4;
  return slice;
}

Frame makeFrame(const Shot& anywhere, const Look& look, const Slice& slice) {
  const Key base = latticePoint(anywhere.camera.target);
  const Shot shot = countedFrom(base, anywhere);
  const Camera& camera = shot.camera;
  const Stage& stage = shot.stage;
  const glm::dmat3 axes = camera.worldFromView();
  const glm::dvec3 eye = camera.eye();
  const Key localAnchor = latticePoint(eye, base);
  const glm::dvec3 anchor = place(localAnchor);
  Frame frame{};
  frame.anchor = base + localAnchor;
  const bool perspective = camera.projection == Projection::perspective;
  const bool above = perspective ? eye.y > stage.floor : axes[2].y >= 0;
  frame.floorInSight = above && look.floor;

  const double depth = glm::dot(axes[2], eye - stage.centre) / stage.unit;
  const PixelRect part = shot.drawn();
  const glm::dvec3 jitter(2 * slice.pixel.x / part.width, 2 * slice.pixel.y / part.height, 0);
  const glm::dmat4 view = unitsFromCells(axes, eye, anchor, stage.unit);
  const glm::dmat4 projection = projectionOf(shot, depth);
  frame.clipFromCells = glm::translate(glm::dmat4(1), jitter) * cropTo(part, shot) * projection *
                        eyeShear(shot) * view;
  frame.width = part.width;
  frame.height = part.height;

  const double scale = projection[1][1] * shot.height / 2;
  const glm::dvec3 floor = glm::dvec3(stage.centre.x, stage.floor, stage.centre.z) - anchor;
  FrameBlock& block = frame.block;
  block.clipFromCells = frame.clipFromCells;
  const glm::dvec3 aside(-shot.eye.sideways / stage.unit, 0, 0);
  block.viewFromCells = glm::translate(glm::dmat4(1), aside) * view;
  frame.pose.worldFromView = glm::mat3(axes);
  frame.pose.middle = block.viewFromCells * glm::vec4(stage.centre - anchor, 1);
  block.shadowFromCells = shadowMatrix(shot, keyTowards(look.studio, camera), slice, anchor);
  block.worldFromView = glm::dmat4(axes);
  block.viewport = glm::vec4(shot.width, shot.height, .5, kBackgroundHeight);
  block.part = glm::vec4(part.x, part.y, part.width, part.height);
  block.stage = glm::vec4(stage.unit, look.dither, perspective, slice.one ? kFullTurn : .6);
  block.floorPlane = glm::vec4(floor, kFloorHalf * stage.unit);
  block.extra = glm::vec4(FloorOcclusion::kHalfUnits * stage.unit, frame.floorInSight, scale, 0);
  setShadowing(block, look, slice);
  return frame;
}

}  // namespace bozzetto
