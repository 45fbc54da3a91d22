#include "tool/tool_tile.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#include "tool/block_work.hpp"
#include "tool/float_bits.hpp"

namespace bozzetto {
namespace {

using Geometry = BlockGeometry<8>;
constexpr std::int64_t kMostEntries = 1 << 22;

KeyBox boxOf(const Clay& clay) {
  constexpr auto most = std::numeric_limits<std::int32_t>::max();
  KeyBox box{{most, most, most}, {-most, -most, -most}};
  for (const auto& [key, run] : clay.tree) {
    for (const Axis axis : kAxes) {
      box.low[axis] = std::min(box.low[axis], key[axis]);
      box.high[axis] = std::max(box.high[axis], key[axis]);
    }
    box.high.k = std::max(box.high.k, key.k + run.length - 1);
  }
  return box;
}

// Calls part(block, its key) for every block that holds one of the corners low … high.
template <class Part>
void forBlocks(const BlockTable& blocks, Key low, Key high, Part&& part) {
  const Key first = Geometry::blockOf(low), last = Geometry::blockOf(high);
  for (auto i = first.i; i <= last.i; ++i)
    for (auto j = first.j; j <= last.j; ++j)
      for (auto k = first.k; k <= last.k; ++k) part(blocks.at({i, j, k}), Key{i, j, k});
}

Key topOf(const ToolTile& tile) {
  return tile.low + Key{tile.wide[0] - 1, tile.wide[1] - 1, tile.wide[2] - 1};
}

// Calls part(block, from, until) for every block the tile reads, with its corners of the tile.
// Rows along k are whole rows of blocks.
template <class Part>
void forParts(const BlockTable& blocks, const ToolTile& tile, Part&& part) {
  const Key top = topOf(tile);
  forBlocks(blocks, tile.low, top, [&](const CornerBlock<8>* block, Key key) {
    const Key at = Geometry::firstCornerOf(key);
    part(block, Key{std::max(tile.low.i, at.i), std::max(tile.low.j, at.j), at.k},
         Key{std::min(top.i, at.i + 7), std::min(top.j, at.j + 7), at.k + 7});
  });
}

// Calls row(place in the block, place in the tile) for the rows of 8 from … until.
template <class Row>
BOZZETTO_KERNEL void forRowsOf(const ToolTile& tile, Key from, Key until, Row&& row) {
  const Key at = from - tile.low;
  const int wideK = tile.wide[2], rows = until.j - from.j + 1;
  for (auto i = from.i; i <= until.i; ++i) {
    int in = Geometry::indexOf({i, from.j, 0});
    int out = ((at.i + i - from.i) * tile.wide[1] + at.j) * wideK + at.k;
    for (int n = 0; n < rows; ++n, in += 8, out += wideK) row(in, out);
  }
}

// Which of the eight halves³ of a block hold clay: bit 4·(i ≥ 4) + 2·(j ≥ 4) + (k ≥ 4).
std::uint8_t octantsOf(const CornerBlock<8>& block) {
  if (block.interned || block.low > 0) return 0xff;
  unsigned octants = 0;
  for (unsigned row = 0; row < 64; ++row) {
    const float* value = block.value.data() + 8 * row;
    const unsigned near = (value[0] + value[1]) + (value[2] + value[3]) > 0;
    const unsigned far = (value[4] + value[5]) + (value[6] + value[7]) > 0;
    octants |= (near | far << 1) << (row >> 5 << 2 | (row >> 2 & 1) << 1);
  }
  return static_cast<std::uint8_t>(octants);
}

// The octants of a block that a range of corners on one axis touches.
unsigned octantsTouched(Axis axis, std::int32_t low, std::int32_t high, std::int32_t corner) {
  constexpr unsigned lower[] = {0x0f, 0x33, 0x55};
  const unsigned half = lower[index(axis)];
  return (low < corner + 4 ? half : 0U) | (high >= corner + 4 ? 0xffU ^ half : 0U);
}

void copyValues(const CornerBlock<8>& block, Key from, Key until, ToolTile& tile) {
  forRowsOf(tile, from, until, [&](int in, int out) {
    std::memcpy(tile.value.data() + out, block.value.data() + in, 8 * sizeof(float));
  });
  if (block.high <= 1) return;
  forRowsOf(tile, from, until, [&](int, int out) {
    for (int k = 0; k < 8; ++k)
      tile.value[std::size_t(out + k)] = lesser(tile.value[std::size_t(out + k)], 1.0f);
  });
}

}  // namespace

ToolKind kindOf(const BlockTable& blocks, Key low, Key high) {
  const CornerBlock<8>* first = blocks.at(Geometry::blockOf(low));
  // Of other values than 1 the sums of reconstruction round.
  bool alike = first == nullptr || (first->interned && first->value[0] >= 1);
  forBlocks(blocks, low, high, [&](const CornerBlock<8>* block, Key) {
    const bool full = block != nullptr && block->interned && block->value[0] >= 1;
    alike = alike && (first == nullptr ? block == nullptr : full);
  });
  if (!alike) return ToolKind::varied;
  return first == nullptr ? ToolKind::empty : ToolKind::full;
}

BlockTable::BlockTable(const Clay& clay) : clay_(&clay), box_(boxOf(clay)) {
  if (box_.count() > kMostEntries) return;
  const auto count = static_cast<std::size_t>(std::max<std::int64_t>(box_.count(), 0));
  blocks_.assign(count, nullptr);
  octants_.assign(count, 0);
  for (const auto& [key, run] : clay.tree) {
    const auto first = static_cast<std::ptrdiff_t>(place(key));
    std::fill_n(blocks_.begin() + first, run.length, run.block.get());
    std::fill_n(octants_.begin() + first, run.length, octantsOf(*run.block));
  }
}

std::size_t BlockTable::place(Key block) const {
  const Key at = block - box_.low;
  const auto wideJ = static_cast<std::size_t>(box_.high.j - box_.low.j + 1);
  const auto wideK = static_cast<std::size_t>(box_.high.k - box_.low.k + 1);
  return (static_cast<std::size_t>(at.i) * wideJ + static_cast<std::size_t>(at.j)) * wideK +
         static_cast<std::size_t>(at.k);
}

const CornerBlock<8>* BlockTable::at(Key block) const {
  if (!box_.contains(block)) return nullptr;
  return blocks_.empty() ? clay_->tree.find(block) : blocks_[place(block)];
}

bool BlockTable::any(const KeyBox& corners) const {
  const Key first = Geometry::blockOf(corners.low), last = Geometry::blockOf(corners.high);
  for (auto i = first.i; i <= last.i; ++i)
    for (auto j = first.j; j <= last.j; ++j)
      for (auto k = first.k; k <= last.k; ++k) {
        const Key block{i, j, k};
        if (!box_.contains(block)) continue;
        if (octants_.empty()) return true;
        unsigned touched = octants_[place(block)];
        for (const Axis axis : kAxes)
          touched &= octantsTouched(axis, corners.low[axis], corners.high[axis], 8 * block[axis]);
        if (touched != 0) return true;
      }
  return false;
}

void gather(const BlockTable& blocks, Key low, Key high, ToolTile& tile) {
  tile.low = {low.i, low.j, low.k & ~7};
  tile.wide = {high.i - low.i + 1, high.j - low.j + 1, ((high.k | 7) - tile.low.k) + 1};
  tile.kind = kindOf(blocks, tile.low, topOf(tile));
  if (tile.kind != ToolKind::varied) return;
  forParts(blocks, tile, [&](const CornerBlock<8>* block, Key from, Key until) {
    copyValues(block == nullptr ? emptyBlock<8>() : *block, from, until, tile);
  });
}

bool gatherColours(const BlockTable& blocks, const ToolTile& tile, Attributes* attributes,
                   Attributes& only) {
  Attributes any = 0, every = 0xffffff;
  forParts(blocks, tile, [&](const CornerBlock<8>* present, Key from, Key until) {
    const CornerBlock<8>& block = present == nullptr ? emptyBlock<8>() : *present;
    forRowsOf(tile, from, until, [&](int in, int out) {
      for (int k = 0; k < 8; ++k) {
        const Attributes colour = block.attributes[std::size_t(in + k)] & 0xffffff;
        const bool clay = block.value[std::size_t(in + k)] > 0;
        attributes[out + k] = colour;
        any |= clay ? colour : 0;
        every &= clay ? colour : 0xffffff;
      }
    });
  });
  only = any;
  return any != 0 && any != every;
}

}  // namespace bozzetto
