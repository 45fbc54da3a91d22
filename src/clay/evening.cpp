#include "clay/evening.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace bozzetto::clay {
namespace {

constexpr float kFull = 0.995f;  // less lacks

// Those that hold more than the mean give to those that hold less.
void evenOut(Region& region, std::span<const std::size_t> cells) {
  float sum = 0;
  for (const std::size_t cell : cells) sum += region.value[cell];
  const float mean = quantised(sum / static_cast<float>(cells.size()));
  for (const std::size_t giver : cells)
    for (const std::size_t taker : cells) {
      const float amount = std::min(region.value[giver] - mean, mean - region.value[taker]);
      if (amount > 0) region.carry(giver, taker, amount);
    }
}

}  // namespace

bool isInside(const Region& region, std::size_t cell) {
  const bool fixed = region.hold[cell] == kFixed || region.owner[cell] >= kMoving;
  if (region.value[cell] < 0.5f || fixed || region.cover[cell] > 0) return false;
  for (const std::ptrdiff_t step : region.neighbours())
    if (region.value[cell + step] < 0.5f) return false;
  return true;
}

void Evening::listLacking(const Region& region) {
  tiles_.clear();
  for (const Row& row : region.denseRows())
    for (std::int32_t k = 0; k < row.count; ++k) {
      const std::size_t cell = row.base + k;
      if (region.value[cell] >= kFull || !isInside(region, cell)) continue;
      const Key low = Key{row.i & ~7, row.j & ~7, (row.k + k) & ~7} + region.box().low;
      for (int d = 0; d < 27; ++d) {
        const Key tile = low + Key{d / 9 - 1, d / 3 % 3 - 1, d % 3 - 1} * Region::kTile;
        if (!region.inRim(tile)) tiles_.push_back(tile);
      }
      k |= 7;  // the tile is known
    }
  std::sort(tiles_.begin(), tiles_.end());
  tiles_.erase(std::unique(tiles_.begin(), tiles_.end()), tiles_.end());
}

void Evening::markInside(Region& region) {
  for (const Key tile : tiles_)
    for (int n = 0; n < 64; ++n) {
      const std::size_t row = region.index(tile + Key{n / 8, n % 8, 0});
      for (std::size_t cell = row; cell < row + 8; ++cell)
        region.mark[cell] = isInside(region, cell) ? 1 : 0;
    }
}

void Evening::forget(Region& region) {
  for (const Key tile : tiles_) {
    region.touch(region.index(tile));
    for (int n = 0; n < 64; ++n)
      std::fill_n(&region.mark[region.index(tile + Key{n / 8, n % 8, 0})], 8, std::uint8_t{0});
  }
}

// Of each block the cells inside; those beyond the tiles have no mark.
void Evening::sweep(Region& region, int parity) {
  const auto& step = region.strides();
  parallelFor(tiles_.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
      for (int n = 0; n < 64; ++n) {
        const Key low =
            tiles_[t] + Key{n / 16 * 2 + parity, n / 4 % 4 * 2 + parity, n % 4 * 2 + parity};
        const std::size_t first = region.index(low);
        std::array<std::size_t, 8> cells;
        std::size_t count = 0;
        for (std::size_t c = 0; c < 8; ++c) {
          const std::size_t cell = first + (c >> 2) * step[0] + (c >> 1 & 1) * step[1] + (c & 1);
          if (region.mark[cell] != 0) cells[count++] = cell;
        }
        if (count > 1) evenOut(region, {cells.data(), count});
      }
  });
}

void Evening::run(Region& region, int sweeps) {
  region.refreshRows();
  listLacking(region);
  markInside(region);
  for (int n = 0; n < sweeps; ++n) sweep(region, n % 2);
  forget(region);
}

}  // namespace bozzetto::clay
