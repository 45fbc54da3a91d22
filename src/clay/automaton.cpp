#include "clay/automaton.hpp"

#include <algorithm>
#include <cmath>

namespace bozzetto::clay {
namespace {

constexpr int kFairing = 4;  // passes a step

// In mark2: a cell of a block that gave; the first cell of a tile with such cells, and of one that
// is listed already.
enum Mark : std::uint8_t { kMoved = 1, kTileMoved = 2, kTileListed = 4 };

float floored(float x) { return std::floor(x / kQuantum) * kQuantum; }

// The axis and sign of a push, as one of the six neighbours; 6 where nothing moves.
int directionOf(const glm::dvec3& motion) {
  int axis = 0;
  for (int n = 1; n < 3; ++n)
    if (std::abs(motion[n]) > std::abs(motion[axis])) axis = n;
  if (motion[axis] == 0) return 6;
  return 2 * axis + (motion[axis] < 0 ? 1 : 0);
}

// The push, if it is a moving tool's cell, then the normal's axes, the steepest first; 6: none.
std::array<int, 4> waysOf(const Work& work, std::size_t cell) {
  const Key key = work.region.key(cell), place = key - work.origin;
  std::array<int, 4> ways{6, 6, 6, 6};
  const bool isStatic = work.region.owner[cell] == kStatic;
  for (const PlacedTool& tool : isStatic ? work.supports : work.moving) {
    if (tool.role == Role::grip || tool.role == Role::swell || tool.cover(key) <= 0) continue;
    if (!isStatic) ways[0] = directionOf(tool.motion.at(glm::dvec3(place.i, place.j, place.k)));
    glm::dvec3 normal = tool.normal(key);
    for (std::size_t n = 1; n < 4; ++n) {
      ways[n] = directionOf(normal);
      if (ways[n] < 6) normal[ways[n] / 2] = 0;
    }
  }
  return ways;
}

// The first cell outside the tool; this one, where something closed is in the way.
std::size_t wayOut(const Region& region, std::size_t cell, std::size_t way) {
  std::size_t next = cell + region.neighbours()[way];
  while (isClosed(region, next)) {
    if (!isOfSameKind(region, next, cell)) return cell;
    next += region.neighbours()[way];
  }
  return next;
}

bool anyAbove(const float* value, const float* cover, float threshold, int count) {
  int above = 0;
  for (int n = 0; n < count; ++n) above += value[n] > threshold * (1 - cover[n]) ? 1 : 0;
  return above > 0;
}

// Partly full, or beside a cell that is.
bool isOnSurface(const Region& region, std::size_t cell) {
  const auto partly = [&](std::size_t at) {
    return region.value[at] < 0.98f * (1 - region.cover[at]) && region.cover[at] <= 0.5f;
  };
  for (const std::ptrdiff_t step : region.neighbours())
    if (partly(cell + step)) return true;
  return partly(cell);
}

// The first cells of the rows of a tile, from its own first cell.
template <class Callback>
void forRowsOfTile(const Region& region, std::size_t first, const Callback& callback) {
  for (int n = 0; n < 64; ++n)
    callback(first + n / 8 * region.strides()[0] + n % 8 * region.strides()[1]);
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
// (Takai §2.3); where the tool does not move, or something closed is in that way, out of it by the
// axes of its normal.
void Automaton::sweepOut(Work& work) {
  Region& region = work.region;
  for (const Row& row : region.rows())
    for (std::size_t cell = row.base; cell < row.base + row.count; ++cell) {
      const float over = region.value[cell] - (1 - region.cover[cell]);
      if (region.cover[cell] <= 0 || over <= 0 || region.hold[cell] == kFixed) continue;
      std::size_t next = cell;
      for (const int way : waysOf(work, cell))
        if (next == cell && way < 6) next = wayOut(region, cell, static_cast<std::size_t>(way));
      if (next == cell) continue;
      region.carry(cell, next, over);
      region.touch(cell);
      region.touch(next);
    }
}

bool Automaton::sweepTile(Work& work, Key tile, int parity) {
  Region& region = work.region;
  const Sharing sharing{static_cast<float>(work.settings.rate), work.settings.sharing};
  const auto threshold = static_cast<float>(work.settings.threshold);
  const auto& step = region.strides();
  const std::size_t base = region.index(tile + Key{parity, parity, parity});
  bool given = false;
  for (int n = 0; n < 64; ++n) {
    const std::size_t first = base + 2 * (n / 16 * step[0] + n / 4 % 4 * step[1] + n % 4);
    std::array<std::size_t, 8> cells;
    std::array<float, 8> limit, full;
    bool above = false;
    for (std::size_t c = 0; c < 8; ++c) {
      cells[c] = first + (c >> 2) * step[0] + (c >> 1 & 1) * step[1] + (c & 1);
      full[c] = 1 - region.cover[cells[c]];
      above |= region.value[cells[c]] > threshold * full[c];
    }
    if (!above) continue;
    for (std::size_t c = 0; c < 8; ++c) {
      const std::size_t cell = cells[c];
      const bool obstacle = region.hold[cell] == kFixed || region.cover[cell] > 0.5f;
      limit[c] = obstacle ? -1.0f : threshold * full[c];
    }
    if (!shareBlock(region, cells, limit, full, sharing)) continue;
    given = true;
    for (const std::size_t cell : cells) region.mark2[cell] |= kMoved;
  }
  return given;
}

template <class Callback>
void Automaton::forMoved(const Region& region, const Callback& callback) const {
  for (const std::uint32_t first : given_)
    forRowsOfTile(region, first, [&](std::size_t row) {
      for (std::size_t cell = row; cell < row + Region::kTile; ++cell)
        if ((region.mark2[cell] & kMoved) != 0) callback(cell);
    });
}

// Cells of blocks that gave, if they are of the surface.
void Automaton::listMoved(Region& region) {
  forMoved(region, [&](std::size_t cell) {
    if (isOnSurface(region, cell)) moved_.note(cell);
  });
  for (const std::uint32_t first : given_)
    forRowsOfTile(region, first, [&](std::size_t row) {
      std::fill_n(&region.mark2[row], Region::kTile, std::uint8_t{0});
    });
  given_.clear();
}

// Tiles with cells above their limits, and their neighbours: blocks reach over borders. Until these
// are looked for again matter goes no further than a tile.
void Automaton::findHot(Work& work) {
  listHot(work);
  while (widen(work)) listHot(work);
  hot_.assign(tiles_.size(), 1);
  spreadHeat(work.region);
}

// What was noted in the old region is noted in the new one.
bool Automaton::widen(Work& work) {
  if (tiles_.empty() || !work.widen) return false;
  const KeyBox wanted = around(tiles_), inner = work.region.inner();
  if (inner.contains(wanted.low) && inner.contains(wanted.high)) return false;
  MovedCells moved;
  moved.follow(work.region);
  forMoved(work.region, [&](std::size_t cell) { moved.note(cell); });
  if (!work.widen(wanted)) return false;
  given_.clear();
  moved.follow(work.region);
  for (const std::uint32_t cell : moved.cells()) {
    work.region.mark2[cell] |= kMoved;
    const Key key = work.region.key(cell);
    note(work.region, tileBox({key, key}, 0).low);
  }
  return true;
}

void Automaton::note(Region& region, Key tile) {
  const std::size_t first = region.index(tile);
  if ((region.mark2[first] & kTileMoved) != 0) return;
  region.mark2[first] |= kTileMoved;
  given_.push_back(static_cast<std::uint32_t>(first));
}

void Automaton::listHot(Work& work) {
  const Region& region = work.region;
  const auto threshold = static_cast<float>(work.settings.threshold);
  tiles_.clear();
  for (const Row& row : region.rows()) {
    const float *value = &region.value[row.base], *cover = &region.cover[row.base];
    if (!anyAbove(value, cover, threshold, row.count)) continue;
    for (std::int32_t k = 0; k < row.count; k += Region::kTile) {
      if (!anyAbove(value + k, cover + k, threshold, Region::kTile)) continue;
      const Key tile = Key{row.i & ~7, row.j & ~7, row.k + k} + region.box().low;
      if (tiles_.empty() || tiles_.back() != tile) tiles_.push_back(tile);
    }
  }
}

void Automaton::spreadHeat(Region& region) {
  std::vector<Key> next;
  for (std::size_t n = 0; n < tiles_.size(); ++n)
    for (int d = 0; hot_[n] != 0 && d < 27; ++d) {
      const Key tile = tiles_[n] + Key{d / 9 - 1, d / 3 % 3 - 1, d % 3 - 1} * Region::kTile;
      if (region.inRim(tile)) continue;
      std::uint8_t& mark = region.mark2[region.index(tile)];
      if ((mark & kTileListed) != 0) continue;
      mark |= kTileListed;
      next.push_back(tile);
    }
  for (const Key tile : next) region.mark2[region.index(tile)] &= kMoved | kTileMoved;
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
    for (int c = 0; c < (parity == 0 ? 1 : 8); ++c) {
      const Key tile = tiles_[n] + Key{c >> 2, c >> 1 & 1, c & 1} * Region::kTile;
      note(work.region, tile);
      work.region.touch(work.region.index(tile));
    }
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
  listMoved(work.region);
  fairing_.run(work, moved_, kFairing);
}

}  // namespace bozzetto::clay
