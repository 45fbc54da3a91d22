#include "clay/exchange.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "bozzetto/clay/stiffness.hpp"

namespace bozzetto::clay {
namespace {

constexpr Attributes kColourBits = 0xffffff;

template <int Side>
struct BlockRow {
  std::size_t cell;  // of the region
  const float* value;
  const Attributes* attributes;
};

// Calls back for every row of every block in the box, Side cells each.
template <int Side, class Callback>
void forBlockRows(const Region& region, const Edit<CornerBlock<Side>>& edit,
                  const Callback& callback) {
  using Geometry = BlockGeometry<Side>;
  const Key low = Geometry::blockOf(region.box().low), high = Geometry::blockOf(region.box().high);
  for (std::int32_t bi = low.i; bi <= high.i; ++bi)
    for (std::int32_t bj = low.j; bj <= high.j; ++bj)
      edit.visit(
          {{bi, bj, low.k}, high.k - low.k + 1}, [&](KeyRun piece, const CornerBlock<Side>* block) {
            if (block == nullptr) return;
            for (std::int32_t n = 0; n < piece.length; ++n) {
              const Key first = Geometry::firstCornerOf(piece.key + Key{0, 0, n});
              for (int row = 0; row < Side * Side; ++row)
                callback(BlockRow<Side>{region.index(first + Key{row / Side, row % Side, 0}),
                                        &block->value[row * Side], &block->attributes[row * Side]});
            }
          });
}

// What a cell of the tree becomes; returns whether it differs from what it was.
struct CellWriter {
  const Region& region;

  Attributes colourAt(std::size_t cell) const {
    if (!region.colourful) return region.onlyColour;
    const auto channel = [&](std::size_t n) {
      return static_cast<Attributes>(
          std::clamp(std::nearbyint(region.carried[n][cell]), 0.0f, 255.0f));
    };
    return channel(0) | channel(1) << 8 | channel(2) << 16;
  }

