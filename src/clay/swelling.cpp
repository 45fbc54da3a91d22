#include "clay/swelling.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "clay/projection.hpp"
#include "clay/transport.hpp"

namespace bozzetto::clay {
namespace {

constexpr double kRise = 0.15;   // cells a step, at the tool's core, with strength 1
constexpr int kSweeps = 12;      // over what lacks, a step
constexpr float kFull = 0.995f;  // less lacks

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

bool inside(const Region& region, std::size_t cell) {
  if (region.value[cell] < 0.5f || region.hold[cell] == kFixed || region.cover[cell] > 0)
    return false;
  for (const std::ptrdiff_t step : region.neighbours())
    if (region.value[cell + step] < 0.5f) return false;
  return true;
}

}  // namespace

void evenBlock(Region& region, const std::array<std::size_t, 8>& cells) {
  float sum = 0;
  for (const std::size_t cell : cells) sum += region.value[cell];
  const float mean = quantised(sum / 8);
  for (const std::size_t giver : cells)
    for (const std::size_t taker : cells) {
      const float amount = std::min(region.value[giver] - mean, mean - region.value[taker]);
      if (amount > 0) region.carry(giver, taker, amount);
    }
}

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
  if (!region.wished)
    for (auto& axis : region.wish)
      forRows(region.rows(),
              [&](const Row& row) { std::fill_n(&axis[row.base], row.count, 0.0f); });
  for (const PlacedTool& tool : work.moving)
    if (tool.role == Role::swell) wishFor(region, tool, wayOut(region, tool));
  region.wished = true;
  return true;
}

void Swelling::listLacking(const Region& region) {
  tiles_.clear();
  for (const Row& row : region.denseRows())
    for (std::int32_t k = 0; k < row.count; ++k) {
      const std::size_t cell = row.base + k;
      if (region.value[cell] >= kFull || !inside(region, cell)) continue;
      const Key low = Key{row.i & ~7, row.j & ~7, (row.k + k) & ~7} + region.box().low;
      for (int d = 0; d < 27; ++d) {
        const Key tile = low + Key{d / 9 - 1, d / 3 % 3 - 1, d % 3 - 1} * Region::kTile;
        if (!region.inRim(tile) && (tiles_.empty() || tiles_.back() != tile))
          tiles_.push_back(tile);
      }
      k |= 7;  // the tile is known
    }
  std::sort(tiles_.begin(), tiles_.end());
  tiles_.erase(std::unique(tiles_.begin(), tiles_.end()), tiles_.end());
}

void Swelling::even(Region& region, int parity) {
  const auto& step = region.strides();
  parallelFor(tiles_.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
      for (int n = 0; n < 64; ++n) {
        const Key low =
            tiles_[t] + Key{n / 16 * 2 + parity, n / 4 % 4 * 2 + parity, n % 4 * 2 + parity};
        const std::size_t first = region.index(low);
        std::array<std::size_t, 8> cells;
        bool all = true;
        for (std::size_t c = 0; c < 8; ++c) {
          cells[c] = first + (c >> 2) * step[0] + (c >> 1 & 1) * step[1] + (c & 1);
          all = all && region.mark[cells[c]] != 0;
        }
        if (all) evenBlock(region, cells);
      }
  });
}

void Swelling::run(Work& work) {
  if (!wish(work)) return;
  Region& region = work.region;
  followWish(work);
  transport(work);
  region.refreshRows();
  listLacking(region);
  const auto forTiles = [&](const auto& body) {
    for (const Key tile : tiles_)
      for (int n = 0; n < 64; ++n) body(region.index(tile + Key{n / 8, n % 8, 0}));
  };
  // What is inside stays so: clay inside never falls below a half.
  forTiles([&](std::size_t row) {
    for (std::size_t cell = row; cell < row + 8; ++cell) region.mark[cell] = inside(region, cell);
  });
  for (int n = 0; n < kSweeps; ++n) even(region, n % 2);
  forTiles([&](std::size_t row) { std::fill_n(&region.mark[row], 8, std::uint8_t{0}); });
  region.touchRows();
}

}  // namespace bozzetto::clay
