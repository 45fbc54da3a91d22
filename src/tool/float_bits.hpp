// Comparisons and selections as integer arithmetic on masks. Floats that are never negative compare
// like their bits; without branches and float comparisons compilers turn the loops of kernels into
// vectors under default flags, which bend no arithmetic.
#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "bozzetto/base/simd.hpp"

namespace bozzetto {

BOZZETTO_KERNEL std::int32_t bits(float x) { return std::bit_cast<std::int32_t>(x); }
BOZZETTO_KERNEL std::int64_t bits(double x) { return std::bit_cast<std::int64_t>(x); }
BOZZETTO_KERNEL float real(std::int32_t b) { return std::bit_cast<float>(b); }
BOZZETTO_KERNEL double real(std::int64_t b) { return std::bit_cast<double>(b); }

/// All bits where the sign bit is set, else none.
template <class Integer>
BOZZETTO_KERNEL Integer signMask(Integer b) {
  return b >> (8 * sizeof(Integer) - 1);
}

/// All bits where x > 0, for x ≥ 0.
template <class Real>
BOZZETTO_KERNEL auto positiveMask(Real x) {
  return signMask(0 - bits(x));
}

/// All bits where a < b, for a and b ≥ 0.
template <class Real>
BOZZETTO_KERNEL auto lessMask(Real a, Real b) {
  return signMask(bits(a) - bits(b));
}

/// a where the mask is set, else b.
template <class Mask, class Integer>
BOZZETTO_KERNEL Integer pick(Mask mask, Integer a, Integer b) {
  return b ^ ((a ^ b) & static_cast<Integer>(mask));
}
template <class Mask>
BOZZETTO_KERNEL float pick(Mask mask, float a, float b) {
  return real(pick(mask, bits(a), bits(b)));
}
template <class Mask>
BOZZETTO_KERNEL double pick(Mask mask, double a, double b) {
  return real(pick(mask, bits(a), bits(b)));
}

/// max(x, 0), for any x but NaN.
template <class Real>
BOZZETTO_KERNEL Real positive(Real x) {
  return real(std::max(bits(x), decltype(bits(x)){0}));
}

/// The lesser and the greater of two numbers ≥ 0.
template <class Real>
BOZZETTO_KERNEL Real lesser(Real a, Real b) {
  return real(std::min(bits(a), bits(b)));
}
template <class Real>
BOZZETTO_KERNEL Real greater(Real a, Real b) {
  return real(std::max(bits(a), bits(b)));
}

}  // namespace bozzetto
