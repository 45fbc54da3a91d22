#include "render/overlay_shapes.hpp"

#include "bozzetto/render/pick.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace bozzetto {
namespace {

using glm::dvec3;

constexpr Ink kBoxInk{.624f, .706f, .784f, 1};  // #9FB4C8
constexpr Ink kGridInk{.62f, .66f, .72f, 1};
constexpr Ink kAccent{.878f, .463f, .290f, 1};  // #E0764A
constexpr Ink kXInk{.89f, .416f, .361f, 1}, kZInk{.357f, .608f, .878f, 1};

Ink faded(Ink ink, float opacity) {
  ink.a *= opacity;
  return ink;
}

// Lines fade from the middle to the rim; the ones through the origin are the axes.
void drawGrid(const FloorGrid& grid, InkSheet& sheet) {
  const auto snapped = [&](double v) { return std::round(v / grid.step) * grid.step; };
  const dvec3 middle(snapped(grid.centre.x), grid.centre.y, snapped(grid.centre.z));
  const double reach = grid.lines * grid.step;
  for (int n = -grid.lines; n <= grid.lines; ++n) {
    const double aside = n * grid.step;
    const double half = std::sqrt(std::max(reach * reach - aside * aside, 0.0));
    const float opacity = grid.opacity * float(half / reach) * (n % 4 == 0 ? 1.f : .5f);
    const auto strip = [&](dvec3 along, dvec3 across, double place, const Ink& axisInk) {
      const bool isAxis = std::abs(place + aside) < 1e-9;
      const Ink ink = isAxis ? faded(axisInk, .55f) : faded(kGridInk, opacity);
      const dvec3 at = middle + across * aside;
      for (const double end : {-half, half}) {
        sheet.fadingLine(at, at + along * end, {ink, isAxis ? 1.3f : 1.f, 0}, 0);
      }
    };
    strip({1, 0, 0}, {0, 0, 1}, middle.z, kXInk);
    strip({0, 0, 1}, {1, 0, 0}, middle.x, kZInk);
  }
}

dvec3 cornerOf(const BoxOutline& box, int corner) {
  return {corner & 4 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
          corner & 1 ? box.high.z : box.low.z};
}

// The pane on one side of the box, faint, when it faces away.
void drawPane(const BoxOutline& box, int axis, bool high, const dvec3& towardsEye,
              InkSheet& sheet) {
  dvec3 normal(0);
  normal[axis] = high ? 1 : -1;
  if (glm::dot(normal, towardsEye) > 0) return;
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  dvec3 corners[4];
  for (int n = 0; n < 4; ++n) {
    corners[n][axis] = high ? box.high[axis] : box.low[axis];
    corners[n][u] = n == 1 || n == 2 ? box.high[u] : box.low[u];
    corners[n][v] = n >= 2 ? box.high[v] : box.low[v];
  }
  sheet.quad(corners, faded(kBoxInk, .03f * box.opacity), 0);
}

void drawBox(const BoxOutline& box, const dvec3& towardsEye, InkSheet& sheet) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool high : {false, true}) drawPane(box, axis, high, towardsEye, sheet);
  }
  const LineStyle edge{faded(kBoxInk, .22f * box.opacity), 1.1f, 0};
  const LineStyle bracket{faded(kBoxInk, .75f * box.opacity), 2.2f, .1f};
  for (int corner = 0; corner < 8; ++corner) {
    for (const int bit : {1, 2, 4}) {
      if ((corner & bit) != 0) continue;
      const dvec3 a = cornerOf(box, corner), b = cornerOf(box, corner | bit);
      sheet.line(a, b, edge);
      sheet.line(a, a + (b - a) * .06, bracket);
      sheet.line(b, b + (a - b) * .06, bracket);
    }
  }
}

dvec3 handlePlace(const BoxOutline& box, int handle) {
  dvec3 place = (box.low + box.high) * .5;
  place[handle / 2] = handle % 2 == 0 ? box.low[handle / 2] : box.high[handle / 2];
  return place;
}

void drawHandles(const BoxOutline& box, InkSheet& sheet) {
  for (int handle = 0; handle < 6; ++handle) {
    const bool active = box.active == handle;
    const dvec3 place = handlePlace(box, handle);
    sheet.dot(place, active ? 8 : 6.5f, {.055f, .059f, .067f, .75f * box.opacity}, .35f);
    sheet.dot(place, active ? 6 : 4.5f, faded(active ? kAccent : kBoxInk, box.opacity), .35f);
  }
}

