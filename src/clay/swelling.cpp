#include "clay/swelling.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "bozzetto/grid/key_box.hpp"
#include "clay/projection.hpp"
#include "clay/swell_speed.hpp"
#include "clay/transport.hpp"

namespace bozzetto::clay {
namespace {

constexpr double kRise = 0.15;       // cells a step, at the tool's core, with strength 1
constexpr int kSweeps = 12;          // over what lacks, a step
constexpr double kNamed = 0.1;       // share of what was asked for; less is told
constexpr int kLastRounds = 4;       // of as many, after the last
constexpr double kNear[2] = {3, 6};  // cells: the surface so near says most about the way out
// How full the clay inside is where it has plenty to give, and where it has no more.
constexpr double kPlenty = 0.9, kSpent = 0.8;

glm::dvec3 placeOf(Key key) { return {key.i, key.j, key.k}; }

// From where the tool stands.
glm::dvec3 fromStand(const PlacedTool& tool, Key key) {
  return placeOf(key - tool.solid->cell) - tool.stand;
}

template <class Callback>
void forCells(const Region& region, const KeyBox& box, const Callback& callback) {
  const KeyBox inner = common(box, region.inner());
  for (Key key = inner.low; key.i <= inner.high.i; ++key.i)
    for (key.j = inner.low.j; key.j <= inner.high.j; ++key.j)
      for (key.k = inner.low.k; key.k <= inner.high.k; ++key.k) callback(key, region.index(key));
}

// The way out of the clay that the tool meets: the mean, of what is near before all, or one would
// not know which side of a sheet is meant; 0 where it faces all ways alike.
glm::dvec3 wayOut(const Region& region, const PlacedTool& tool) {
  glm::dvec3 sum(0);
  double all = 0;
  const double near = std::clamp(0.5 * tool.core, kNear[0], kNear[1]);
  const Key stand = standOf(tool);
  forCells(region, grown({stand, stand}, static_cast<std::int32_t>(3 * near)),
           [&](Key key, std::size_t cell) {
             glm::dvec3 slope;
             for (std::size_t axis = 0; axis < 3; ++axis) {
               const std::ptrdiff_t step = region.strides()[axis];
               slope[static_cast<int>(axis)] =
                   region.value[cell - step] - region.value[cell + step];
             }
             if (slope == glm::dvec3(0)) return;
             const glm::dvec3 from = fromStand(tool, key);
             const double far = 1 + glm::dot(from, from) / (near * near);
             sum += slope / (far * far);
             all += glm::length(slope) / (far * far);
           });
  const double length = glm::length(sum);
  return length > 0.1 * all && length > 0 ? sum / length : glm::dvec3(0);
}

// Where no way is out, to all sides, slowly about the middle.
glm::dvec3 wayFrom(const glm::dvec3& from, double core) {
  return from / std::max(glm::length(from), 0.5 * core);
}

// By how deep in the tool cells are, and by what all of the clay inside can spare.
SwellSpeed allRound(const Region& region, const PlacedTool& tool) {
  const KeyBox box = common(tool.box, region.box());
  SwellSpeed swell{BoxField(box), BoxField(box), BoxField(box)};
  double sum = 0, all = 0;
  forCells(region, box, [&](Key key, std::size_t cell) {
    const double part = partAt(tool, key);
    swell.wanted[key] = swell.speed[key] = static_cast<float>(part);
    if (part <= 0 || !isInside(region, cell)) return;
    sum += part * std::min(1.0, static_cast<double>(region.value[cell]));
    all += part;
  });
  const auto mean = static_cast<float>(all > 0 ? sum / all : 0);
  forCells(region, box, [&](Key key, std::size_t) { swell.fullness[key] = mean; });
  return swell;
}

// As much as the clay inside can spare: 1 … 0.
double shareOf(double fullness) {
  return std::clamp((fullness - kSpent) / (kPlenty - kSpent), 0.0, 1.0);
}

}  // namespace

void Swelling::wishFor(Region& region, const PlacedTool& tool, const glm::dvec3& out) {
  const bool oneWay = out != glm::dvec3(0);
  const SwellSpeed swell = oneWay ? swellSpeed(region, tool, out) : allRound(region, tool);
  forCells(region, swell.speed.box(), [&](Key key, std::size_t cell) {
    const double free = 1 - region.hold[cell] / double{kFixed};
    const double speed = static_cast<double>(swell.speed.at(key)) * free;
    const double clay = std::min(1.0, static_cast<double>(region.value[cell]));
    const double share = shareOf(static_cast<double>(swell.fullness.at(key)));
    asked_ += static_cast<double>(swell.wanted.at(key)) * free * clay;
    given_ += share * speed * clay;
    if (share * speed <= 0) return;
    const glm::dvec3 way = oneWay ? out : wayFrom(fromStand(tool, key), tool.core);
    const double length = kRise * static_cast<double>(tool.strength) * share * speed;
    for (std::size_t axis = 0; axis < 3; ++axis)
      region.wish[axis][cell] += static_cast<float>(length * way[static_cast<int>(axis)]);
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

void Swelling::finish(Work& work) {
  for (int n = 0; n < kLastRounds && asked_ > 0; ++n) evening_.run(work.region, kSweeps);
}

std::string Swelling::remark() const {
  if (asked_ <= 0 || given_ >= kNamed * asked_) return {};
  return "swell: there is too little clay round the tool to draw from";
}

}  // namespace bozzetto::clay
