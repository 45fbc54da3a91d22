#include "clay/exchange.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

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
    if (!region.colour[0]) return region.onlyColour;
    const auto channel = [&](std::size_t n) {
      return static_cast<Attributes>(
          std::clamp(std::nearbyint(region.colour[n][cell]), 0.0f, 255.0f));
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

}  // namespace

template <int Side>
void load(Region& region, const Edit<CornerBlock<Side>>& edit) {
  std::optional<Attributes> first;
  bool colourful = false;
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
      colourful = colourful || (row.attributes[k] & kColourBits) != *first;
    }
  });
  region.onlyColour = first.value_or(0);
  if (!colourful) return;
  const auto count = static_cast<std::size_t>(region.box().count());
  for (auto& channel : region.colour) channel = Cells<float>(count);
  forBlockRows<Side>(region, edit, [&](const BlockRow<Side>& row) {
    for (int k = 0; k < Side; ++k)
      for (std::size_t n = 0; n < 3; ++n)
        region.colour[n][row.cell + k] = static_cast<float>(row.attributes[k] >> 8 * n & 0xff);
  });
}

template <int Side>
std::vector<KeyRun> store(Region& region, Edit<CornerBlock<Side>>& edit) {
  using Geometry = BlockGeometry<Side>;
  std::vector<KeyRun> changed;
  const CellWriter writer{region};
  for (const Key tile : region.takeChanged()) {
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

template void load<1>(Region&, const Edit<CornerBlock<1>>&);
template void load<8>(Region&, const Edit<CornerBlock<8>>&);
template std::vector<KeyRun> store<1>(Region&, Edit<CornerBlock<1>>&);
template std::vector<KeyRun> store<8>(Region&, Edit<CornerBlock<8>>&);

}  // namespace bozzetto::clay
