// How many corners of a dab's box lie in the tool's local box: the paper's "computed".
#pragma once
#include "bozzetto/tool/potential.hpp"

namespace bozzetto {

/// Exact for the float positions that kernels see. `low` and `high` count from the frame's cell.
/// O(1) rows for axis-aligned tools, else O(rows); no corner is looked at alone.
std::int64_t countLocal(const LocalFrame& frame, Key low, Key high);

}  // namespace bozzetto