  bool operator()(std::size_t cell, float& value, Attributes& attributes) const {
    const float now = region.value[cell];
    const bool same = quantised(value) == now;
    if (same && now <= 0) return false;
    const Attributes wanted =
        now > 0 ? colourAt(cell) | Attributes{region.hold[cell]} << 24 : Attributes{0};
    if (same && wanted == attributes) return false;
    if (!same) value = now;
    attributes = wanted;
    return true;
  }
};

template <int Side>
bool storeBlock(const CellWriter& writer, Edit<CornerBlock<Side>>& edit, Key block) {
  const CornerBlock<Side>* old = edit.read(block);
  std::array<float, CornerBlock<Side>::kCount> value{};
  std::array<Attributes, CornerBlock<Side>::kCount> attributes{};
  if (old != nullptr) value = old->value, attributes = old->attributes;
  const Key first = BlockGeometry<Side>::firstCornerOf(block);
  bool changed = false;
  for (int row = 0; row < Side * Side; ++row) {
    const std::size_t cell = writer.region.index(first + Key{row / Side, row % Side, 0});
    for (int n = row * Side, k = 0; k < Side; ++n, ++k)
      changed = writer(cell + k, value[n], attributes[n]) || changed;
  }
  if (!changed) return false;
  CornerBlock<Side>& target = edit.write(block);
  target.value = value;
  target.attributes = attributes;
  target.updateRange();
  return true;
}

Cells<float> cellsFor(const Region& region) {
  return Cells<float>(static_cast<std::size_t>(region.box().count()));
}

// One cell of painted stiffness, from a region; returns whether it is another.
bool paintOffset(const Region& region, std::size_t cell, float& value, Attributes& attributes) {
  const float offset = std::nearbyint(region.carried.back()[cell]) - kNoOffset;
  const bool painted = region.value[cell] > 0 && offset != 0;
  const float size = painted ? std::min(std::abs(offset), kNoOffset) * (1 / kNoOffset) : 0;
  const Attributes white = painted && offset > 0 ? kColourBits : Attributes{0};
  if (value == size && attributes == white) return false;
  value = size;
  attributes = white;
  return true;
}

}  // namespace

template <int Side>
void loadStiffness(Region& region, const Edit<CornerBlock<Side>>& edit,
                   const Edit<CornerBlock<8>>& painted) {
  region.stiffened = true;
  region.carried.push_back(cellsFor(region));
  Cells<float>& offset = region.carried.back();
  forBlockRows<Side>(region, edit, [&](const BlockRow<Side>& row) {
    std::fill_n(&offset[row.cell], Side, kNoOffset);
  });
  forBlockRows<8>(region, painted, [&](const BlockRow<8>& row) {
    for (int k = 0; k < 8; ++k)
      offset[row.cell + k] =
          std::nearbyint(kNoOffset + kNoOffset * offsetOf(row.value[k], row.attributes[k]));
  });
}

void storeStiffness(const Region& region, std::span<const Key> tiles,
                    Edit<CornerBlock<8>>& painted) {
  for (const Key tile : tiles) {
    const Key block = BlockGeometry<8>::blockOf(tile);
    const CornerBlock<8>* old = painted.read(block);
    CornerBlock<8> made;
    if (old != nullptr) made.value = old->value, made.attributes = old->attributes;
    bool changed = false;
    for (int n = 0; n < CornerBlock<8>::kCount; ++n) {
      const std::size_t cell = region.index(tile + Key{n / 64, n / 8 % 8, n % 8});
      changed = paintOffset(region, cell, made.value[n], made.attributes[n]) || changed;
    }
    if (!changed) continue;
    CornerBlock<8>& target = painted.write(block);
    target.value = made.value;
    target.attributes = made.attributes;
    target.updateRange();
  }
}

template <int Side>
void load(Region& region, const Edit<CornerBlock<Side>>& edit) {
  std::optional<Attributes> first;
  forBlockRows<Side>(region, edit, [&](const BlockRow<Side>& row) {
    region.touch(row.cell);
    const bool inRim = region.inRim(region.key(row.cell));
    for (int k = 0; k < Side; ++k) {
      const std::size_t cell = row.cell + k;
      region.clayInRim = region.clayInRim || (inRim && row.value[k] > kThin);
      region.value[cell] = quantised(row.value[k]);
      region.hold[cell] = std::max(region.hold[cell], holdOf(row.attributes[k]));
      if (row.value[k] <= 0) continue;
      if (!first) first = row.attributes[k] & kColourBits;
      region.colourful = region.colourful || (row.attributes[k] & kColourBits) != *first;
    }
  });
  region.onlyColour = first.value_or(0);
  if (!region.colourful) return;
  for (int n = 0; n < 3; ++n) region.carried.push_back(cellsFor(region));
  forBlockRows<Side>(region, edit, [&](const BlockRow<Side>& row) {
    for (int k = 0; k < Side; ++k)
      for (std::size_t n = 0; n < 3; ++n)
        region.carried[n][row.cell + k] = static_cast<float>(row.attributes[k] >> 8 * n & 0xff);
  });
}

template <int Side>
std::vector<KeyRun> store(const Region& region, std::span<const Key> tiles,
                          Edit<CornerBlock<Side>>& edit) {
  using Geometry = BlockGeometry<Side>;
  std::vector<KeyRun> changed;
  const CellWriter writer{region};
  for (const Key tile : tiles) {
    const Key low = Geometry::blockOf(tile), high = Geometry::blockOf(tile + Key{7, 7, 7});
    for (std::int32_t i = low.i; i <= high.i; ++i)
      for (std::int32_t j = low.j; j <= high.j; ++j)
        for (std::int32_t k = low.k; k <= high.k; ++k)
          if (storeBlock<Side>(writer, edit, {i, j, k})) changed.push_back({{i, j, k}, 1});
  }
  std::sort(changed.begin(), changed.end(),
            [](const KeyRun& a, const KeyRun& b) { return a.key < b.key; });
  return changed;
}

template void loadStiffness<1>(Region&, const Edit<CornerBlock<1>>&, const Edit<CornerBlock<8>>&);
template void loadStiffness<8>(Region&, const Edit<CornerBlock<8>>&, const Edit<CornerBlock<8>>&);
template void load<1>(Region&, const Edit<CornerBlock<1>>&);
template void load<8>(Region&, const Edit<CornerBlock<8>>&);
template std::vector<KeyRun> store<1>(const Region&, std::span<const Key>, Edit<CornerBlock<1>>&);
template std::vector<KeyRun> store<8>(const Region&, std::span<const Key>, Edit<CornerBlock<8>>&);

}  // namespace bozzetto::clay