// In the air the ring lies across the normal, with the normal as a short stalk.
void drawRing(const RingCursor& ring, InkSheet& sheet) {
  const Ink white(1, 1, 1, ring.weight);
  if (ring.on == RingCursor::On::air) {
    dvec3 across[2];
    const dvec3 normal = glm::normalize(ring.normal);
    spanPlane(normal, across);
    const auto radius = float(ring.radius);
    sheet.disk(ring.centre, across, {radius * .5f, radius * .9f},
               {faded(ring.ink, .25f * ring.weight), 1, .2f});
    sheet.circle(ring.centre, across, ring.radius, {faded(white, .92f), 1.8f, .3f});
    sheet.fadingLine(ring.centre, ring.centre + normal * (ring.radius * .5),
                     {faded(ring.ink, .9f * ring.weight), 1.5f, .3f}, 0);
  }
  if (ring.weight > .75f) sheet.dot(ring.centre, 1.6f, faded(white, .85f), .6f);
}

void drawLight(const LightMark& light, InkSheet& sheet) {
  const Ink glow = faded(light.ink, light.active ? .45f : .25f);
  sheet.fadingLine(light.place, light.target, {faded(light.ink, .5f), 1.3f, .1f}, 0);
  sheet.dot(light.place, light.active ? 17 : 13, glow, .4f);
  sheet.dot(light.place, light.active ? 9.5f : 7.5f, {.055f, .059f, .067f, .6f}, .4f);
  sheet.dot(light.place, light.active ? 8 : 6, light.ink, .4f);
}

void drawPolyline(const Polyline& line, InkSheet& sheet) {
  const LineStyle style{line.ink, line.width, line.hidden};
  for (std::size_t n = 1; n < line.points.size(); ++n) {
    sheet.line(line.points[n - 1], line.points[n], style);
  }
  if (line.closed && line.points.size() > 2) {
    sheet.line(line.points.back(), line.points.front(), style);
  }
}

}  // namespace

void drawSurroundings(const Overlays& overlays, const dvec3& towardsEye, InkSheet& sheet) {
  if (overlays.grid) drawGrid(*overlays.grid, sheet);
  if (overlays.box) drawBox(*overlays.box, towardsEye, sheet);
}

// The plane, brightest in the middle, and where the tool's shadow falls.
void drawPlane(const WorkingPlane& plane, InkSheet& sheet) {
  dvec3 across[2];
  spanPlane(glm::normalize(plane.normal), across);
  const auto radius = float(plane.radius);
  sheet.disk(plane.centre, across, {radius * .45f, radius}, {faded(plane.ink, .22f), 1, .25f});
  const LineStyle line{faded(plane.ink, .55f), 1, .2f};
  sheet.circle(plane.centre, across, plane.toolRadius, line);
  for (const dvec3& direction : across) {
    for (const double end : {-plane.radius, plane.radius}) {
      sheet.fadingLine(plane.centre, plane.centre + direction * end, line, 0);
    }
  }
  const dvec3 below(plane.centre.x, plane.shadowFloor, plane.centre.z);
  dvec3 level[2];
  spanPlane({0, 1, 0}, level);
  const auto shadow = float(plane.toolRadius);
  sheet.disk(below, level, {shadow * .8f, shadow * .8f}, {{0, 0, 0, .5f}, 1, 0});
  sheet.fadingLine(plane.centre, below, {faded(plane.ink, .7f), 1, .15f}, .05f);
}

void drawMarks(const Overlays& overlays, InkSheet& sheet) {
  for (const RingCursor& ring : overlays.rings) drawRing(ring, sheet);
  for (const Polyline& line : overlays.lines) drawPolyline(line, sheet);
  for (const LightMark& light : overlays.lights) drawLight(light, sheet);
  if (overlays.box && overlays.box->handles) drawHandles(*overlays.box, sheet);
}

std::optional<int> handleAt(const Shot& shot, const BoxOutline& box, glm::dvec2 pixel) {
  constexpr double kReach = 9;
  std::optional<int> nearest;
  double depth = HUGE_VAL;
  for (int handle = 0; handle < 6; ++handle) {
    const auto seen = seenAt(shot, handlePlace(box, handle));
    if (!seen || glm::distance(seen->pixel, pixel) > kReach || seen->depth >= depth) continue;
    nearest = handle;
    depth = seen->depth;
  }
  return nearest;
}

dvec3 lightMarkPlace(const Stage& stage, const dvec3& towards, double distance) {
  constexpr double kFarUnits = 2.1;
  return stage.centre +
         glm::normalize(towards) * ((distance > 0 ? distance : kFarUnits) * stage.unit);
}

}  // namespace bozzetto
