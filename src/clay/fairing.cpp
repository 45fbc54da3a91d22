#include "clay/fairing.hpp"

#include <algorithm>
#include <cmath>

#include "bozzetto/base/simd.hpp"

namespace bozzetto::clay {
namespace {

constexpr float kRate = 0.15f;  // less than 1/6, where shares of six neighbours begin to swing
// A plane of clay over two cells, blurred, has slopes of 3/4: sharpened so, it is what it was.
constexpr float kSharpen = 4.0f / 3;
constexpr float kOutside = 0.125f;  // blurred densities that sharpen to 0, and to 1
constexpr float kInside = 0.875f;
constexpr std::uint8_t kListed = 1;

bool isOpen(const Region& region, std::size_t cell) {
  return region.hold[cell] != kFixed && region.cover[cell] <= 0.5f;
}

// Eight cells in a row and four more on either side: vectors of a size.
constexpr int kBeside = 4, kGroup = Region::kTile + 2 * kBeside;

struct Arrays {
  const float *value, *cover;
  const std::uint8_t* hold;
  float *excess, *mean;
  std::ptrdiff_t slab, row;
};

// How full a cell is of what it has room for; full where there is none.
BOZZETTO_KERNEL float fullness(float value, float cover) {
  const float full = value / (1 - cover);
  return full < 1 ? full : 1.0f;
}

// Open cells only: their sum, and `kGroup` further on how many there are, weighted both.
BOZZETTO_KERNEL void addRowKernel(const float* value, const float* cover, const std::uint8_t* hold,
                                  float weight, float* __restrict sums) {
  for (int n = 0; n < kGroup; ++n) {
    const float full = fullness(value[n], cover[n]);
    const int isOpen = (hold[n] < kFixed) & (cover[n] <= 0.5f);
    const float part = weight * static_cast<float>(isOpen);
    sums[n] += part * full;
    sums[kGroup + n] += part;
  }
}

BOZZETTO_SIMD_DISPATCH(void, addRow, addRowKernel,
                       (const float* value, const float* cover, const std::uint8_t* hold,
                        float weight, float* __restrict sums),
                       (value, cover, hold, weight, sums))

// What eight cells have too much for a smooth surface, and their blurred density: by (1 2 1)³ of
// open cells, so that against tools and held clay the surface stands upright.
void measure(const Arrays& at, std::ptrdiff_t first) {
  float sums[2 * kGroup] = {};
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j) {
      const std::ptrdiff_t row = first + i * at.slab + j * at.row - kBeside;
      const auto weight = static_cast<float>((2 - i * i) * (2 - j * j));
      addRow(at.value + row, at.cover + row, at.hold + row, weight, sums);
    }
  for (std::ptrdiff_t n = 0; n < Region::kTile; ++n) {
    const float *full = &sums[n + kBeside], *open = full + kGroup;
    const float whole = open[-1] + 2 * open[0] + open[1];
    const float mean = (full[-1] + 2 * full[0] + full[1]) / std::max(whole, 1.0f);
    const float wanted = std::clamp(0.5f + kSharpen * (mean - 0.5f), 0.0f, 1.0f);
    at.excess[first + n] = fullness(at.value[first + n], at.cover[first + n]) - wanted;
    at.mean[first + n] = mean;
  }
}

// Matter moves along the surface only: 1 on it, 0 in air and deep in clay.
float mobility(const Region& region, std::size_t cell) {
  const float mean = region.scratch2[cell];
  return 4 * mean * (1 - mean) * (1 - static_cast<float>(region.hold[cell]) / kFixed);
}

}  // namespace

// These and their neighbours, as far as matter can move there.
void Fairing::list(Region& region, const MovedCells& moved) {
  cells_.clear();
  const auto add = [&](std::size_t cell) {
    if (region.mark2[cell] == kListed || !isOpen(region, cell)) return;
    region.mark2[cell] = kListed;
    cells_.push_back(static_cast<std::uint32_t>(cell));
  };
  for (const std::uint32_t cell : moved) {
    add(cell);
    for (const std::ptrdiff_t step : region.neighbours()) add(cell + step);
  }
  std::sort(cells_.begin(), cells_.end());
  groups_.clear();
  for (const std::uint32_t cell : cells_) {
    const std::uint32_t first = cell & ~(Region::kTile - 1u);
    if (groups_.empty() || groups_.back() != first) groups_.push_back(first);
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
    const float amount = std::floor(std::min(wanted, most) / kQuantum) * kQuantum;
    if (amount > 0) region.carry(from, to, amount);
  }
}

// Surface diffusion: what a cell has too much falls where the surface bulges and rises where it
// lacks, so that differences along it level curvature out and keep volume.
void Fairing::run(Work& work, MovedCells& moved, int passes) {
  Region& region = work.region;
  if (work.settings.scheme == Scheme::projected) list(region, moved);
  moved.clear();
  const Arrays arrays{region.value.data(),   region.cover.data(),    region.hold.data(),
                      region.scratch.data(), region.scratch2.data(), region.strides()[0],
                      region.strides()[1]};
  for (int n = 0; n < passes; ++n) {
    parallelFor(groups_.size(), 512, [&](std::size_t begin, std::size_t end) {
      for (std::size_t g = begin; g < end; ++g) measure(arrays, groups_[g]);
    });
    for (const std::uint32_t cell : cells_) exchange(region, cell);
  }
  for (const std::uint32_t cell : cells_) {
    region.mark2[cell] = 0;
    region.touch(cell);
  }
  cells_.clear();
  groups_.clear();
}

}  // namespace bozzetto::clay
