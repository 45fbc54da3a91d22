#include "clay/placed_tool.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "bozzetto/grid/key_box.hpp"
#include "clay/fours.hpp"

namespace bozzetto::clay {
namespace {

// Solids slope over two cells; tools for clay over one: clay wants sharp edges.
constexpr float kLeastValue = 0.25f;
float sharpened(float value) { return std::clamp(2 * value - 0.5f, 0.0f, 1.0f); }
Four sharpened(const Four& value) {
  return greater(lesser(allFour(2) * value - allFour(0.5f), allFour(1)), allFour(0));
}

// Of the 8 × 8 rows of a tile: those with cells of the tool, a bit each.
std::uint64_t rowsOf(const float* value) {
  std::uint64_t rows = 0;
  for (int n = 0; n < 512; n += 4)
    rows |= std::uint64_t{any(fourAt(value + n) > allFour(kLeastValue))} << n / 8;
  return rows;
}

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
  staticRows_ = region.covered.size();
  if (!region.clayInRim) return;
  for (const Axis axis : kAxes) holdFaces(region, axis);
}

// Supports press nothing out: clay in which one was put stays, held by it, and takes that room.
// (What clay that is pushed against a support leaves inside it is less than half a cell.)
void CoverPainter::sparePastClay(Region& region) {
  std::vector<std::size_t> spared;
  const auto look = [&](std::size_t cell) {
    if (region.cover[cell] < 1 || region.value[cell] < 0.5f) return;
    for (const std::ptrdiff_t i : {-1, 0, 1})
      for (const std::ptrdiff_t j : {-1, 0, 1})
        for (const std::ptrdiff_t k : {-1, 0, 1}) {
          const std::size_t near = cell + i * region.strides()[0] + j * region.strides()[1] + k;
          if (region.value[near] > 1 - region.cover[near]) spared.push_back(near);
        }
  };
  for (const CoveredRow& row : region.covered)
    for (std::size_t n = 0; n < Region::kTile; ++n)
      if ((row.cells >> n & 1) != 0) look(row.first + n);
  for (const std::size_t cell : spared) region.cover[cell] = 0;
  for (CoveredRow& row : region.covered)
    for (std::size_t n = 0; n < Region::kTile; ++n)
      if (region.cover[row.first + n] <= 0) row.cells &= static_cast<std::uint8_t>(~(1u << n));
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
  for (; !before_.empty(); before_.pop_back()) {
    const Painted& painted = before_.back();
    std::copy_n(painted.cover.data(), Region::kTile, &region.cover[painted.first]);
    std::copy_n(painted.owner.data(), Region::kTile, &region.owner[painted.first]);
  }
  region.covered.resize(staticRows_);
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
  std::uint64_t rows = rowsOf(value);
  if (rows == 0) return;
  const std::size_t first = region.index(tile);
  const auto& step = region.strides();
  for (; rows != 0; rows &= rows - 1) {
    const int row = std::countr_zero(rows);
    paintRow(region, {tool, owner, first + row / 8 * step[0] + row % 8 * step[1]}, &value[row * 8]);
  }
  region.enterBand(first);
  if (owner == kStatic) staticTiles_.push_back(first);
}

void CoverPainter::paintRow(Region& region, const Brush& brush, const float* value) {
  float* cover = &region.cover[brush.first];
  std::uint8_t* owner = &region.owner[brush.first];
  Painted before;
  before.first = brush.first;
  std::copy_n(cover, Region::kTile, before.cover.data());
  std::copy_n(owner, Region::kTile, before.owner.data());
  before_.push_back(before);
  std::uint32_t cells = 0;
  for (int n = 0; n < Region::kTile; ++n) cells |= std::uint32_t{value[n] > kLeastValue} << n;
  const bool isPlain = cells == 0xff && std::bit_cast<std::uint64_t>(before.owner) == 0;
  if (isPlain)
    std::memset(owner, brush.owner, Region::kTile);
  else
    for (int n = 0; n < Region::kTile; ++n)
      if ((cells >> n & 1) != 0 && owner[n] == kNobody) owner[n] = brush.owner;
  if (brush.tool.role == Role::grip) return;
  for (int n = 0; n < Region::kTile; n += 4)
    put(greater(fourAt(cover + n), sharpened(fourAt(value + n))), cover + n);
  region.covered.push_back(
      {static_cast<std::uint32_t>(brush.first), static_cast<std::uint8_t>(cells)});
}

bool touchesClay(const Region& region, const PlacedTool& tool) {
  bool touches = false;
  forTiles(common(tool.box, region.clayBox()), [&](Key tile) {
    if (touches) return;
    float value[512];
    tool.solid->evaluate(tile - tool.solid->cell, 8, value);
    for (int n = 0; n < 512 && !touches; ++n)
      touches = value[n] > kLeastValue &&
                region.value[region.index(tile + Key{n / 64, n / 8 % 8, n % 8})] > kThin;
  });
  return touches;
}

}  // namespace bozzetto::clay
