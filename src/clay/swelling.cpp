#include "clay/swelling.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "clay/projection.hpp"
#include "clay/transport.hpp"

namespace bozzetto::clay {
namespace {

constexpr double kRise = 0.15;  // cells a step, at the tool's core, with strength 1
constexpr int kSweeps = 12;     // over what lacks, a step

glm::dvec3 placeOf(Key key) { return {key.i, key.j, key.k}; }

// 1 at the tool's core, 0 at its surface.
double partAt(const PlacedTool& tool, const glm::dvec3& local) {
  const double p = std::clamp(-tool.solid->distance(local) / tool.smallest, 0.0, 1.0);
  return p * p * (3 - 2 * p);
}

template <class Callback>
void forCells(const Region& region, const KeyBox& box, const Callback& callback) {
  for (Key key = box.low; key.i <= box.high.i; ++key.i)
    for (key.j = box.low.j; key.j <= box.high.j; ++key.j)
      for (key.k = box.low.k; key.k <= box.high.k; ++key.k)
        if (!region.inRim(key)) callback(key, region.index(key));
}

// The way out of the clay that the tool meets: the mean, or 0 where it faces all ways alike.
glm::dvec3 wayOut(const Region& region, const PlacedTool& tool) {
  glm::dvec3 sum(0);
  double all = 0;
  forCells(region, tool.box, [&](Key key, std::size_t cell) {
    glm::dvec3 slope;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::ptrdiff_t step = region.strides()[axis];
      slope[static_cast<int>(axis)] = region.value[cell - step] - region.value[cell + step];
    }
    if (slope == glm::dvec3(0)) return;
    const double part = partAt(tool, placeOf(key - tool.solid->cell));
    sum += part * slope;
    all += part * glm::length(slope);
  });
  const double length = glm::length(sum);
  return length > 0.1 * all && length > 0 ? sum / length : glm::dvec3(0);
}

}  // namespace

// Outward as fast as its part of the tool says; beyond the core, towards the outside, as at the
// core, so that what comes out is not pressed together.
void Swelling::wishFor(Region& region, const PlacedTool& tool, const glm::dvec3& out) {
  const glm::dvec3 core =
      0.5 * (placeOf(tool.box.low) + placeOf(tool.box.high)) - placeOf(tool.solid->cell);
  forCells(region, tool.box, [&](Key key, std::size_t cell) {
    glm::dvec3 at = placeOf(key - tool.solid->cell);
    glm::dvec3 way = out;
    if (out != glm::dvec3(0))
      at -= std::max(0.0, glm::dot(at - core, out)) * out;
    else if (at != core)
      way = glm::normalize(at - core);
    const double free = 1 - region.hold[cell] / double{kFixed};
    const double speed = kRise * tool.strength * free * partAt(tool, at);
    for (std::size_t axis = 0; axis < 3; ++axis)
      region.wish[axis][cell] += static_cast<float>(speed * way[static_cast<int>(axis)]);
  });
}

bool Swelling::wish(Work& work) {
  Region& region = work.region;
  bool any = false;
  for (const PlacedTool& tool : work.moving) any = any || tool.role == Role::swell;
  if (!any) return false;
  beginWish(region);
  for (const PlacedTool& tool : work.moving)
    if (tool.role == Role::swell) wishFor(region, tool, wayOut(region, tool));
  return true;
}

void Swelling::run(Work& work) {
  if (!wish(work)) return;
  followWish(work);
  transport(work);
  evening_.run(work.region, kSweeps);
}

}  // namespace bozzetto::clay
