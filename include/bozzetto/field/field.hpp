// The clay: a tree of corner blocks and the two constants that give it scale. Inside is
// value ≥ iso; a corner that is not stored has value 0.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "bozzetto/field/corner_block.hpp"
#include "bozzetto/grid/edit.hpp"
#include "bozzetto/grid/key_tree.hpp"

namespace bozzetto {

struct FieldScale {
  double spacing = 1.0;  ///< world units per cell; > 0
  float iso = 0.5f;      ///< surface threshold; 0 < iso < 1
  friend bool operator==(const FieldScale&, const FieldScale&) = default;
};

/// A value type: copying it copies block pointers only.
template <int Side>
struct Field {
  using Block = CornerBlock<Side>;
  using Tree = KeyTree<Block>;
  using Geometry = BlockGeometry<Side>;

  Tree tree;
  FieldScale scale;

  /// Density at a corner, 0 when nothing is stored. O(log n).
  float value(Key corner) const;
  /// Colour and hold at a corner, 0 when nothing is stored.
  Attributes attributes(Key corner) const;
};

/// What `info` tells about a field.
struct FieldStatistics {
  std::int64_t corners = 0;  ///< corners with value > 0
  std::size_t nodes = 0;     ///< tree nodes
  std::size_t blocks = 0;    ///< blocks in memory, each interned one once
  std::size_t bytes = 0;     ///< of nodes and blocks
  double mass = 0;           ///< Σ value · spacing³, world units
  KeyBox bounds;             ///< of the corners with value > 0
};

/// One pass over the tree; O(blocks).
template <int Side>
FieldStatistics statistics(const Field<Side>& field);

/// Σ value in mass units; 128 bits, because 2³⁰-cell solids fit. O(nodes). Committed fields only.
template <int Side>
MassSum massUnits(const Field<Side>& field);

/// Names the field's content: equal for equal corners (key, value, attributes) whatever the block
/// side, the thread count, or the way it was built. Defined in src/field/NOTES.md. O(corners near
/// the surface + rows of the inside), in parallel.
template <int Side>
std::uint64_t fieldHash(const Field<Side>& field);

/// The first broken promise, if any: tree order, block ranges, masses, interning, no empty blocks,
/// finite values ≥ 0, attributes only where there is clay. For committed fields.
template <int Side>
std::optional<std::string> validate(const Field<Side>& field);

/// The same clay in blocks of another (or the same) side.
template <int To, int From>
Field<To> withSide(const Field<From>& field);

using Clay = Field<8>;

}  // namespace bozzetto
