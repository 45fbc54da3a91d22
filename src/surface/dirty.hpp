// Dirty corners: what an edit changed inside its blocks (Ferley §3.2).
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "bozzetto/field/corner_block.hpp"
#include "bozzetto/grid/delta.hpp"
#include "surface/key_runs.hpp"

namespace bozzetto {

/// Bit k of entry i · Side + j: corner (i, j, k) of the block changed.
template <int Side>
using DirtyRows = std::array<std::uint8_t, Side * Side>;

/// Compares values and attributes; null stands for an empty block.
template <int Side>
DirtyRows<Side> dirtyRows(const CornerBlock<Side>* before, const CornerBlock<Side>* after);

/// The changed blocks of a delta, and in which of their neighbours' patches that is felt.
template <int Side>
std::vector<TouchedRun> touchedRuns(const Delta<CornerBlock<Side>>& delta);

}  // namespace bozzetto
