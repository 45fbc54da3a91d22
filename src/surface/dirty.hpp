// Dirty corners: what an edit changed inside its blocks (Ferley §3.2).
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "bozzetto/field/changed_run.hpp"
#include "bozzetto/field/corner_block.hpp"
#include "bozzetto/grid/delta.hpp"
#include "surface/key_runs.hpp"

namespace bozzetto {

/// In which neighbours' patches a change of these corners is felt.
template <int Side>
std::array<Reach, 3> reachOf(const CornerBits& corners);

/// The changed blocks of a delta, and in which of their neighbours' patches that is felt.
template <int Side>
std::vector<TouchedRun> touchedRuns(const Delta<CornerBlock<Side>>& delta);

}  // namespace bozzetto
