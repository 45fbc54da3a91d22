// Keys of corners, cubes, edges and of the blocks that hold them (Ferley, Cani & Gascuel 1999,
// §3.1).
//
//     corner (i,j,k) ─ lexicographic order: i first, then j, then k
//     cube   (i,j,k) = its smallest corner            edge = (its smaller corner, axis)
//
//              6───────7        corner number in a cube = 4·di + 2·dj + dk
//             /│      /│
//            4───────5 │        i ↗ (0→4)   j ↑ (0→2)   k → (0→1)
//            │ 2─────│─3
//            │/      │/
//            0───────1
#pragma once
#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>

#include "bozzetto/base/axis.hpp"

namespace bozzetto {

struct Key {
  std::int32_t i = 0, j = 0, k = 0;

  friend constexpr auto operator<=>(const Key&, const Key&) = default;
  /// What trees ask most: two comparisons instead of six.
  friend constexpr bool operator<(const Key& a, const Key& b) {
    const std::int64_t rowA = std::int64_t{a.i} * (std::int64_t{1} << 32) + a.j;
    const std::int64_t rowB = std::int64_t{b.i} * (std::int64_t{1} << 32) + b.j;
    return rowA < rowB || (rowA == rowB && a.k < b.k);
  }
  friend constexpr Key operator+(Key a, Key b) { return {a.i + b.i, a.j + b.j, a.k + b.k}; }
  friend constexpr Key operator-(Key a, Key b) { return {a.i - b.i, a.j - b.j, a.k - b.k}; }
  friend constexpr Key operator*(Key a, std::int32_t s) { return {a.i * s, a.j * s, a.k * s}; }
  constexpr std::int32_t operator[](Axis axis) const {
    return axis == Axis::x ? i : axis == Axis::y ? j : k;
  }
  constexpr std::int32_t& operator[](Axis axis) {
    return axis == Axis::x ? i : axis == Axis::y ? j : k;
  }
};

/// The workspace: corners with every index in [-kWorkspaceRim, kWorkspaceRim].
inline constexpr std::int32_t kWorkspaceRim = 1 << 30;

/// Both ends belong to the box; empty when any low exceeds its high.
struct KeyBox {
  Key low{1, 1, 1}, high{0, 0, 0};

  friend constexpr bool operator==(const KeyBox&, const KeyBox&) = default;
  constexpr bool empty() const { return low.i > high.i || low.j > high.j || low.k > high.k; }
  constexpr bool contains(Key key) const {
    return low.i <= key.i && key.i <= high.i && low.j <= key.j && key.j <= high.j &&
           low.k <= key.k && key.k <= high.k;
  }
  /// How many keys; 0 when empty.
  constexpr std::int64_t count() const {
    if (empty()) return 0;
    return (std::int64_t{high.i} - low.i + 1) * (std::int64_t{high.j} - low.j + 1) *
           (std::int64_t{high.k} - low.k + 1);
  }
};

/// The box of all corners with `rim` more on every side. Throws Error beyond the workspace.
KeyBox grown(const KeyBox& box, std::int32_t rim);

/// Throws Error unless every corner of the box lies in the workspace.
void requireInWorkspace(const KeyBox& box);

std::string toText(Key key);

/// Floor division of corner indices into blocks of `Side` (a power of two) and back.
template <int Side>
struct BlockGeometry {
  static_assert(Side > 0 && (Side & (Side - 1)) == 0);
  static constexpr int kCount = Side * Side * Side;

  static constexpr int shift() {
    int n = 0;
    while ((1 << n) < Side) ++n;
    return n;
  }
  static constexpr Key blockOf(Key corner) {
    return {corner.i >> shift(), corner.j >> shift(), corner.k >> shift()};
  }
  static constexpr Key firstCornerOf(Key block) { return block * Side; }
  /// Place of a corner inside its block, in lexicographic order.
  static constexpr int indexOf(Key corner) {
    return indexOf(corner.i & (Side - 1), corner.j & (Side - 1), corner.k & (Side - 1));
  }
  static constexpr int indexOf(int i, int j, int k) { return (i * Side + j) * Side + k; }
  static constexpr KeyBox cornersOf(Key block) {
    const Key low = firstCornerOf(block);
    return {low, low + Key{Side - 1, Side - 1, Side - 1}};
  }
};

}  // namespace bozzetto
