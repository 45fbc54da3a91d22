// Rows of corners as bits: inside or not.
#pragma once
#include <cstdint>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "bozzetto/base/simd.hpp"

namespace bozzetto {

/// Bit n: value n of the row is inside. Rows of 8 are aligned to 16 bytes.
template <int Side>
BOZZETTO_KERNEL std::uint32_t insideBits(const float* value, float iso) {
#if defined(__SSE2__)
  if constexpr (Side == 8) {
    const __m128 threshold = _mm_set1_ps(iso);
    const int low = _mm_movemask_ps(_mm_cmpge_ps(_mm_load_ps(value), threshold));
    const int high = _mm_movemask_ps(_mm_cmpge_ps(_mm_load_ps(value + 4), threshold));
    return static_cast<std::uint32_t>(low | high << 4);
  }
#endif
  std::uint32_t bits = 0;
  for (int n = 0; n < Side; ++n) bits |= (value[n] >= iso ? 1u : 0u) << n;
  return bits;
}

/// Whether a block lies on one side of iso as a whole; then its corners need not be read.
enum class BlockSide { outside, inside, mixed };

template <class Block>
BlockSide sideOf(const Block& block, float iso) {
  if (block.low >= iso) return BlockSide::inside;
  return block.high < iso ? BlockSide::outside : BlockSide::mixed;
}

}  // namespace bozzetto
