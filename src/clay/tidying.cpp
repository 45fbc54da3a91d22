#include "clay/tidying.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace bozzetto::clay {
namespace {

constexpr float kDust = 0.05f, kFaint = 1e-3f, kDense = 0.5f;
constexpr int kFarthestClay = 40;  // cells a crumb may be away from what eats it

// The ways a cell's dust may go, a bit each: all, but what a grip holds stays in its row along the
// motion. A row that is ahead would take from those beside it at every step, and grow a thorn.
std::uint8_t waysOfDust(const Work& work, std::size_t cell) {
  constexpr std::uint8_t all = 63;
  const std::uint8_t owner = work.region.owner[cell];
  if (owner < kMoving || owner == kRim) return all;
  const PlacedTool& tool = work.moving[owner - kMoving];
  if (tool.role != Role::grip) return all;
  const Key place = work.region.key(cell) - work.origin;
  const glm::dvec3 motion = tool.motion.at(glm::dvec3(place.i, place.j, place.k));
  int axis = 0;
  for (int n = 1; n < 3; ++n)
    if (std::abs(motion[n]) > std::abs(motion[axis])) axis = n;
  return motion[axis] == 0 ? all : static_cast<std::uint8_t>(3 << 2 * axis);
}

// The neighbour that a cell of dust joins, as 1 + direction; 0 for none. Ties go to the first.
std::uint8_t refuge(const Work& work, std::size_t cell) {
  const Region& region = work.region;
  const float own = region.value[cell];
  if (own <= 0 || own >= kDust || region.hold[cell] == kFixed) return 0;
  float densest = own;
  std::uint8_t best = 0;
  const std::uint8_t ways = waysOfDust(work, cell);
  for (std::uint8_t way = 0; way < 6; ++way) {
    const std::size_t next = cell + region.neighbours()[way];
    if ((ways >> way & 1) == 0 || region.hold[next] == kFixed || region.cover[next] > 0 ||
        region.value[next] <= densest)
      continue;
    densest = region.value[next];
    best = static_cast<std::uint8_t>(way + 1);
  }
  if (best == 0 || (densest >= kDense && own >= kFaint)) return 0;
  return region.inBand(cell + region.neighbours()[best - 1]) ? best : 0;
}

bool anyDust(const float* value, int count) {
  int dust = 0;
  for (int n = 0; n < count; ++n) dust += value[n] > 0 && value[n] < kDust ? 1 : 0;
  return dust > 0;
}

// Any of eight cells, or of those round them, joins another.
bool moves(const Region& region, std::size_t first) {
  std::uint64_t any = 0;
  const auto look = [&](std::size_t cell) {
    std::uint64_t eight;
    std::memcpy(&eight, &region.mark[cell], sizeof eight);
    any |= eight;
  };
  look(first);
  for (const std::ptrdiff_t step : region.neighbours()) look(first + step);
  return any != 0;
}

// Gathers from the six neighbours what joins this cell, or gives all away.
void gather(Region& region, std::size_t cell) {
  const float own = region.mark[cell] == 0 ? region.value[cell] : 0.0f;
  float sum = own;
  for (std::uint8_t way = 0; way < 6; ++way) {
    const std::size_t from = cell - region.neighbours()[way];
    if (region.mark[from] == way + 1) sum += region.value[from];
  }
  region.scratch[cell] = sum;
}

void gatherCarried(Region& region, Cells<float>& channel, std::size_t cell) {
  const float own = region.mark[cell] == 0 ? region.value[cell] : 0.0f;
  float mass = own, sum = own * channel[cell];
  for (std::uint8_t way = 0; way < 6; ++way) {
    const std::size_t from = cell - region.neighbours()[way];
    if (region.mark[from] != way + 1) continue;
    mass += region.value[from];
    sum += region.value[from] * channel[from];
  }
  region.scratch2[cell] = mass > 0 ? sum / mass : channel[cell];
}

}  // namespace

void sweepDust(Work& work) {
  Region& region = work.region;
  region.touchRows();
  forRows(region.bandRows(), [&](const Row& row) {
    const bool any = anyDust(&region.value[row.base], row.count);
    for (std::size_t n = row.base; n < row.base + row.count; ++n)
      region.mark[n] = any ? refuge(work, n) : std::uint8_t{0};
  });
  for (auto& channel : region.carried) {
    forRows(region.bandRows(), [&](const Row& row) {
      for (std::size_t n = row.base; n < row.base + row.count; ++n)
        gatherCarried(region, channel, n);
    });
    forRows(region.bandRows(), [&](const Row& row) {
      std::copy_n(&region.scratch2[row.base], row.count, &channel[row.base]);
    });
  }
  forRows(region.bandRows(), [&](const Row& row) {
    for (std::size_t n = row.base; n < row.base + row.count; n += Region::kTile) {
      if (moves(region, n)) {
        for (std::size_t cell = n; cell < n + Region::kTile; ++cell) gather(region, cell);
      } else {
        std::copy_n(&region.value[n], Region::kTile, &region.scratch[n]);
      }
    }
  });
  forRows(region.bandRows(), [&](const Row& row) {
    std::copy_n(&region.scratch[row.base], row.count, &region.value[row.base]);
    std::fill_n(&region.mark[row.base], row.count, std::uint8_t{0});
  });
}

