#include "clay/fairing.hpp"

#include <algorithm>
#include <bit>

#include "bozzetto/base/simd.hpp"
#include "clay/fours.hpp"

namespace bozzetto::clay {
namespace {

constexpr float kRate = 0.15f;  // less than 1/6, where shares of six neighbours begin to swing
// A plane of clay over two cells, blurred, has slopes of 3/4: sharpened so, it is what it was.
constexpr float kSharpen = 4.0f / 3;
constexpr float kOutside = 0.125f;  // blurred densities that sharpen to 0, and to 1
constexpr float kInside = 0.875f;
constexpr std::uint8_t kListed = 1;

// Eight cells in a row and four more on either side: vectors of a size.
constexpr int kBeside = 4, kSide = Region::kTile, kGroup = kSide + 2 * kBeside;

struct Arrays {
  const float *value, *cover;
  const std::uint8_t* hold;
  float *excess, *mean;
  std::ptrdiff_t slab, row;
};

// The weight of a row of the 3 × 3 round a cell, by (1 2 1)², and where it begins.
struct RowOfNine {
  std::ptrdiff_t first;
  float weight;
};
BOZZETTO_KERNEL RowOfNine rowOfNine(const Arrays& at, std::ptrdiff_t first, int number) {
  const int i = number / 3 - 1, j = number % 3 - 1;
  return {first + i * at.slab + j * at.row - kBeside,
          static_cast<float>((2 - i * i) * (2 - j * j))};
}

// Cells that a tool takes just half of are open here: closed, those along a plate at half a cell
// would keep their teeth.
BOZZETTO_KERNEL int isOpenCell(float cover, std::uint8_t hold) {
  return (hold < kFixed) & (cover <= kClosedCover);
}

// How full a cell is of what it has room for; full where there is none.
BOZZETTO_KERNEL float fullness(float value, float cover) {
  const float full = value / (1 - cover);
  return full < 1 ? full : 1.0f;
}

// What eight cells have too much for a smooth surface, and their blurred density. `open`: how much
// of the (1 2 1)³ round each is open. Which of them have a part in the surface, a bit each.
BOZZETTO_KERNEL std::uint32_t settle(const Arrays& at, std::ptrdiff_t first, const float* full,
                                     const float* open) {
  float mean[kSide], excess[kSide];
  for (int n = 0; n < kSide; ++n) {
    const float* sum = &full[n + kBeside];
    mean[n] = (sum[-1] + 2 * sum[0] + sum[1]) / open[n];
    const float steep = 0.5f + kSharpen * (mean[n] - 0.5f);
    const float wanted = steep < 0 ? 0.0f : steep > 1 ? 1.0f : steep;
    excess[n] = fullness(at.value[first + n], at.cover[first + n]) - wanted;
  }
  std::uint32_t cells = 0;
  for (int n = 0; n < kSide; ++n) {
    at.mean[first + n] = mean[n];
    at.excess[first + n] = excess[n];
    cells |= static_cast<std::uint32_t>(mean[n] > 0 && mean[n] < 1) << n;
  }
  return cells;
}

// By (1 2 1)³ of open cells, so that against tools and held clay the surface stands upright.
BOZZETTO_KERNEL std::uint32_t measureKernel(const Arrays& at, std::ptrdiff_t first) {
  float full[kGroup] = {}, open[kGroup] = {}, whole[kSide];
  for (int number = 0; number < 9; ++number) {
    const auto [row, weight] = rowOfNine(at, first, number);
    const float *value = at.value + row, *cover = at.cover + row;
    const std::uint8_t* hold = at.hold + row;
    for (int n = 0; n < kGroup; ++n) {
      const float part = weight * static_cast<float>(isOpenCell(cover[n], hold[n]));
      full[n] += part * fullness(value[n], cover[n]);
      open[n] += part;
    }
  }
  for (int n = 0; n < kSide; ++n) {
    const float* sum = &open[n + kBeside];
    const float all = sum[-1] + 2 * sum[0] + sum[1];
    whole[n] = all < 1 ? 1.0f : all;
  }
  return settle(at, first, full, whole);
}

// The same where no tool and nothing held is near.
BOZZETTO_KERNEL std::uint32_t measureFreeKernel(const Arrays& at, std::ptrdiff_t first) {
  float full[kGroup] = {}, whole[kSide];
  for (int number = 0; number < 9; ++number) {
    const auto [row, weight] = rowOfNine(at, first, number);
    const float* value = at.value + row;
    for (int n = 0; n < kGroup; ++n) full[n] += weight * (value[n] < 1 ? value[n] : 1.0f);
  }
  for (float& each : whole) each = 64;
  return settle(at, first, full, whole);
}

bool isFree(const Arrays& at, std::ptrdiff_t first) {
  FourMasks covered{};
  std::uint64_t held = 0;
  for (int number = 0; number < 9; ++number) {
    const std::ptrdiff_t row = rowOfNine(at, first, number).first;
    for (int n = 0; n < kGroup; n += 4) covered |= bitsOf(fourAt(at.cover + row + n));
    for (int n = 0; n < kGroup; n += 8) {
      std::uint64_t holds;
      std::memcpy(&holds, at.hold + row + n, sizeof holds);
      held |= holds;
    }
  }
  return !any(covered) && held == 0;
}

BOZZETTO_SIMD_DISPATCH(std::uint32_t, measure, measureKernel,
                       (const Arrays& at, std::ptrdiff_t first), (at, first))
BOZZETTO_SIMD_DISPATCH(std::uint32_t, measureFree, measureFreeKernel,
                       (const Arrays& at, std::ptrdiff_t first), (at, first))
// Matter moves along the surface only: 1 on it, 0 in air and deep in clay.
float mobility(const Region& region, std::size_t cell) {
  const float mean = region.scratch2[cell];
  const std::uint8_t hold = region.hold[cell];
  return 4 * mean * (1 - mean) * (hold == 0 ? 1.0f : 1 - static_cast<float>(hold) / kFixed);
}

// Whole quanta; nothing for what is less than one.
float floored(float x) {
  constexpr float perQuantum = 1 / kQuantum;
  return static_cast<float>(static_cast<std::int32_t>(x * perQuantum)) * kQuantum;
}

Arrays arraysOf(Region& region) {
  return {region.value.data(),    region.cover.data(), region.hold.data(), region.scratch.data(),
          region.scratch2.data(), region.strides()[0], region.strides()[1]};
}

}  // namespace

// These and their neighbours, as far as matter can move there.
void Fairing::list(Region& region, const MovedCells& moved) {
  cells_.clear();
  const auto add = [&](std::size_t cell) {
    if (region.mark2[cell] == kListed || !isOpenCell(region.cover[cell], region.hold[cell])) return;
    region.mark2[cell] = kListed;
    cells_.push_back(static_cast<std::uint32_t>(cell));
  };
  for (const std::uint32_t cell : moved.cells()) {
    add(cell);
    for (const std::ptrdiff_t step : region.neighbours()) add(cell + step);
  }
  std::sort(cells_.begin(), cells_.end());
  groups_.clear();
  const Arrays arrays = arraysOf(region);
  for (const std::uint32_t cell : cells_) {
    const std::uint32_t first = cell & ~(Region::kTile - 1u);
    if (groups_.empty() || groups_.back().first != first)
      groups_.push_back({first, 0, 0, isFree(arrays, first)});
    groups_.back().cells |= 1u << (cell - first);
  }
}

// With the next cell along each axis. Nothing is given to the air, nor from within.
void Fairing::exchange(Region& region, std::size_t cell) {
  for (const std::ptrdiff_t step : region.strides()) {
    std::size_t from = cell, to = cell + step;
    if (region.mark2[to] != kListed) continue;
    if (region.scratch[from] < region.scratch[to]) std::swap(from, to);
    if (region.scratch2[from] > kInside || region.scratch2[to] < kOutside) continue;
    const float wanted = kRate * std::min(mobility(region, from), mobility(region, to)) *
                         (region.scratch[from] - region.scratch[to]);
    const float room = 1 - region.cover[to] - region.value[to];
    const float most = std::min(region.value[from], room) * (1.0f / 6);
    const float amount = floored(std::min(wanted, most));
    if (amount > 0) region.carry(from, to, amount);
  }
}

// Surface diffusion: what a cell has too much falls where the surface bulges and rises where it
// lacks, so that differences along it level curvature out and keep volume.
void Fairing::run(Work& work, MovedCells& moved, int passes) {
  Region& region = work.region;
  if (work.settings.scheme == Scheme::projected) list(region, moved);
  moved.clear();
  const Arrays arrays = arraysOf(region);
  for (int n = 0; n < passes; ++n) {
    parallelFor(groups_.size(), 512, [&](std::size_t begin, std::size_t end) {
      for (std::size_t g = begin; g < end; ++g) {
        Group& group = groups_[g];
        const auto measured = group.free ? measureFree : measure;
        group.surface = group.cells & measured(arrays, group.first);
      }
    });
    for (const Group& group : groups_)
      for (std::uint32_t cells = group.surface; cells != 0; cells &= cells - 1)
        exchange(region, group.first + std::countr_zero(cells));
  }
  for (const std::uint32_t cell : cells_) {
    region.mark2[cell] = 0;
    region.touch(cell);
  }
  cells_.clear();
  groups_.clear();
}

}  // namespace bozzetto::clay
