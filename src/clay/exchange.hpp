// Between the tree and a region: clay is loaded once, worked on, and stored through the caller's
// edit. Cells that come out as they were keep their old bits.
#pragma once
#include "bozzetto/field/field.hpp"
#include "clay/region.hpp"

namespace bozzetto::clay {

/// Reads the clay of the whole box, and colours where there is more than one.
template <int Side>
void load(Region& region, const Edit<CornerBlock<Side>>& edit);

/// Writes what differs; returns the keys of blocks that changed, in key order.
template <int Side>
std::vector<KeyRun> store(Region& region, Edit<CornerBlock<Side>>& edit);

}  // namespace bozzetto::clay
