#include "clay/automaton.hpp"

#include <algorithm>
#include <cmath>

namespace bozzetto::clay {
namespace {

float floored(float x) { return std::floor(x / kQuantum) * kQuantum; }

// The axis and sign of a push, as one of the six neighbours; 6 where nothing moves.
int directionOf(const glm::dvec3& motion) {
  int axis = 0;
  for (int n = 1; n < 3; ++n)
    if (std::abs(motion[n]) > std::abs(motion[axis])) axis = n;
  if (motion[axis] == 0) return 6;
  return 2 * axis + (motion[axis] < 0 ? 1 : 0);
}

// Two tiles more on every side: whose blocks matter can reach.
KeyBox around(const std::vector<Key>& tiles) {
  KeyBox box{tiles.front(), tiles.front()};
  for (const Key tile : tiles)
    for (const Axis axis : kAxes) {
      box.low[axis] = std::min(box.low[axis], tile[axis]);
      box.high[axis] = std::max(box.high[axis], tile[axis]);
    }
  return tileBox(box, 2);
}

}  // namespace

// Each cell above its limit gives α·m, or no more than what is over full, in equal parts to the
// cells below theirs (Takai §2.2). What does not divide stays.
bool shareBlock(Region& region, const std::array<std::size_t, 8>& cells,
                const std::array<float, 8>& limit, const std::array<float, 8>& full,
                const Sharing& sharing) {
  std::uint8_t givers = 0, takers = 0;
  for (std::size_t n = 0; n < 8; ++n) {
    if (limit[n] < 0) continue;
    (region.value[cells[n]] > limit[n] ? givers : takers) |= static_cast<std::uint8_t>(1 << n);
  }
  if (givers == 0 || takers == 0) return false;
  int count = 0;
  for (std::size_t n = 0; n < 8; ++n) count += takers >> n & 1;
  bool given = false;
  for (std::size_t n = 0; n < 8; ++n) {
    if ((givers >> n & 1) == 0) continue;
    const float mass = region.value[cells[n]];
    float amount = mass * sharing.rate;
    if (sharing.rule == SharingRule::capped) amount = std::min(amount, mass - full[n]);
    const float share = floored(amount / static_cast<float>(count));
    given = given || share > 0;
    for (std::size_t to = 0; share > 0 && to < 8; ++to)
      if ((takers >> to & 1) != 0) region.carry(cells[n], cells[to], share);
  }
  return given;
}

// All matter that has no room in a tool's cell goes on along the push to the first cell outside
// (Takai §2.3); where the tool does not move, out of it the nearest way.
void Automaton::sweepOut(Work& work) {
  Region& region = work.region;
  for (const Row& row : region.rows())
    for (std::size_t cell = row.base; cell < row.base + row.count; ++cell) {
      const float over = region.value[cell] - (1 - region.cover[cell]);
      if (region.cover[cell] <= 0 || over <= 0 || region.hold[cell] == kFixed) continue;
      const Key key = region.key(cell), place = key - work.origin;
      int way = 6;
      for (const PlacedTool& tool : work.moving)
        if (tool.role == Role::push && tool.cover(key) > 0)
          way = directionOf(tool.motion.at(glm::dvec3(place.i, place.j, place.k)));
      for (const auto* tools : {&work.moving, &work.supports})
        for (const PlacedTool& tool : *tools)
          if (way == 6 && tool.cover(key) > 0) way = directionOf(tool.normal(key));
      std::size_t next = cell;
      while (way < 6 && region.cover[next] > 0.5f && region.hold[next] != kFixed)
        next += region.neighbours()[static_cast<std::size_t>(way)];
      if (next == cell && way < 6) next += region.neighbours()[static_cast<std::size_t>(way)];
      if (way == 6 || region.hold[next] == kFixed) continue;
      region.carry(cell, next, over);
      region.touch(cell);
      region.touch(next);
    }
}

bool Automaton::sweepTile(Work& work, Key tile, int parity) {
  Region& region = work.region;
  const Sharing sharing{static_cast<float>(work.settings.rate), work.settings.sharing};
  const auto threshold = static_cast<float>(work.settings.threshold);
  bool given = false;
  for (int n = 0; n < 64; ++n) {
    const Key low = tile + Key{n / 16 * 2 + parity, n / 4 % 4 * 2 + parity, n % 4 * 2 + parity};
    const std::size_t first = region.index(low);
    std::array<std::size_t, 8> cells;
    float most = 0;
    for (std::size_t c = 0; c < 8; ++c) {
      cells[c] =
          first + (c >> 2) * region.strides()[0] + (c >> 1 & 1) * region.strides()[1] + (c & 1);
      most = std::max(most, region.value[cells[c]]);
    }
    if (most <= 0) continue;
    std::array<float, 8> limit, full;
    for (std::size_t c = 0; c < 8; ++c) {
      const std::size_t cell = cells[c];
      full[c] = 1 - region.cover[cell];
      const bool obstacle = region.hold[cell] == kFixed || region.cover[cell] > 0.5f;
      limit[c] = obstacle ? -1.0f : threshold * full[c];
    }
    given = shareBlock(region, cells, limit, full, sharing) || given;
  }
  return given;
}

// Tiles with cells above their limits, and their neighbours: blocks reach over borders. Until these
// are looked for again matter goes no further than a tile.
void Automaton::findHot(Work& work) {
  listHot(work);
  while (!tiles_.empty() && work.widen && work.widen(around(tiles_))) listHot(work);
  hot_.assign(tiles_.size(), 1);
  spreadHeat(work.region);
}

void Automaton::listHot(Work& work) {
  const Region& region = work.region;
  const auto threshold = static_cast<float>(work.settings.threshold);
  tiles_.clear();
  for (const Row& row : region.rows())
    for (std::int32_t k = 0; k < row.count; ++k) {
      const std::size_t cell = row.base + k;
      if (region.value[cell] <= threshold * (1 - region.cover[cell])) continue;
      const Key tile = Key{row.i & ~7, row.j & ~7, (row.k + k) & ~7} + region.box().low;
      if (tiles_.empty() || tiles_.back() != tile) tiles_.push_back(tile);
    }
}

void Automaton::spreadHeat(const Region& region) {
  std::vector<Key> next;
  for (std::size_t n = 0; n < tiles_.size(); ++n)
    for (int d = 0; hot_[n] != 0 && d < 27; ++d) {
      const Key tile = tiles_[n] + Key{d / 9 - 1, d / 3 % 3 - 1, d % 3 - 1} * Region::kTile;
      if (!region.inRim(tile)) next.push_back(tile);
    }
  std::sort(next.begin(), next.end());
  next.erase(std::unique(next.begin(), next.end()), next.end());
  tiles_.swap(next);
}

bool Automaton::sweep(Work& work, int parity) {
  hot_.assign(tiles_.size(), 0);
  parallelFor(tiles_.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) hot_[n] = sweepTile(work, tiles_[n], parity) ? 1 : 0;
  });
  bool any = false;
  for (std::size_t n = 0; n < tiles_.size(); ++n) {
    if (hot_[n] == 0) continue;
    any = true;
    // Odd blocks reach into the next tiles.
    for (int c = 0; c < 8; ++c)
      work.region.touch(
          work.region.index(tiles_[n] + Key{c >> 2, c >> 1 & 1, c & 1} * (Region::kTile * parity)));
  }
  return any;
}

// Until nobody gives on even keys nor on odd ones; closed narrow tubes may swing for ever, so no
// more than so many sweeps (Takai §2.3).
void Automaton::run(Work& work) {
  pulling_.run(work);
  sweepOut(work);
  swelling_.run(work);
  findHot(work);
  int quiet = 0;
  for (int n = 0; n < work.settings.sweeps && quiet < 2 && !tiles_.empty(); ++n) {
    const bool given = sweep(work, static_cast<int>((work.step * work.settings.sweeps + n) % 2));
    quiet = given ? 0 : quiet + 1;
    if (given && n % 8 == 7) findHot(work);
  }
}

}  // namespace bozzetto::clay
