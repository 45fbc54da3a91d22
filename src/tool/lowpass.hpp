// The 3 × 3 × 3 binomial of a block, gathered across its neighbours.
#pragma once
#include <array>

#include "bozzetto/tool/action.hpp"

namespace bozzetto {

/// Room for the low-passed block; `result` points into it.
template <int Side>
struct LowpassBuffer {
  static constexpr int kCount = Side * Side * Side;
  alignas(64) std::array<std::array<float, kCount>, 5> arrays;
  Lowpass result;
};

/// A block and its 26 neighbours, null where there is none; index (di·3 + dj)·3 + dk, the block
/// itself at 13.
template <int Side>
using Neighbourhood = std::array<const CornerBlock<Side>*, 27>;

template <int Side>
void lowpass(const Neighbourhood<Side>& blocks, LowpassBuffer<Side>& buffer);

/// A block and those across its faces: itself, then before and after it along i, j and k.
template <int Side>
using Faces = std::array<const CornerBlock<Side>*, 7>;

/// Lowpass::climb alone, for which faces are enough. False where it is 0 everywhere.
template <int Side>
bool climbOf(const Faces<Side>& blocks, float* climb);

}  // namespace bozzetto
