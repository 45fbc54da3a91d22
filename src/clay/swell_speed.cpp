#include "clay/swell_speed.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "bozzetto/grid/key_box.hpp"
#include "clay/evening.hpp"

namespace bozzetto::clay {
namespace {

constexpr std::int32_t kBehind = 6;  // cells of clay behind a cell that moves as fast as it may
constexpr double kLeastFade = 4;     // cells below where the tool stands that move too
constexpr float kStands = 1;         // of these, that do not move

double smooth(double x) {
  const double p = std::clamp(x, 0.0, 1.0);
  return p * p * (3 - 2 * p);
}

// The axis that a way follows most, and what it takes to the side for each cell of that.
struct Lead {
  Axis axis, first, second;
  std::int32_t sign;
  double aside[2];
  float length;  // of the way for each cell

  explicit Lead(const glm::dvec3& out) {
    int most = 0;
    for (int n = 1; n < 3; ++n)
      if (std::abs(out[n]) > std::abs(out[most])) most = n;
    axis = kAxes[std::size_t(most)];
    first = kAxes[std::size_t(most + 1) % 3];
    second = kAxes[std::size_t(most + 2) % 3];
    sign = out[most] < 0 ? -1 : 1;
    aside[0] = out[index(first)] / std::abs(out[most]);
    aside[1] = out[index(second)] / std::abs(out[most]);
    length = static_cast<float>(1 / std::abs(out[most]));
  }
};

// What lies one cell behind, between the four keys round that place.
float behind(const BoxField& field, Key key, const Lead& lead) {
  Key base = key;
  base[lead.axis] -= lead.sign;
  const double low[2] = {std::floor(-lead.aside[0]), std::floor(-lead.aside[1])};
  const auto u = static_cast<float>(-lead.aside[0] - low[0]);
  const auto v = static_cast<float>(-lead.aside[1] - low[1]);
  base[lead.first] += static_cast<std::int32_t>(low[0]);
  base[lead.second] += static_cast<std::int32_t>(low[1]);
  float sum = 0;
  for (int n = 0; n < 4; ++n) {
    const int du = n & 1, dv = n >> 1;
    const float weight = (du != 0 ? u : 1 - u) * (dv != 0 ? v : 1 - v);
    if (weight <= 0) continue;
    Key at = base;
    at[lead.first] += du;
    at[lead.second] += dv;
    sum += weight * field.at(at);
  }
  return sum;
}

// Keys of a box, layer by layer the way the lead goes.
template <class Callback>
void forLayers(const KeyBox& box, const Lead& lead, const Callback& callback) {
  const std::int32_t low = box.low[lead.axis], high = box.high[lead.axis];
  Key key;
  for (std::int32_t n = 0; n <= high - low; ++n) {
    key[lead.axis] = lead.sign > 0 ? low + n : high - n;
    for (std::int32_t a = box.low[lead.first]; a <= box.high[lead.first]; ++a)
      for (std::int32_t b = box.low[lead.second]; b <= box.high[lead.second]; ++b) {
        key[lead.first] = a;
        key[lead.second] = b;
        callback(key);
      }
  }
}

// 1 where the tool stands and beyond, 0 so far below.
float fadeAt(const PlacedTool& tool, Key key, const glm::dvec3& out, double fade) {
  const Key local = key - tool.solid->cell;
  const double above = glm::dot(glm::dvec3(local.i, local.j, local.k) - tool.stand, out);
  return static_cast<float>(smooth(1 + above / fade));
}

// Of the tool, with a place below where it stands.
KeyBox boxOf(const PlacedTool& tool, const glm::dvec3& below) {
  const auto whole = [](double x) { return static_cast<std::int32_t>(std::lround(x)); };
  const Key stand = standOf(tool), down{whole(below.x), whole(below.y), whole(below.z)};
  return united(tool.box, {stand - down, stand - down});
}

}  // namespace

BoxField::BoxField(const KeyBox& box)
    : box_(box),
      size_(box.high - box.low + Key{1, 1, 1}),
      values_(static_cast<std::size_t>(box.count()), 0.0f) {}

std::size_t BoxField::index(Key key) const {
  const Key local = key - box_.low;
  return (static_cast<std::size_t>(local.i) * std::size_t(size_.j) + std::size_t(local.j)) *
             std::size_t(size_.k) +
         std::size_t(local.k);
}

double partAt(const PlacedTool& tool, Key key) {
  const Key local = key - tool.solid->cell;
  const double depth = -tool.solid->distance({local.i, local.j, local.k});
  return smooth(depth / tool.core);
}

Key standOf(const PlacedTool& tool) {
  const auto whole = [&](int axis) {
    return static_cast<std::int32_t>(std::lround(tool.stand[axis]));
  };
  return tool.solid->cell + Key{whole(0), whole(1), whole(2)};
}

SwellSpeed swellSpeed(const Region& region, const PlacedTool& tool, const glm::dvec3& out) {
  const Lead ahead(out), back(-out);
  const double fade = std::max(kLeastFade, tool.core);
  const KeyBox box = common(grown(boxOf(tool, fade * out), kBehind), region.box());
  BoxField part(box), clay(box), depth(box), wanted(box), speed(box), fullness(box);
  // The tool's form: the same all along a line.
  forLayers(box, ahead, [&](Key key) {
    const float own = tool.box.contains(key) ? static_cast<float>(partAt(tool, key)) : 0.0f;
    part[key] = std::max(own, behind(part, key, ahead));
  });
  forLayers(box, back, [&](Key key) { part[key] = std::max(part[key], behind(part, key, back)); });
  forLayers(box, ahead, [&](Key key) {
    const std::size_t cell = region.index(key);
    const float value = region.value[cell], before = behind(clay, key, ahead);
    const bool inside = !region.inRim(key) && isInside(region, cell);
    clay[key] = value;
    // How many cells inside stand behind, itself counted: those whose loss can be made good.
    const float stood = value >= 0.5f ? behind(depth, key, ahead) : 0.0f;
    depth[key] = stood + (inside ? ahead.length : 0.0f);
    const float stands = (depth[key] - kStands) * (1 / (kBehind - kStands));
    // The fringe of a surface goes with the clay that it is the fringe of.
    const float led = value < before ? behind(speed, key, ahead) : 0.0f;
    wanted[key] = part[key] * fadeAt(tool, key, out, fade);
    speed[key] = std::max(wanted[key] * std::clamp(stands, 0.0f, 1.0f), led);
    // How full the clay inside is there.
    const float full = behind(fullness, key, ahead);
    fullness[key] = !inside ? full : full > 0 ? 0.5f * (value + full) : value;
  });
  return {std::move(wanted), std::move(speed), std::move(fullness)};
}

}  // namespace bozzetto::clay
