// Raising clay to wanted densities, as fill does: where that raises it, it takes the colour; held
// corners yield less.
#pragma once
#include <array>

#include "bozzetto/field/field.hpp"

namespace bozzetto {

using WantedDensities = std::array<float, 512>;

/// Corners of block `key` (of side 8) to at least `wanted`. Returns how many changed.
std::int64_t raise(Edit<CornerBlock<8>>& edit, Key key, const WantedDensities& wanted,
                   Attributes colour);
std::int64_t raise(Edit<CornerBlock<1>>& edit, Key key, const WantedDensities& wanted,
                   Attributes colour);

/// The same for whole blocks to 1.
std::int64_t raiseFull(Edit<CornerBlock<8>>& edit, KeyRun run, Attributes colour);
std::int64_t raiseFull(Edit<CornerBlock<1>>& edit, KeyRun run, Attributes colour);

}  // namespace bozzetto
