#include "clay/region.hpp"

#include <algorithm>

namespace bozzetto::clay {
namespace {

enum Flag : std::uint8_t { kHasClay = 1, kDense = 2, kListed = 4, kVisited = 8, kAtRim = 16 };

constexpr std::int32_t floorTile(std::int32_t corner) { return corner & ~(Region::kTile - 1); }

}  // namespace

KeyBox tileBox(const KeyBox& box, std::int32_t rim) {
  const std::int32_t margin = rim * Region::kTile, last = Region::kTile - 1;
  KeyBox result = box;
  for (const Axis axis : kAxes) {
    result.low[axis] = floorTile(box.low[axis]) - margin;
    result.high[axis] = floorTile(box.high[axis]) + last + margin;
  }
  return result;
}

Region::Region(const KeyBox& box) : box_(box) {
  const Key size = box.high - box.low + Key{1, 1, 1};
  tiles_ = {size.i / kTile, size.j / kTile, size.k / kTile};
  strides_ = {std::ptrdiff_t{size.j} * size.k, size.k, 1};
  for (std::size_t n = 0; n < 6; ++n)
    neighbours_[n] = n % 2 == 0 ? strides_[n / 2] : -strides_[n / 2];
  const auto count = static_cast<std::size_t>(box.count());
  for (Cells<float>* cells :
       {&value, &cover, &pressure, &pressureNext, &rhs, &inverse, &flux, &scratch, &scratch2})
    *cells = Cells<float>(count);
  for (auto& cells : wish) cells = Cells<float>(count);
  for (auto& cells : face) cells = Cells<float>(count);
  for (Cells<std::uint8_t>* cells : {&hold, &owner, &type, &mark, &mark2})
    *cells = Cells<std::uint8_t>(count);
  flags_.assign(static_cast<std::size_t>(tiles_.i) * tiles_.j * tiles_.k, 0);
  for (std::int32_t i = 0; i < tiles_.i; ++i)
    for (std::int32_t j = 0; j < tiles_.j; ++j)
      for (std::int32_t k = 0; k < tiles_.k; ++k)
        if (inRim(box.low + Key{i, j, k} * kTile)) {
          const std::size_t tile = tileIndex(i, j, k);
          flags_[tile] = kAtRim;
          forRowsOfTile(tile, [&](std::size_t base) {
            std::fill_n(&hold[base], kTile, kFixed);
            std::fill_n(&owner[base], kTile, static_cast<std::uint8_t>(kRim));
            std::fill_n(&type[base], kTile, static_cast<std::uint8_t>(CellType::closed));
          });
        }
}

KeyBox Region::inner() const {
  const Key tile{kTile, kTile, kTile};
  return {box_.low + tile, box_.high - tile};
}

bool Region::inRim(Key key) const { return !inner().contains(key); }

std::size_t Region::index(Key key) const {
  const Key local = key - box_.low;
  return static_cast<std::size_t>(local.i * strides_[0] + local.j * strides_[1] + local.k);
}

Key Region::key(std::size_t index) const {
  const auto n = static_cast<std::ptrdiff_t>(index);
  return box_.low + Key{static_cast<std::int32_t>(n / strides_[0]),
                        static_cast<std::int32_t>(n % strides_[0] / strides_[1]),
                        static_cast<std::int32_t>(n % strides_[1])};
}

std::size_t Region::tileIndex(std::int32_t i, std::int32_t j, std::int32_t k) const {
  return (static_cast<std::size_t>(i) * tiles_.j + j) * tiles_.k + k;
}

template <class Callback>
void Region::forRowsOfTile(std::size_t tile, const Callback& callback) const {
  const auto n = static_cast<std::int32_t>(tile);
  const Key first{n / (tiles_.j * tiles_.k) * kTile, n / tiles_.k % tiles_.j * kTile,
                  n % tiles_.k * kTile};
  for (std::int32_t i = 0; i < kTile; ++i)
    for (std::int32_t j = 0; j < kTile; ++j) callback(index(box_.low + first + Key{i, j, 0}));
}

void Region::lookAt(std::size_t tile) {
  std::int32_t clay = 0, dense = 0;
  forRowsOfTile(tile, [&](std::size_t base) {
    for (std::size_t k = base; k < base + kTile; ++k) {
      clay += value[k] > 0 ? 1 : 0;
      dense += value[k] >= 0.5f ? 1 : 0;
    }
  });
  flags_[tile] = static_cast<std::uint8_t>((flags_[tile] & ~(kHasClay | kDense)) |
                                           (clay > 0 ? kHasClay : 0) | (dense > 0 ? kDense : 0));
  countOf_[tile] = clay;
}

void Region::clear(std::size_t tile) {
  forRowsOfTile(tile, [&](std::size_t base) {
    for (Cells<float>* cells : {&pressure, &pressureNext, &flux, &inverse, &scratch, &scratch2})
      std::fill_n(&(*cells)[base], kTile, 0.0f);
    std::fill_n(&type[base], kTile, static_cast<std::uint8_t>(CellType::air));
  });
}

void Region::refreshRows(bool everywhere) {
  countOf_.resize(flags_.size());
  if (everywhere) {
    listed_.clear();
    for (std::size_t n = 0; n < flags_.size(); ++n)
      if ((flags_[n] & kAtRim) == 0) listed_.push_back(static_cast<std::uint32_t>(n));
  }
  parallelFor(listed_.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) lookAt(listed_[n]);
  });
  list();
}

