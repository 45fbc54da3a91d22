// The pyramid's filter, [1 1 2 2 1 1]/8 along each axis, over one block.
#pragma once
#include <array>

namespace bozzetto {

/// 8³ averages from the 4³ blocks (null = zeros) that begin one block before the doubled key.
/// Equal densities come out unchanged, bit for bit.
void halve(const std::array<const float*, 64>& blocks, std::array<float, 512>& out);

}  // namespace bozzetto
