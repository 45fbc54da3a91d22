// Painted stiffness: an offset o in −1 … 1, cell by cell, from the stiffness that strokes have.
// Below 0 clay gives way sooner, above 0 it follows tools and what is stiff keeps its form.
//
// It is kept as clay of its own, so that copies, files and grids of other spacing are those of
// clay: density |o|, white where o > 0, black where o < 0. Where no clay is, nothing is stored.
#pragma once
#include <memory>
#include <span>

#include "bozzetto/field/field.hpp"

namespace bozzetto::clay {

/// The offset that a density and its colour stand for.
inline float offsetOf(float value, Attributes attributes) {
  return value * (static_cast<float>(colourOf(attributes).r) * (2.0f / 255) - 1);
}

struct Stiffness {
  std::shared_ptr<const Clay> painted;  ///< null: none

  bool any() const { return painted && !painted->tree.empty(); }
  /// The offset at a corner. O(log n).
  double at(Key corner) const;
  /// By content. O(1) for the same one, O(blocks) for copies.
  friend bool operator==(const Stiffness& a, const Stiffness& b);
};

/// Null where nothing is painted.
Stiffness stiffnessOf(Clay painted);

/// Throws Error, opened by `name`, unless all densities are in 0…1. O(corners painted).
void requireValid(const Stiffness& stiffness, const std::string& name);

/// How far clay follows, from the stiffness of the stroke and the offset: α(1 + o) below 0,
/// α + (1 − α)o above.
constexpr float followingAt(float stiffness, float offset) {
  return stiffness + offset * (offset < 0 ? stiffness : 1 - stiffness);
}

/// Takes paint off these corners of blocks of side 8 where there is no clay. O(their corners).
template <int Side>
void keepOnClay(Edit<CornerBlock<8>>& painted, std::span<const KeyRun> blocks,
                const KeyTree<CornerBlock<Side>>& clay);

extern template void keepOnClay(Edit<CornerBlock<8>>&, std::span<const KeyRun>,
                                const KeyTree<CornerBlock<1>>&);
extern template void keepOnClay(Edit<CornerBlock<8>>&, std::span<const KeyRun>,
                                const KeyTree<CornerBlock<8>>&);

}  // namespace bozzetto::clay
