// The corner blocks a patch depends on. Its cubes use corners 0…Side of the block, the gradients at
// those one corner more on every side: blocks -1…kAbove on each axis.
#pragma once
#include <array>

#include "bozzetto/field/corner_block.hpp"

namespace bozzetto {

template <int Side>
struct BlockWindow {
  using Block = CornerBlock<Side>;
  static constexpr int kAbove = (2 * Side + 1) / Side - 1;  // 1 for side 8, 2 for side 1
  static constexpr int kSpan = kAbove + 2;

  /// Never null: absent blocks are `empty()`. Order (i, j, k).
  std::array<const Block*, kSpan * kSpan * kSpan> blocks;

  /// `i`, `j`, `k` from -1 to kAbove.
  const Block& at(int i, int j, int k) const {
    return *blocks[((i + 1) * kSpan + j + 1) * kSpan + k + 1];
  }

  /// The block and place of a corner; local coordinates -1…Side + 1.
  struct Place {
    const Block* block;
    int index;
  };
  Place place(int i, int j, int k) const {
    constexpr int shift = BlockGeometry<Side>::shift(), mask = Side - 1;
    return {&at(i >> shift, j >> shift, k >> shift),
            BlockGeometry<Side>::indexOf(i & mask, j & mask, k & mask)};
  }

  static const Block* empty() {
    static const Block* const block = [] {
      static const Ref<Block> kept(new Block());
      return kept.get();
    }();
    return block;
  }
};

}  // namespace bozzetto
