// Between the tree and a region: clay is loaded once, worked on, and stored through the caller's
// edit. Cells that come out as they were keep their old bits.
#pragma once
#include <span>

#include "bozzetto/field/field.hpp"
#include "clay/region.hpp"

namespace bozzetto::clay {

/// Reads the clay of the whole box, and colours where there is more than one.
template <int Side>
void load(Region& region, const Edit<CornerBlock<Side>>& edit);

/// After load: painted stiffness as well.
template <int Side>
void loadStiffness(Region& region, const Edit<CornerBlock<Side>>& edit,
                   const Edit<CornerBlock<8>>& painted);

/// Writes what differs in these tiles; returns the keys of blocks that changed, in key order.
template <int Side>
std::vector<KeyRun> store(const Region& region, std::span<const Key> tiles,
                          Edit<CornerBlock<Side>>& edit);

void storeStiffness(const Region& region, std::span<const Key> tiles,
                    Edit<CornerBlock<8>>& painted);

}  // namespace bozzetto::clay
