#include "clay/exchange.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "bozzetto/clay/stiffness.hpp"
#include "clay/fours.hpp"

namespace bozzetto::clay {
namespace {

constexpr Attributes kColourBits = 0xffffff;

// Calls back for every block in the box: callback(first corner, block).
template <int Side, class Callback>
void forBlocks(const Region& region, const Edit<CornerBlock<Side>>& edit,
               const Callback& callback) {
  using Geometry = BlockGeometry<Side>;
  const Key low = Geometry::blockOf(region.box().low), high = Geometry::blockOf(region.box().high);
  for (std::int32_t bi = low.i; bi <= high.i; ++bi)
    for (std::int32_t bj = low.j; bj <= high.j; ++bj)
      edit.visit({{bi, bj, low.k}, high.k - low.k + 1},
                 [&](KeyRun piece, const CornerBlock<Side>* block) {
                   if (block == nullptr) return;
                   for (std::int32_t n = 0; n < piece.length; ++n)
                     callback(Geometry::firstCornerOf(piece.key + Key{0, 0, n}), *block);
                 });
}

template <int Side>
struct BlockRow {
  std::size_t cell;  // of the region
  const float* value;
  const Attributes* attributes;
};

template <int Side, class Callback>
void forBlockRows(const Region& region, Key first, const CornerBlock<Side>& block,
                  const Callback& callback) {
  const std::size_t cell = region.index(first);
  for (int row = 0; row < Side * Side; ++row)
    callback(
        BlockRow<Side>{cell + row / Side * region.strides()[0] + row % Side * region.strides()[1],
                       &block.value[row * Side], &block.attributes[row * Side]});
}

// Calls back for every row of every block in the box, Side cells each.
template <int Side, class Callback>
void forBlockRows(const Region& region, const Edit<CornerBlock<Side>>& edit,
                  const Callback& callback) {
  forBlocks<Side>(region, edit, [&](Key first, const CornerBlock<Side>& block) {
    forBlockRows<Side>(region, first, block, callback);
  });
}

// What a block brings: its greatest value, all bits of its attributes, and in what its clay's
// colours differ from `colour`.
struct Loaded {
  Attributes colour = 0;
  float most = 0;
  Attributes all = 0, others = 0;
};

// Where the block is in the region.
struct Target {
  float* first;
  std::ptrdiff_t slab, row;
};

void loadBlock(const CornerBlock<8>& block, const Target& to, Loaded& found) {
  const Four twelve = allFour(12);
  const auto c = static_cast<std::int32_t>(found.colour), bits = std::int32_t{kColourBits};
  const FourMasks colour{c, c, c, c}, colourBits{bits, bits, bits, bits};
  Four most{};
  FourMasks all{}, others{};
  for (int n = 0; n < 512; n += 4) {
    const Four value = fourAt(&block.value[n]);
    const FourMasks attributes = fourAt(&block.attributes[n]);
    put((value + twelve) - twelve, to.first + n / 64 * to.slab + n / 8 % 8 * to.row + n % 8);
    most = greater(most, value);
    all |= attributes;
    others |= (value > Four{}) & (attributes ^ colour) & colourBits;
  }
  for (int n = 0; n < 4; ++n) {
    found.most = std::max(found.most, most[n]);
    found.all |= static_cast<Attributes>(all[n]);
    found.others |= static_cast<Attributes>(others[n]);
  }
}

void loadBlock(const CornerBlock<1>& block, const Target& to, Loaded& found) {
  *to.first = quantised(block.value[0]);
  found.most = block.value[0];
  found.all = block.attributes[0];
  if (block.value[0] > 0) found.others = (block.attributes[0] ^ found.colour) & kColourBits;
}

template <int Side>
std::optional<Attributes> colourIn(const CornerBlock<Side>& block) {
  for (int n = 0; n < CornerBlock<Side>::kCount; ++n)
    if (block.value[n] > 0) return block.attributes[n] & kColourBits;
  return {};
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

// The rows of a block of which a value or attributes are not what is there, a bit each; where all
// clay has one colour.
std::uint64_t otherRows(const CornerBlock<8>& block, const Region& region, std::size_t first) {
  const auto [slab, step, next] = region.strides();
  const Four twelve = allFour(12);
  const auto colour = static_cast<std::int32_t>(region.onlyColour);
  std::uint64_t rows = 0;
  for (int n = 0; n < 512; n += 4) {
    const std::size_t cell = first + n / 64 * slab + n / 8 % 8 * step + n % 8;
    const Four value = fourAt(&block.value[n]), now = fourAt(&region.value[cell]);
    const std::uint8_t* hold = &region.hold[cell];
    const FourMasks holds{hold[0], hold[1], hold[2], hold[3]};
    const FourMasks wanted = holds << 24 | FourMasks{colour, colour, colour, colour};
    const FourMasks same = (value + twelve) - twelve == now;
    const FourMasks isDressed = (now > Four{}) & (wanted != fourAt(&block.attributes[n]));
    rows |= std::uint64_t{any(~same | isDressed)} << n / 8;
  }
  return rows;
}

std::uint64_t otherRows(const CornerBlock<1>& block, const Region& region, std::size_t first) {
  const float now = region.value[first];
  const Attributes wanted = region.onlyColour | Attributes{region.hold[first]} << 24;
  return quantised(block.value[0]) != now || (now > 0 && wanted != block.attributes[0]) ? 1 : 0;
}

// The same, whatever the colours.
template <int Side>
std::uint64_t otherRowsOf(const CellWriter& writer, const CornerBlock<Side>& block, Key first) {
  if (!writer.region.colourful) return otherRows(block, writer.region, writer.region.index(first));
  std::uint64_t rows = 0;
  int number = 0;
  forBlockRows<Side>(writer.region, first, block, [&](const BlockRow<Side>& row) {
    bool isOther = false;
    for (int k = 0; k < Side; ++k) {
      float value = row.value[k];
      Attributes attributes = row.attributes[k];
      isOther = isOther || writer(row.cell + k, value, attributes);
    }
    rows |= std::uint64_t{isOther} << number++;
  });
  return rows;
}

template <int Side>
bool storeBlock(const CellWriter& writer, Edit<CornerBlock<Side>>& edit, Key block) {
  static const CornerBlock<Side> empty;
  const CornerBlock<Side>* old = edit.read(block);
  const Key first = BlockGeometry<Side>::firstCornerOf(block);
  const std::uint64_t rows = otherRowsOf<Side>(writer, old != nullptr ? *old : empty, first);
  if (rows == 0) return false;
  CornerBlock<Side>& target = edit.write(block);
  for (int row = 0; row < Side * Side; ++row) {
    if ((rows >> row & 1) == 0) continue;
    const std::size_t cell = writer.region.index(first + Key{row / Side, row % Side, 0});
    for (int n = row * Side, k = 0; k < Side; ++n, ++k)
      writer(cell + k, target.value[n], target.attributes[n]);
  }
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
  std::optional<Attributes> colour;
  forBlocks<Side>(region, edit, [&](Key first, const CornerBlock<Side>& block) {
    region.touch(region.index(first));
    if (!colour) colour = colourIn(block);
    Loaded found{colour.value_or(0)};
    const Target target{&region.value[region.index(first)], region.strides()[0],
                        region.strides()[1]};
    loadBlock(block, target, found);
    const bool inRim = region.inRim(first);
    region.clayInRim = region.clayInRim || (inRim && found.most > kThin);
    region.colourful = region.colourful || found.others != 0;
    if (inRim || found.all >> 24 == 0) return;
    forBlockRows<Side>(region, first, block, [&](const BlockRow<Side>& row) {
      for (int k = 0; k < Side; ++k) region.hold[row.cell + k] = holdOf(row.attributes[k]);
    });
  });
  region.onlyColour = colour.value_or(0);
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
