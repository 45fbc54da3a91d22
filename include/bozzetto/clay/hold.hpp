// Holding clay: what is held does not move, whoever pushes.
#pragma once
#include "bozzetto/field/field.hpp"

namespace bozzetto::clay {

/// Sets the hold of all clay in the box of corners: 0 free … 1 fixed. Throws Error for other
/// amounts. O(clay in the box).
template <int Side>
void holdClay(Edit<CornerBlock<Side>>& edit, const KeyBox& box, double amount);

/// Frees all clay. O(blocks).
template <int Side>
void releaseClay(Edit<CornerBlock<Side>>& edit);

extern template void holdClay(Edit<CornerBlock<1>>&, const KeyBox&, double);
extern template void holdClay(Edit<CornerBlock<8>>&, const KeyBox&, double);
extern template void releaseClay(Edit<CornerBlock<1>>&);
extern template void releaseClay(Edit<CornerBlock<8>>&);

}  // namespace bozzetto::clay