// Marks tiles with clay and their neighbours, clears those that are left, lists rows.
void Region::list() {
  std::vector<std::uint32_t> before;
  before.swap(listed_);
  for (const std::uint32_t tile : before) flags_[tile] &= static_cast<std::uint8_t>(~kListed);
  reachesRim_ = false;
  clayCells_ = 0;
  const auto slab = static_cast<std::uint32_t>(tiles_.j * tiles_.k),
             column = static_cast<std::uint32_t>(tiles_.k);
  for (const std::uint32_t tile : before) {
    if ((flags_[tile] & kHasClay) == 0) continue;
    clayCells_ += countOf_[tile];
    const std::uint32_t first = tile - slab - column - 1;
    for (std::uint32_t n = 0; n < 27; ++n) {
      const std::uint32_t other = first + n / 9 * slab + n / 3 % 3 * column + n % 3;
      reachesRim_ = reachesRim_ || (flags_[other] & kAtRim) != 0;
      if ((flags_[other] & (kAtRim | kListed)) != 0) continue;
      flags_[other] |= kListed | kVisited;
      listed_.push_back(other);
    }
  }
  std::sort(listed_.begin(), listed_.end());
  for (const std::uint32_t tile : before)
    if ((flags_[tile] & (kListed | kVisited)) == kVisited) clear(tile);
  listRows(kListed, rows_);
  listRows(kDense, denseRows_);
}

void Region::listRows(std::uint8_t flag, std::vector<Row>& rows) const {
  rows.clear();
  for (std::size_t n = 0; n < listed_.size();) {
    const auto first = static_cast<std::int32_t>(listed_[n]);
    const auto wanted = [&](std::size_t at) {
      return at < listed_.size() && (flags_[listed_[at]] & flag) != 0 &&
             static_cast<std::int32_t>(listed_[at]) / tiles_.k == first / tiles_.k;
    };
    std::size_t end = n;
    while (wanted(end) && listed_[end] == listed_[n] + (end - n)) ++end;
    const auto length = static_cast<std::int32_t>(end - n) * kTile;
    const Key low{first / (tiles_.j * tiles_.k) * kTile, first / tiles_.k % tiles_.j * kTile,
                  first % tiles_.k * kTile};
    for (std::int32_t i = low.i; length > 0 && i < low.i + kTile; ++i)
      for (std::int32_t j = low.j; j < low.j + kTile; ++j)
        rows.push_back({index(box_.low + Key{i, j, low.k}), i, j, low.k, length});
    n = std::max(end, n + 1);
  }
}

std::vector<Key> Region::visitedTiles() const {
  std::vector<Key> keys;
  for (std::size_t tile = 0; tile < flags_.size(); ++tile) {
    if ((flags_[tile] & kVisited) == 0) continue;
    const auto n = static_cast<std::int32_t>(tile);
    keys.push_back(box_.low +
                   Key{n / (tiles_.j * tiles_.k), n / tiles_.k % tiles_.j, n % tiles_.k} * kTile);
  }
  return keys;
}

}  // namespace bozzetto::clay
