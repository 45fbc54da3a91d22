#include "clay/pulling.hpp"

#include "clay/influence.hpp"
#include "clay/transport.hpp"

namespace bozzetto::clay {
namespace {

// The motion of the grip, whole where it is, none a radius away.
void wishFor(Work& work, const PlacedTool& grip) {
  Region& region = work.region;
  const KeyBox box = grown(grip.box, static_cast<std::int32_t>(grip.radius) + 1);
  for (Key key = box.low; key.i <= box.high.i; ++key.i)
    for (key.j = box.low.j; key.j <= box.high.j; ++key.j)
      for (key.k = box.low.k; key.k <= box.high.k; ++key.k) {
        if (region.inRim(key)) continue;
        const std::size_t cell = region.index(key);
        const Key local = key - grip.solid->cell, place = key - work.origin;
        const double away = grip.solid->distance(glm::dvec3(local.i, local.j, local.k));
        const float free = 1 - static_cast<float>(region.hold[cell]) / kFixed;
        const float part = free * dragAt(static_cast<float>(away), static_cast<float>(grip.radius));
        const glm::dvec3 way = grip.motion.at(glm::dvec3(place.i, place.j, place.k));
        for (std::size_t axis = 0; axis < 3; ++axis)
          region.wish[axis][cell] += part * static_cast<float>(way[static_cast<int>(axis)]);
      }
}

}  // namespace

void Pulling::run(Work& work) {
  if (!work.grips() || work.has(LayerKind::displacement)) return;
  beginWish(work.region);
  for (const PlacedTool& tool : work.moving)
    if (tool.role == Role::grip) wishFor(work, tool);
  projection_.run(work);
  transport(work);
  work.region.refreshRows();
}

}  // namespace bozzetto::clay
