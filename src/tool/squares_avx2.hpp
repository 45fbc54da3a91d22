// Scattered reads of dense boxes for AVX2, by squares of two rows: gathers, of single numbers, are
// forty steps each on some processors.
#pragma once
#if defined(__x86_64__)
#include <immintrin.h>

#include <cstddef>
#include <cstdint>

#include "bozzetto/base/simd.hpp"

namespace bozzetto {

// The square of a corner across the tool's x.
BOZZETTO_TARGET_AVX2 inline __m128 squareAt(const float* corner, std::ptrdiff_t strideJ) {
  const auto pair = [](const float* from) { return reinterpret_cast<const __m64*>(from); };
  const __m128 row = _mm_loadl_pi(_mm_setzero_ps(), pair(corner));
  return _mm_loadh_pi(row, pair(corner + strideJ));
}

struct Squares {
  const float* value;
  std::ptrdiff_t strideI, strideJ;
  BOZZETTO_TARGET_AVX2 __m128 near(std::int32_t n) const { return squareAt(value + n, strideJ); }
  BOZZETTO_TARGET_AVX2 __m128 far(std::int32_t n) const {
    return squareAt(value + n + strideI, strideJ);
  }
};

BOZZETTO_TARGET_AVX2 inline __m256 both(__m128 low, __m128 high) {
  return _mm256_insertf128_ps(_mm256_castps128_ps256(low), high, 1);
}

BOZZETTO_TARGET_AVX2 inline __m256 lowPairs(__m256 a, __m256 b) {
  return _mm256_castpd_ps(_mm256_unpacklo_pd(_mm256_castps_pd(a), _mm256_castps_pd(b)));
}
BOZZETTO_TARGET_AVX2 inline __m256 highPairs(__m256 a, __m256 b) {
  return _mm256_castpd_ps(_mm256_unpackhi_pd(_mm256_castps_pd(a), _mm256_castps_pd(b)));
}

// Of eight corners: themselves, the next along the rows, those beside them in the next row, and
// the next of those.
struct Sorted {
  __m256 corner, next, beside, besideNext;
};

// From squares of corners n and n + 4 to their four corners.
BOZZETTO_TARGET_AVX2 inline Sorted sorted(__m256 a, __m256 b, __m256 c, __m256 d) {
  const __m256 ab = _mm256_unpacklo_ps(a, b), cd = _mm256_unpacklo_ps(c, d),
               abBeside = _mm256_unpackhi_ps(a, b), cdBeside = _mm256_unpackhi_ps(c, d);
  return {lowPairs(ab, cd), highPairs(ab, cd), lowPairs(abBeside, cdBeside),
          highPairs(abBeside, cdBeside)};
}

}  // namespace bozzetto
#endif
