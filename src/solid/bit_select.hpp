// Selection by bits: what compilers turn into vectors where they give up on comparisons.
#pragma once
#include <bit>
#include <cstdint>

#include "bozzetto/base/simd.hpp"

namespace bozzetto {

/// All bits set where x is negative.
BOZZETTO_KERNEL std::int32_t negativeMask(float x) { return std::bit_cast<std::int32_t>(x) >> 31; }

/// a where the mask is set, else b.
BOZZETTO_KERNEL float select(std::int32_t mask, float a, float b) {
  const auto bitsA = std::bit_cast<std::int32_t>(a), bitsB = std::bit_cast<std::int32_t>(b);
  return std::bit_cast<float>((bitsA & mask) | (bitsB & ~mask));
}

/// The lesser of two numbers that are not negative.
BOZZETTO_KERNEL float lesserOf(float a, float b) {
  const auto bitsA = std::bit_cast<std::int32_t>(a), bitsB = std::bit_cast<std::int32_t>(b);
  return std::bit_cast<float>(bitsA < bitsB ? bitsA : bitsB);
}

/// x, or 0 where it is negative.
BOZZETTO_KERNEL float atLeastZero(float x) {
  return std::bit_cast<float>(std::bit_cast<std::int32_t>(x) & ~negativeMask(x));
}

}  // namespace bozzetto
