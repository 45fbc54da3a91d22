#include "clay/clearing.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "clay/covered.hpp"

namespace bozzetto::clay {
namespace {

constexpr std::uint8_t kKnown = 0x80;  // in `mark`: the outward ways of this cell are there
constexpr std::uint8_t kQueued = 1;    // in `mark2`

bool holdsTooMuch(const Region& region, std::size_t cell) {
  const float room = 1 - region.cover[cell];
  return region.cover[cell] > 0 && region.value[cell] > kTooMuch * room + 2 * kQuantum;
}

}  // namespace

void Clearing::findExcess(Region& region) {
  now_.clear();
  forCrowded(region, [&](std::uint32_t cell) {
    if (region.mark2[cell] != 0 || region.hold[cell] == kFixed || !holdsTooMuch(region, cell))
      return;
    region.mark2[cell] = kQueued;  // tools may cover each other
    now_.push_back(cell);
  });
  for (const std::uint32_t cell : now_) region.mark2[cell] = 0;
}

// Directions out of all tools at the cell; where tools disagree, those of the last.
std::uint8_t Clearing::outwardAt(const Work& work, std::size_t cell) {
  Region& region = work.region;
  if ((region.mark[cell] & kKnown) != 0) return region.mark[cell] & 63;
  const Key key = region.key(cell);
  std::uint8_t ways = 63;
  const auto meet = [&](const PlacedTool& tool) {
    if (tool.role == Role::grip || !tool.box.contains(key) || tool.cover(key) <= 0) return;
    const std::uint8_t own = tool.waysOut(key);
    ways = (ways & own) != 0 ? ways & own : own;
  };
  for (const PlacedTool& tool : work.supports) meet(tool);
  for (const PlacedTool& tool : work.moving) meet(tool);
  region.mark[cell] = ways | kKnown;
  known_.push_back(static_cast<std::uint32_t>(cell));
  return ways;
}

// Without those into held clay, and into tool cells that are deeper.
std::uint8_t Clearing::waysFrom(const Work& work, std::size_t cell) {
  const Region& region = work.region;
  const std::uint8_t outward = outwardAt(work, cell);
  std::uint8_t ways = 0;
  for (int n = 0; n < 6; ++n) {
    const std::size_t next = cell + region.neighbours()[n];
    if ((outward >> n & 1) == 0 || region.hold[next] == kFixed) continue;
    const bool deeper = region.cover[next] > 0.01f && region.cover[next] >= region.cover[cell] &&
                        (outwardAt(work, next) >> n & 1) == 0;
    if (!deeper) ways |= static_cast<std::uint8_t>(1 << n);
  }
  return ways;
}

// Where no outward way is left, any that is not held or deeper.
std::uint8_t Clearing::openWays(const Region& region, std::size_t cell) const {
  std::uint8_t ways = 0;
  for (int n = 0; n < 6; ++n) {
    const std::size_t next = cell + region.neighbours()[n];
    if (region.hold[next] != kFixed && region.cover[next] < region.cover[cell])
      ways |= static_cast<std::uint8_t>(1 << n);
  }
  return ways;
}

// Equal parts all ways, but six givers leave no receiver with more than kMostDensity; the receivers
// that now hold too much are next.
void Clearing::give(Region& region, std::size_t cell, std::uint8_t ways) {
  const auto parts = static_cast<float>(std::popcount(ways));
  float share = (region.value[cell] - (1 - region.cover[cell])) / parts;
  for (int way = 0; way < 6; ++way)
    if ((ways >> way & 1) != 0)
      share = std::min(share, (kMostDensity - region.value[cell + region.neighbours()[way]]) / 6);
  share_.push_back(std::floor(std::max(share, 0.0f) / kQuantum) * kQuantum);
  ways_.push_back(ways);
}

void Clearing::run(Work& work, int sweeps) {
  Region& region = work.region;
  findExcess(region);
  for (int sweep = 0; sweep < sweeps && !now_.empty(); ++sweep) {
    share_.clear();
    ways_.clear();
    next_.clear();
    for (const std::uint32_t cell : now_) {
      const std::uint8_t out = ways(work, cell);
      if (out == 0)
        ways_.push_back(0), share_.push_back(0);
      else
        give(region, cell, out);
    }
    for (std::size_t n = 0; n < now_.size(); ++n)
      for (int way = 0; way < 6; ++way)
        if ((ways_[n] >> way & 1) != 0) {
          const std::size_t next = now_[n] + region.neighbours()[way];
          region.carry(now_[n], next, share_[n]);
          region.touch(now_[n]);
          region.touch(next);
          if (region.mark2[next] == 0) next_.push_back(static_cast<std::uint32_t>(next));
          region.mark2[next] = kQueued;
        }
    for (const std::uint32_t cell : next_) region.mark2[cell] = 0;
    std::erase_if(next_, [&](std::uint32_t cell) { return !holdsTooMuch(region, cell); });
    now_.swap(next_);
  }
  forget(region);
}

std::uint8_t Clearing::ways(const Work& work, std::size_t cell) {
  const std::uint8_t outward = waysFrom(work, cell);
  return outward != 0 ? outward : openWays(work.region, cell);
}

void Clearing::forget(Region& region) {
  for (const std::uint32_t cell : known_) region.mark[cell] = 0;
  known_.clear();
}

}  // namespace bozzetto::clay