// Nowhere has it a whole cube of 3³ cells.
bool CrumbEater::isThin(const Work& work, std::uint32_t piece) const {
  const std::ptrdiff_t di = work.region.strides()[0], dj = work.region.strides()[1];
  const auto wholeRow = [&](std::size_t cell) {
    const float* v = &work.region.value[cell];
    return v[-1] >= work.iso && v[0] >= work.iso && v[1] >= work.iso;
  };
  for (const Pieces::Run& run : pieces_.runs())
    for (std::int32_t n = 1; run.root == piece && n + 1 < run.count; ++n) {
      int whole = 0;
      for (int row = 0; row < 9; ++row)
        whole += wholeRow(run.base + n + (row / 3 - 1) * di + (row % 3 - 1) * dj) ? 1 : 0;
      if (whole == 9) return false;
    }
  return true;
}

bool CrumbEater::isCrumb(const Work& work, std::uint32_t piece) const {
  const int few = work.settings.crumb;
  if (cellsOf_[piece] >= (work.settings.parting > 0 ? few * few : few)) return false;
  return (cellsOf_[piece] < few || isThin(work, piece)) && isWhole(work.region, piece);
}

// A piece that no rim cuts and that is not held.
bool CrumbEater::isWhole(const Region& region, std::uint32_t piece) const {
  for (const Pieces::Run& run : pieces_.runs()) {
    if (run.root != piece) continue;
    for (std::size_t cell = run.base; cell < run.base + run.count; ++cell) {
      if (region.hold[cell] == kFixed) return false;
      for (const std::ptrdiff_t step : region.neighbours())
        if (region.owner[cell + step] == kRim && region.value[cell + step] > 0) return false;
    }
  }
  return true;
}

// Ring by ring; in a ring the smallest key.
std::size_t CrumbEater::nearestClay(const Work& work, std::uint32_t piece) {
  Region& region = work.region;
  std::vector<std::uint32_t> seen = crumb_;
  for (const std::uint32_t cell : seen) region.mark2[cell] = 1;
  ring_ = crumb_;
  std::size_t found = 0;
  for (int n = 0; n < kFarthestClay && found == 0 && !ring_.empty(); ++n) {
    next_.clear();
    for (const std::uint32_t cell : ring_)
      for (const std::ptrdiff_t step : region.neighbours()) {
        const std::size_t next = cell + step;
        if (region.mark2[next] != 0 || region.hold[next] == kFixed) continue;
        region.mark2[next] = 1;
        next_.push_back(static_cast<std::uint32_t>(next));
        if (region.value[next] >= work.iso && pieces_.pieceAt(next) != piece &&
            (found == 0 || next < found))
          found = next;
      }
    seen.insert(seen.end(), next_.begin(), next_.end());
    ring_.swap(next_);
  }
  for (const std::uint32_t cell : seen) region.mark2[cell] = 0;
  return found;
}

void CrumbEater::eat(Work& work, std::uint32_t piece) {
  Region& region = work.region;
  crumb_.clear();
  for (const Pieces::Run& run : pieces_.runs())
    if (run.root == piece)
      for (std::int32_t n = 0; n < run.count; ++n)
        crumb_.push_back(static_cast<std::uint32_t>(run.base + n));
  const std::size_t target = nearestClay(work, piece);
  if (target == 0) return;
  for (const std::uint32_t cell : crumb_) {
    for (const std::ptrdiff_t step : region.neighbours()) {
      const std::size_t fringe = cell + step;
      if (region.value[fringe] >= work.iso || region.hold[fringe] == kFixed) continue;
      bool touches = false;
      for (const std::ptrdiff_t other : region.neighbours())
        touches = touches || (region.value[fringe + other] >= work.iso &&
                              region.owner[fringe + other] != kRim &&
                              pieces_.pieceAt(fringe + other) != piece);
      if (touches || fringe == target) continue;
      region.carry(fringe, target, region.value[fringe]);
      region.touch(fringe);
    }
  }
  for (const std::uint32_t cell : crumb_) {
    region.carry(cell, target, region.value[cell]);
    region.touch(cell);
  }
  region.touch(target);
  eaters_.push_back(target);
  ++work.report.crumbs;
}

// What is more than full goes on, ring by ring, to cells with room that touch clay.
void CrumbEater::settle(Work& work, std::size_t target) {
  Region& region = work.region;
  const auto room = [&](std::size_t cell) { return 1 - region.cover[cell] - region.value[cell]; };
  ring_.assign(1, static_cast<std::uint32_t>(target));
  region.mark2[target] = 1;
  for (std::size_t n = 0; n < ring_.size() && room(target) < 0; ++n) {
    if (region.value[ring_[n]] < kDense) continue;
    for (const std::ptrdiff_t step : region.neighbours()) {
      const std::size_t next = ring_[n] + step;
      if (region.mark2[next] != 0 || isClosed(region, next) || region.owner[next] == kRim) continue;
      region.mark2[next] = 1;
      ring_.push_back(static_cast<std::uint32_t>(next));
      const float most = std::min(-room(target), room(next));
      const float amount = std::floor(most / kQuantum) * kQuantum;
      if (amount <= 0) continue;
      region.carry(target, next, amount);
      region.touch(next);
    }
  }
  for (const std::uint32_t cell : ring_) region.mark2[cell] = 0;
}

void CrumbEater::run(Work& work, Eaten eaten) {
  if (work.settings.crumb <= 1) return;
  pieces_.find(work.region, work.iso);
  const auto& runs = pieces_.runs();
  cellsOf_.assign(runs.size(), 0);
  eaters_.clear();
  for (const Pieces::Run& run : runs) cellsOf_[run.root] += run.count;
  for (std::uint32_t n = 0; n < runs.size(); ++n)
    if (runs[n].root == n && isCrumb(work, n)) eat(work, n);
  // Not before: a crumb may have eaten another, and goes with it.
  for (const std::size_t eater : eaters_)
    if (eaten == Eaten::findsRoom) settle(work, eater);
}

}  // namespace bozzetto::clay
