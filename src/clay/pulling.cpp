#include "clay/pulling.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bozzetto::clay {
namespace {

constexpr float kEnough = 0.001f;  // less is not missed
constexpr float kDense = 0.5f;

float floored(float x) { return std::floor(x / kQuantum) * kQuantum; }

}  // namespace

void Pulling::prepare(const Region& region) {
  if (wanted_ && box_ == region.box()) return;
  box_ = region.box();
  wanted_ = Cells<float>(static_cast<std::size_t>(box_.count()));
  lacking_.clear();
}

void Pulling::lack(std::size_t cell, float wanted) {
  if (wanted_[cell] <= 0) lacking_.push_back(static_cast<std::uint32_t>(cell));
  wanted_[cell] = std::max(wanted_[cell], wanted);
}

bool Pulling::lacks(const Region& region, std::size_t cell) const {
  return wanted_[cell] > region.value[cell] + kEnough;
}

// Clay that nobody holds.
bool Pulling::gives(const Region& region, std::size_t cell) const {
  const bool clay = region.value[cell] >= kDense || (wanted_[cell] > 0 && region.value[cell] > 0);
  return clay && region.hold[cell] != kFixed && region.owner[cell] < kMoving;
}

// Clay all round, or what was clay.
bool Pulling::inside(const Region& region, std::size_t cell) const {
  for (const std::ptrdiff_t step : region.neighbours())
    if (std::max(region.value[cell + step], wanted_[cell + step]) < kDense) return false;
  return true;
}

// All cells that the tool holds go one cell on, the foremost first.
void Pulling::shift(Work& work, std::size_t tool, int way) {
  Region& region = work.region;
  const std::ptrdiff_t step = region.neighbours()[static_cast<std::size_t>(way)];
  const KeyBox& box = work.moving[tool].box;
  moved_.clear();
  for (Key key = box.low; key.i <= box.high.i; ++key.i)
    for (key.j = box.low.j; key.j <= box.high.j; ++key.j)
      for (key.k = box.low.k; key.k <= box.high.k; ++key.k) {
        if (region.inRim(key)) continue;
        const std::size_t cell = region.index(key);
        if (region.owner[cell] == kMoving + tool && region.value[cell] > 0 &&
            region.hold[cell] != kFixed && region.hold[cell + step] != kFixed)
          moved_.push_back(static_cast<std::uint32_t>(cell));
      }
  if (step > 0) std::reverse(moved_.begin(), moved_.end());
  for (const std::uint32_t cell : moved_) {
    const float before = region.value[cell];
    region.carry(cell, cell + step, before);
    region.touch(cell);
    region.touch(cell + step);
    lack(cell, before);
  }
}

void Pulling::drag(Work& work) {
  prepare(work.region);
  way_.resize(work.moving.size(), glm::dvec3(0));
  for (std::size_t tool = 0; tool < work.moving.size(); ++tool) {
    const PlacedTool& grip = work.moving[tool];
    if (grip.role != Role::grip) continue;
    const Key at = grip.solid->cell - work.origin;
    glm::dvec3& way = way_[tool];
    way += grip.motion.at(glm::dvec3(at.i, at.j, at.k));
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(way[axis]) >= 1) {
        shift(work, tool, 2 * axis + (way[axis] < 0 ? 1 : 0));
        way[axis] -= way[axis] < 0 ? -1 : 1;
      }
  }
}

// A cell takes from those of its block that lack less, by the difference.
bool Pulling::shareBlock(Work& work, std::size_t first) {
  Region& region = work.region;
  std::array<std::size_t, 8> cells;
  std::array<float, 8> before, missing;
  std::array<bool, 8> gives;
  for (std::size_t c = 0; c < 8; ++c) {
    cells[c] =
        first + (c >> 2) * region.strides()[0] + (c >> 1 & 1) * region.strides()[1] + (c & 1);
    before[c] = region.value[cells[c]];
    missing[c] = std::max(0.0f, wanted_[cells[c]] - before[c]);
    gives[c] = this->gives(region, cells[c]);
  }
  const float part = static_cast<float>(work.settings.rate) / 8;
  bool shared = false;
  for (std::size_t t = 0; t < 8; ++t)
    for (std::size_t g = 0; g < 8; ++g) {
      const float wish = floored(part * (missing[t] - missing[g]));
      const float share = std::min(wish, region.value[cells[g]]);
      if (wanted_[cells[t]] <= 0 || !gives[g] || missing[t] - missing[g] < kEnough) continue;
      region.carry(cells[g], cells[t], share);
      region.touch(cells[t]);
      region.touch(cells[g]);
      shared = true;
    }
  for (std::size_t g = 0; shared && g < 8; ++g)
    if (region.value[cells[g]] < before[g] && inside(region, cells[g])) lack(cells[g], before[g]);
  return shared;
}

void Pulling::share(Work& work) {
  Region& region = work.region;
  bool shared = true;
  for (int n = 0; n < 2 * work.settings.sweeps && !lacking_.empty(); ++n) {
    const int parity = n % 2;
    if (parity == 0 && !std::exchange(shared, false)) break;
    blocks_.clear();
    for (const std::uint32_t cell : lacking_) {
      Key low = region.key(cell);
      for (const Axis axis : kAxes) low[axis] -= (low[axis] - parity) & 1;
      blocks_.push_back(static_cast<std::uint32_t>(region.index(low)));
    }
    std::sort(blocks_.begin(), blocks_.end());
    blocks_.erase(std::unique(blocks_.begin(), blocks_.end()), blocks_.end());
    for (const std::uint32_t block : blocks_) shared = shareBlock(work, block) || shared;
    std::erase_if(lacking_, [&](std::uint32_t cell) {
      if (lacks(region, cell)) return false;
      wanted_[cell] = 0;
      return true;
    });
  }
  // What is left stands alone in the air, or is asked for again in the next step.
  std::erase_if(lacking_, [&](std::uint32_t cell) {
    for (const std::ptrdiff_t step : region.neighbours())
      if (region.value[cell + step] > kEnough && region.owner[cell + step] < kMoving) return false;
    wanted_[cell] = 0;
    return true;
  });
}

}  // namespace bozzetto::clay
