#include "clay/paper.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace bozzetto::clay {
namespace {

constexpr float kPaperTooMuch = 1.01f;                    // §3.2.3
constexpr float kThinMatter = 0.3f, kWantedSlope = 0.3f;  // §3.3

struct Share {
  std::size_t cell;
  float amount;
};

// q at p + δ over the eight nodes round it: products of closeness, the largest by subtraction so
// that nothing is lost. What would enter held cells stays at home.
std::array<Share, 8> sharesOf(const Region& region, std::size_t cell) {
  std::array<Share, 8> shares;
  std::size_t base = cell;
  float part[3];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float move = std::clamp(region.wish[axis][cell], -1.0f, 1.0f);
    const float whole = std::floor(move);
    part[axis] = move - whole;
    base += static_cast<std::ptrdiff_t>(whole) * region.strides()[axis];
  }
  const float q = region.value[cell];
  float rest = q;
  std::size_t largest = 0;
  for (std::size_t n = 0; n < 8; ++n) {
    float weight = q;
    std::size_t node = base;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool far = (n >> axis & 1) != 0;
      weight *= far ? part[axis] : 1 - part[axis];
      if (far) node += region.strides()[axis];
    }
    shares[n] = {region.hold[node] == kFixed ? cell : node, quantised(weight)};
    rest -= shares[n].amount;
    if (shares[n].amount > shares[largest].amount) largest = n;
  }
  shares[largest].amount += rest;
  return shares;
}

template <class Callback>
void forClay(const Region& region, const Callback& callback) {
  for (const Row& row : region.rows())
    for (std::size_t cell = row.base; cell < row.base + row.count; ++cell)
      if (region.value[cell] > 0) callback(cell);
}

}  // namespace

void splat(Region& region) {
  const std::array<Cells<float>*, 4> sums{&region.face[0], &region.face[1], &region.face[2],
                                          &region.flux};
  for (auto* cells :
       {&region.scratch, &region.face[0], &region.face[1], &region.face[2], &region.flux})
    forRows(region.rows(),
            [&](const Row& row) { std::fill_n(&(*cells)[row.base], row.count, 0.0f); });
  const std::size_t carried = region.carried.size();
  forClay(region, [&](std::size_t cell) {
    for (const Share& share : sharesOf(region, cell)) {
      region.scratch[share.cell] += share.amount;
      for (std::size_t n = 0; n < carried; ++n)
        (*sums[n])[share.cell] += share.amount * region.carried[n][cell];
    }
  });
  forRows(region.rows(), [&](const Row& row) {
    for (std::size_t cell = row.base; cell < row.base + row.count; ++cell) {
      const float mass = region.value[cell] = region.scratch[cell];
      for (std::size_t n = 0; mass > 0 && n < carried; ++n)
        region.carried[n][cell] = (*sums[n])[cell] / mass;
    }
  });
  region.wished = false;
  region.touchRows();
}

void PaperDisplacement::run(Work& work) {
  wish_.run(work);
  if (work.region.wished) splat(work.region);
}

void PaperConservation::queueAll(Region& region) {
  queue_.clear();
  for (const Row& row : region.rows())
    for (std::size_t cell = row.base; cell < row.base + row.count; ++cell) {
      if (region.value[cell] <= kPaperTooMuch * (1 - region.cover[cell])) continue;
      if (region.hold[cell] == kFixed) continue;
      queue_.push_back(static_cast<std::uint32_t>(cell));
      region.mark2[cell] = 1;
    }
}

// Outwards in tools; in the open all ways but into held cells and deep into tools.
std::uint8_t PaperConservation::waysFrom(const Work& work, std::size_t cell) {
  const Region& region = work.region;
  if (region.cover[cell] > 0) return clearing_.ways(work, cell);
  std::uint8_t ways = 0;
  for (int n = 0; n < 6; ++n) {
    const std::size_t next = cell + region.neighbours()[n];
    const bool deeper = region.cover[next] > 0.5f;
    if (region.hold[next] != kFixed && !deeper) ways |= static_cast<std::uint8_t>(1 << n);
  }
  return ways;
}

