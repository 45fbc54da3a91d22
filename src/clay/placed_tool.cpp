#include "clay/placed_tool.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "bozzetto/grid/key_box.hpp"

namespace bozzetto::clay {
namespace {

// Solids slope over two cells; tools for clay over one: clay wants sharp edges.
float sharpened(float value) { return std::clamp(2 * value - 0.5f, 0.0f, 1.0f); }

template <class Callback>
void forTiles(const KeyBox& box, const Callback& callback) {
  if (box.empty()) return;
  const KeyBox tiles = tileBox(box, 0);
  constexpr std::int32_t step = Region::kTile;
  for (std::int32_t i = tiles.low.i; i <= tiles.high.i; i += step)
    for (std::int32_t j = tiles.low.j; j <= tiles.high.j; j += step)
      for (std::int32_t k = tiles.low.k; k <= tiles.high.k; k += step) callback(Key{i, j, k});
}

}  // namespace

float PlacedTool::cover(Key key) const {
  float value;
  solid->evaluate(key - solid->cell, 1, &value);
  return sharpened(value);
}

glm::dvec3 PlacedTool::normal(Key key) const {
  const Key local = key - solid->cell;
  const glm::dvec3 place(local.i, local.j, local.k);
  glm::dvec3 slope;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 step(0);
    step[axis] = 0.25;
    slope[axis] = solid->distance(place + step) - solid->distance(place - step);
  }
  const double length = glm::length(slope);
  return length > 0 ? slope / length : glm::dvec3(0, 1, 0);
}

std::uint8_t PlacedTool::waysOut(Key key) const {
  const glm::dvec3 out = normal(key);
  std::uint8_t ways = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (out[axis] >= 0.5) ways |= static_cast<std::uint8_t>(1 << 2 * axis);
    if (out[axis] <= -0.5) ways |= static_cast<std::uint8_t>(2 << 2 * axis);
  }
  return ways;
}

void CoverPainter::paintStatic(Region& region, const std::vector<PlacedTool>& supports) {
  region.covered.clear();
  staticTiles_.clear();
  for (const PlacedTool& tool : supports) paint(region, tool, tool.box, kStatic);
  before_.clear();
  sparePastClay(region);
  staticCells_ = region.covered.size();
  if (!region.clayInRim) return;
  for (const Axis axis : kAxes) holdFaces(region, axis);
}

// Supports press nothing out: clay in which one was put stays, held by it, and takes that room.
// (What clay that is pushed against a support leaves inside it is less than half a cell.)
void CoverPainter::sparePastClay(Region& region) {
  std::vector<std::uint32_t> spared;
  for (const std::uint32_t cell : region.covered) {
    if (region.cover[cell] < 1 || region.value[cell] < 0.5f) continue;
    for (const std::ptrdiff_t i : {-1, 0, 1})
      for (const std::ptrdiff_t j : {-1, 0, 1})
        for (const std::ptrdiff_t k : {-1, 0, 1}) {
          const std::size_t near = cell + i * region.strides()[0] + j * region.strides()[1] + k;
          if (region.value[near] > 1 - region.cover[near])
            spared.push_back(static_cast<std::uint32_t>(near));
        }
  }
  for (const std::uint32_t cell : spared) region.cover[cell] = 0;
  if (spared.empty()) return;
  std::erase_if(region.covered, [&](std::uint32_t cell) { return region.cover[cell] <= 0; });
}

// Clay that goes on beyond the region is held there.
void CoverPainter::holdFaces(Region& region, Axis axis) {
  const KeyBox inner = region.inner();
  const auto a = static_cast<std::size_t>(index(axis)), b = (a + 1) % 3, c = (a + 2) % 3;
  const Key size = inner.high - inner.low;
  const auto& step = region.strides();
  const std::size_t low = region.index(inner.low);
  const std::ptrdiff_t across = size[axis] * step[a];
  for (std::ptrdiff_t n = 0; n <= size[kAxes[b]]; ++n)
    for (std::ptrdiff_t m = 0; m <= size[kAxes[c]]; ++m) {
      const std::size_t first = low + n * step[b] + m * step[c], last = first + across;
      if (region.value[first - step[a]] > kThin) region.owner[first] = kStatic;
      if (region.value[last + step[a]] > kThin) region.owner[last] = kStatic;
    }
}

void CoverPainter::paintMoving(Region& region, const std::vector<PlacedTool>& moving,
                               const KeyBox& within) {
  for (auto painted = before_.rbegin(); painted != before_.rend(); ++painted) {
    region.cover[painted->cell] = painted->cover;
    region.owner[painted->cell] = painted->owner;
  }
  before_.clear();
  region.covered.resize(staticCells_);
  for (const std::size_t cell : staticTiles_) region.enterBand(cell);
  for (std::size_t n = 0; n < moving.size(); ++n)
    if (moving[n].role != Role::swell)
      paint(region, moving[n], common(moving[n].box, within),
            static_cast<std::uint8_t>(kMoving + n));
}

void CoverPainter::paint(Region& region, const PlacedTool& tool, const KeyBox& box,
                         std::uint8_t owner) {
  forTiles(common(box, region.inner()), [&](Key tile) { paintTile(region, tool, owner, tile); });
}

void CoverPainter::paintTile(Region& region, const PlacedTool& tool, std::uint8_t owner, Key tile) {
  float value[512];
  tool.solid->evaluate(tile - tool.solid->cell, 8, value);
  bool any = false;
  const std::size_t first = region.index(tile);
  const auto& step = region.strides();
  for (int n = 0; n < 512; ++n) {
    if (value[n] <= 0.25f) continue;
    any = true;
    const std::size_t cell = first + n / 64 * step[0] + n / 8 % 8 * step[1] + n % 8;
    before_.push_back({cell, region.cover[cell], region.owner[cell]});
    if (tool.role != Role::grip) {
      region.cover[cell] = std::max(region.cover[cell], sharpened(value[n]));
      region.covered.push_back(static_cast<std::uint32_t>(cell));
    }
    if (region.owner[cell] == kNobody) region.owner[cell] = owner;
  }
  if (!any) return;
  region.enterBand(region.index(tile));
  if (owner == kStatic) staticTiles_.push_back(region.index(tile));
}

bool touchesClay(const Region& region, const PlacedTool& tool) {
  bool touches = false;
  forTiles(common(tool.box, region.clayBox()), [&](Key tile) {
    if (touches) return;
    float value[512];
    tool.solid->evaluate(tile - tool.solid->cell, 8, value);
    for (int n = 0; n < 512 && !touches; ++n)
      touches = value[n] > 0.25f &&
                region.value[region.index(tile + Key{n / 64, n / 8 % 8, n % 8})] > kThin;
  });
  return touches;
}

}  // namespace bozzetto::clay
