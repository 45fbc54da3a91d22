#include "clay/region.hpp"

#include <algorithm>
#include <atomic>
#include <cstring>

#include "bozzetto/grid/key_box.hpp"
#include "clay/fours.hpp"

namespace bozzetto::clay {
namespace {

// What tiles have: any clay, a cell of half or more, only such cells; what is done with them; a
// tool in them; and deep: 27 of them have only such cells and no tool.
enum Flag : std::uint16_t {
  kHasClay = 1,
  kDense = 2,
  kListed = 4,
  kAtRim = 8,
  kSolid = 16,
  kTouched = 32,
  kChanged = 64,
  kTooled = 128,
  kDeep = 256,
};

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
  countOf_.assign(flags_.size(), 0);
  closeRim();
}

// Nothing moves there, and it is nobody's.
void Region::closeRim() {
  const auto close = [&](std::size_t first, std::ptrdiff_t count) {
    std::memset(&hold[first], kFixed, count);
    std::memset(&owner[first], kRim, count);
    std::memset(&type[first], static_cast<int>(CellType::closed), count);
  };
  // Both ends of a run of `size` that starts at `first`, each so many thick.
  const auto closeEnds = [&](std::size_t first, std::ptrdiff_t size, std::ptrdiff_t thick) {
    close(first, thick);
    close(first + size - thick, thick);
  };
  const std::ptrdiff_t slab = strides_[0], row = strides_[1];
  closeEnds(0, box_.count(), kTile * slab);
  for (std::ptrdiff_t i = kTile; i < (tiles_.i - 1) * kTile; ++i) {
    closeEnds(i * slab, slab, kTile * row);
    for (std::ptrdiff_t j = kTile; j < (tiles_.j - 1) * kTile; ++j)
      closeEnds(i * slab + j * row, row, kTile);
  }
  for (std::uint32_t tile = 0; tile < flags_.size(); ++tile)
    if (inRim(firstOf(tile))) flags_[tile] = kAtRim;
}

KeyBox Region::inner() const {
  const Key tile{kTile, kTile, kTile};
  return {box_.low + tile, box_.high - tile};
}

bool Region::inRim(Key key) const { return !inner().contains(key); }

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

std::uint32_t Region::tileOf(std::size_t cell) const {
  const Key local = key(cell) - box_.low;
  return static_cast<std::uint32_t>(tileIndex(local.i / kTile, local.j / kTile, local.k / kTile));
}

// The tile itself is the 14th.
std::array<std::uint32_t, 27> Region::around(std::uint32_t tile) const {
  const auto slab = static_cast<std::uint32_t>(tiles_.j * tiles_.k),
             column = static_cast<std::uint32_t>(tiles_.k);
  std::array<std::uint32_t, 27> tiles;
  for (std::uint32_t n = 0; n < 27; ++n)
    tiles[n] = tile - slab - column - 1 + n / 9 * slab + n / 3 % 3 * column + n % 3;
  return tiles;
}

void Region::touch(std::size_t cell) {
  const std::uint32_t tile = tileOf(cell);
  if ((flags_[tile] & (kTouched | kAtRim)) != 0) return;
  flags_[tile] |= kTouched;
  touched_.push_back(tile);
}

bool Region::inBand(std::size_t cell) const {
  return (flags_[tileOf(cell)] & (kListed | kDeep)) == kListed;
}

void Region::enterBand(std::size_t cell) {
  const std::uint32_t tile = tileOf(cell);
  if ((flags_[tile] & kTooled) != 0) return;
  flags_[tile] |= kTooled;
  tooled_.push_back(tile);
}

namespace {

struct Least {
  int clay = 0, dense = 0;
  float least = 1;
};

// Of the cells of a tile, from its first.
Least look(const float* first, std::ptrdiff_t slab, std::ptrdiff_t row) {
  FourMasks clay{}, dense{};
  Four lowest = allFour(1);
  for (int n = 0; n < Region::kTile * Region::kTile; ++n)
    for (const int half : {0, Region::kTile / 2}) {
      const Four value = fourAt(first + n / Region::kTile * slab + n % Region::kTile * row + half);
      clay += value > allFour(0);
      dense += value >= allFour(0.5f);
      lowest = lesser(lowest, value);
    }
  return {count(clay), count(dense), least(lowest)};
}

}  // namespace

bool Region::lookAt(std::uint32_t tile) {
  const Least all = look(&value[index(firstOf(tile))], strides_[0], strides_[1]);
  const int found = (all.clay > 0 ? kHasClay : 0) | (all.dense > 0 ? kDense : 0) |
                    (all.least >= 0.5f ? kSolid : 0);
  constexpr int looked = kHasClay | kDense | kSolid | kTouched;
  const bool same = (flags_[tile] & (looked & ~kTouched)) == found;
  flags_[tile] = static_cast<std::uint16_t>((flags_[tile] & ~looked) | found);
  countOf_[tile] = all.clay;
  return !same;
}

void Region::clear(std::size_t tile) {
  forRowsOfTile(tile, [&](std::size_t base) {
    for (Cells<float>* cells : {&pressure, &pressureNext, &flux, &inverse, &scratch, &scratch2})
      std::fill_n(&(*cells)[base], kTile, 0.0f);
    std::fill_n(&type[base], kTile, static_cast<std::uint8_t>(CellType::air));
  });
}

void Region::refreshRows() {
  if (touchedRows_)
    for (const std::uint32_t tile : listed_)
      if ((flags_[tile] & kTouched) == 0) touched_.push_back(tile);
  touchedRows_ = false;
  if (touched_.empty()) return;
  std::atomic<bool> other = false;
  parallelFor(touched_.size(), 64, [&](std::size_t begin, std::size_t end) {
    bool some = false;
    for (std::size_t n = begin; n < end; ++n) some = lookAt(touched_[n]) || some;
    if (some) other = true;
  });
  for (const std::uint32_t tile : touched_) {
    if ((flags_[tile] & kListed) == 0) {
      listed_.push_back(tile);
      other = true;
    }
    if ((flags_[tile] & kChanged) == 0) changed_.push_back(tile);
    flags_[tile] |= kChanged;
  }
  touched_.clear();
  if (other) {
    list();
    return;
  }
  clayCells_ = 0;
  for (const std::uint32_t tile : listed_) clayCells_ += countOf_[tile];
}

// Marks tiles with clay and their neighbours, clears those that are left, lists rows.
void Region::list() {
  before_.swap(listed_);
  listed_.clear();
  for (const std::uint32_t tile : before_) flags_[tile] &= static_cast<std::uint16_t>(~kListed);
  reachesRim_ = false;
  clayCells_ = 0;
  clayBox_ = {};
  for (const std::uint32_t tile : before_) {
    if ((flags_[tile] & kHasClay) == 0) continue;
    clayCells_ += countOf_[tile];
    const Key first = firstOf(tile);
    clayBox_ = united(clayBox_, {first, first + Key{kTile - 1, kTile - 1, kTile - 1}});
    for (const std::uint32_t other : around(tile)) {
      reachesRim_ = reachesRim_ || (flags_[other] & kAtRim) != 0;
      if ((flags_[other] & (kAtRim | kListed)) != 0) continue;
      flags_[other] |= kListed;
      listed_.push_back(other);
    }
  }
  std::sort(listed_.begin(), listed_.end());
  for (const std::uint32_t tile : before_)
    if ((flags_[tile] & kListed) == 0) clear(tile);
  listRows({kListed, kListed}, rows_);
  listTiles({kListed | kDense, kListed | kDense}, denseTiles_);
  listRows(denseTiles_, denseRows_);
}

void Region::classify(std::uint32_t tile) {
  bool deep = true;
  for (const std::uint32_t other : around(tile)) {
    const bool solid = (flags_[other] & (kAtRim | kSolid)) != 0;
    deep = deep && solid && (flags_[other] & kTooled) == 0;
  }
  flags_[tile] = static_cast<std::uint16_t>((flags_[tile] & ~kDeep) | (deep ? kDeep : 0));
}

void Region::listBand() {
  parallelFor(listed_.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) classify(listed_[n]);
  });
  listRows({kListed | kDeep, kListed}, bandRows_);
  listRows({kListed | kDeep, kListed | kDeep}, deepRows_);
  for (const std::uint32_t tile : tooled_) flags_[tile] &= static_cast<std::uint16_t>(~kTooled);
  tooled_.clear();
}