// In the open 6/5 of the excess in six parts, for a sixth comes back; inside tools exactly the
// excess.
PaperConservation::Gift PaperConservation::giftOf(const Work& work, std::size_t cell) {
  const Region& region = work.region;
  const float room = 1 - region.cover[cell], value = region.value[cell];
  if (value <= kPaperTooMuch * room + kQuantum) return {0, 0};
  const std::uint8_t ways = waysFrom(work, cell);
  if (ways == 0) return {0, 0};
  const float excess = value - room;
  const float amount = std::min(value, region.cover[cell] > 0 ? excess : over_ * excess);
  const auto parts = static_cast<float>(std::popcount(ways));
  return {std::floor(amount / parts / kQuantum) * kQuantum, ways};
}

// Who receives is asked next.
void PaperConservation::give(Region& region, std::size_t cell, const Gift& gift) {
  for (int n = 0; n < 6; ++n) {
    if ((gift.ways >> n & 1) == 0) continue;
    const std::size_t next = cell + region.neighbours()[n];
    region.carry(cell, next, gift.share);
    if (region.mark2[next] == 0) queue_.push_back(static_cast<std::uint32_t>(next));
    region.mark2[next] = 1;
  }
}

void PaperConservation::runQueue(Work& work) {
  Region& region = work.region;
  std::size_t taken = 0;
  const auto most = static_cast<std::size_t>(work.settings.iterations);
  for (; taken < queue_.size() && taken < most; ++taken) {
    region.mark2[queue_[taken]] = 0;
    give(region, queue_[taken], giftOf(work, queue_[taken]));
  }
  for (; taken < queue_.size(); ++taken) region.mark2[queue_[taken]] = 0;
}

// All look first, then all give (clay.md §5 and §11, case 6).
void PaperConservation::runSweeps(Work& work) {
  Region& region = work.region;
  std::int64_t taken = 0;
  while (!queue_.empty() && taken < work.settings.iterations) {
    now_.swap(queue_);
    queue_.clear();
    gifts_.clear();
    for (const std::uint32_t cell : now_) {
      region.mark2[cell] = 0;
      gifts_.push_back(giftOf(work, cell));
    }
    for (std::size_t n = 0; n < now_.size(); ++n) {
      if (gifts_[n].ways == 0) continue;
      ++taken;
      give(region, now_[n], gifts_[n]);
      if (region.mark2[now_[n]] == 0) queue_.push_back(now_[n]);  // it may still hold too much
      region.mark2[now_[n]] = 1;
    }
  }
  for (const std::uint32_t cell : queue_) region.mark2[cell] = 0;
}

void PaperConservation::run(Work& work) {
  Region& region = work.region;
  queueAll(region);
  if (giving_ == Giving::queue)
    runQueue(work);
  else
    runSweeps(work);
  clearing_.forget(region);
  region.touchRows();
}

// To all denser neighbours, by how much denser they are.
void PaperTension::plan(const Region& region, std::size_t cell) {
  const float value = region.value[cell];
  if (value >= kThinMatter || region.hold[cell] == kFixed) return;
  float slope = 0, denser = 0;
  for (const std::ptrdiff_t step : region.strides()) {
    const float along = 0.5f * (region.value[cell + step] - region.value[cell - step]);
    slope += along * along;
  }
  if (slope >= kWantedSlope * kWantedSlope) return;
  const auto open = [&](std::size_t next) {
    return region.hold[next] != kFixed && region.cover[next] <= 0 && region.value[next] > value;
  };
  std::size_t best = cell;
  for (const std::ptrdiff_t step : region.neighbours())
    if (open(cell + step)) {
      denser += region.value[cell + step] - value;
      if (region.value[cell + step] > region.value[best]) best = cell + step;
    }
  if (denser <= 0) return;
  float rest = value;
  for (const std::ptrdiff_t step : region.neighbours()) {
    const std::size_t next = cell + step;
    if (!open(next) || next == best) continue;
    const float amount = quantised(value * (region.value[next] - value) / denser);
    gifts_.push_back({static_cast<std::uint32_t>(cell), static_cast<std::uint32_t>(next), amount});
    rest -= amount;
  }
  gifts_.push_back({static_cast<std::uint32_t>(cell), static_cast<std::uint32_t>(best), rest});
}

void PaperTension::run(Work& work) {
  gifts_.clear();
  forClay(work.region, [&](std::size_t cell) { plan(work.region, cell); });
  for (const Gift& gift : gifts_) work.region.carry(gift.from, gift.to, gift.amount);
  work.region.touchRows();
}

}  // namespace bozzetto::clay
