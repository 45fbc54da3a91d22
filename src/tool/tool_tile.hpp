// The part of a tool that one block of corners reads, as a dense box: the tool's own cubes without
// a search a corner (Ferley §4.1.2: a cube keeps pointers to its corners).
#pragma once
#include <array>
#include <vector>

#include "bozzetto/field/field.hpp"
#include "tool/tool_bricks.hpp"

namespace bozzetto {

/// The blocks of a tool by place: an array where its box is small enough, else the tree.
class BlockTable {
 public:
  explicit BlockTable(const Clay& clay);
  const CornerBlock<8>* at(Key block) const;
  /// True unless no corner of the box holds clay; may miss a miss, never a hit.
  bool any(const KeyBox& corners) const;

 private:
  std::size_t place(Key block) const;

  const Clay* clay_;
  KeyBox box_;
  std::vector<const CornerBlock<8>*> blocks_;  // empty: ask the tree
  std::vector<std::uint8_t> octants_;
};

/// Densities of a box of corners, (i·wide[1] + j)·wide[2] + k from `low`.
struct ToolTile {
  // A turned block of 8 corners, steps up to √2: 7·√2·√3 + 3 corners at most on each axis.
  static constexpr int kWidest = 22, kWidestK = 32;  // along k whole rows of blocks
  static constexpr std::size_t kCorners = kWidest * kWidest * kWidestK + 8;
  Key low;
  std::array<int, 3> wide;
  ToolKind kind;
  alignas(64) std::array<float, kCorners> value;
};

/// What blocks the corners low … high touch are, all together.
ToolKind kindOf(const BlockTable& blocks, Key low, Key high);

/// Fills the tile with the corners low … high and some more, unless they are all 0 or all 1. Values
/// above 1 count as 1.
void gather(const BlockTable& blocks, Key low, Key high, ToolTile& tile);

/// The same box of attributes. Returns false, and fills nothing, when all clay in it has one
/// colour, which comes in `only`.
bool gatherColours(const BlockTable& blocks, const ToolTile& tile, Attributes* attributes,
                   Attributes& only);

}  // namespace bozzetto