Key Region::firstOf(std::uint32_t tile) const {
  const auto n = static_cast<std::int32_t>(tile);
  return box_.low + Key{n / (tiles_.j * tiles_.k), n / tiles_.k % tiles_.j, n % tiles_.k} * kTile;
}

void Region::listTiles(Selection which, std::vector<TileRun>& runs) const {
  runs.clear();
  for (const std::uint32_t tile : listed_) {
    if ((flags_[tile] & which.mask) != which.wanted) continue;
    const auto t = static_cast<std::int32_t>(tile);
    const TileRun own{t / (tiles_.j * tiles_.k), t / tiles_.k % tiles_.j, t % tiles_.k, 1};
    const bool next = !runs.empty() && runs.back().i == own.i && runs.back().j == own.j &&
                      runs.back().k + runs.back().count == own.k;
    if (next)
      ++runs.back().count;
    else
      runs.push_back(own);
  }
}

void Region::listRows(const std::vector<TileRun>& runs, std::vector<Row>& rows) const {
  rows.clear();
  for (const TileRun& run : runs) {
    const Key low = Key{run.i, run.j, run.k} * kTile;
    for (std::int32_t i = low.i; i < low.i + kTile; ++i)
      for (std::int32_t j = low.j; j < low.j + kTile; ++j)
        rows.push_back({index(box_.low + Key{i, j, low.k}), i, j, low.k, run.count * kTile});
  }
}

void Region::listRows(Selection which, std::vector<Row>& rows) {
  listTiles(which, runs_);
  listRows(runs_, rows);
}

std::vector<Key> Region::takeChanged() {
  std::sort(changed_.begin(), changed_.end());
  std::vector<Key> keys;
  for (const std::uint32_t tile : changed_) {
    flags_[tile] &= static_cast<std::uint16_t>(~kChanged);
    keys.push_back(firstOf(tile));
  }
  changed_.clear();
  return keys;
}

}  // namespace bozzetto::clay
