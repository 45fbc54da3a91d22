// The turned kernel for AVX2 by hand: compilers make scalar loads of its scattered reads. The same
// arithmetic, bit for bit, as turnedBody.
#pragma once
#if defined(__x86_64__)
#include <immintrin.h>

#include "tool/trilinear.hpp"

namespace bozzetto {

BOZZETTO_TARGET_AVX2 inline __m256 mixed(__m256 a, __m256 b, __m256 t, __m256 rest) {
  return _mm256_add_ps(_mm256_mul_ps(a, rest), _mm256_mul_ps(b, t));
}

// Positions of a row on one axis: corners in the tile, and the ways from there to the next.
struct RowPlaces {
  __m256i corner;
  __m256 t, rest;
};

BOZZETTO_TARGET_AVX2 inline RowPlaces placesOn(std::int32_t start, __m256i along,
                                               std::int32_t low) {
  const __m256i position = _mm256_add_epi32(_mm256_set1_epi32(start), along);
  const __m256i fraction = _mm256_and_si256(position, _mm256_set1_epi32((1 << kFractionBits) - 1));
  const __m256 t =
      _mm256_mul_ps(_mm256_cvtepi32_ps(fraction), _mm256_set1_ps(1.0f / (1 << kFractionBits)));
  return {_mm256_sub_epi32(_mm256_srai_epi32(position, kFractionBits), _mm256_set1_epi32(low)), t,
          _mm256_sub_ps(_mm256_set1_ps(1.0f), t)};
}

// Between two corners along the tool's x, for each of the row.
BOZZETTO_TARGET_AVX2 inline __m256 alongI(const float* value, __m256i at, std::int32_t strideI,
                                          const RowPlaces& places) {
  return mixed(_mm256_i32gather_ps(value, at, 4), _mm256_i32gather_ps(value + strideI, at, 4),
               places.t, places.rest);
}

BOZZETTO_TARGET_AVX2 inline __m256 cellsAt(const float* value, __m256i at, std::int32_t strideI,
                                           std::int32_t strideJ, const RowPlaces (&p)[3]) {
  const __m256 near0 = alongI(value, at, strideI, p[0]);
  const __m256 near1 = alongI(value + 1, at, strideI, p[0]);
  const __m256 far0 = alongI(value + strideJ, at, strideI, p[0]);
  const __m256 far1 = alongI(value + strideJ + 1, at, strideI, p[0]);
  return mixed(mixed(near0, far0, p[1].t, p[1].rest), mixed(near1, far1, p[1].t, p[1].rest), p[2].t,
               p[2].rest);
}

BOZZETTO_TARGET_AVX2 inline void turnedAvx2(const TilePatch& patch, float* result) {
  const FixedFrame& frame = patch.frame;
  const std::int32_t strideJ = patch.wide[2], strideI = patch.wide[1] * strideJ;
  const __m256i lanes = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
  __m256i along[3];
  std::int32_t low[3];
  for (const Axis axis : kAxes) {
    const int a = index(axis);
    along[a] = _mm256_mullo_epi32(lanes, _mm256_set1_epi32(frame.step[2][a]));
    low[a] = patch.low[axis] - patch.base[axis];
  }
  for (int row = 0; row < 64; ++row) {
    const Key first = patch.first + Key{row >> 3, row & 7, 0};
    RowPlaces places[3];
    for (int a = 0; a < 3; ++a) places[a] = placesOn(positionOn(frame, a, first), along[a], low[a]);
    const __m256i i = _mm256_mullo_epi32(places[0].corner, _mm256_set1_epi32(strideI));
    const __m256i j = _mm256_mullo_epi32(places[1].corner, _mm256_set1_epi32(strideJ));
    const __m256i at = _mm256_add_epi32(_mm256_add_epi32(i, j), places[2].corner);
    _mm256_storeu_ps(result + 8 * row, cellsAt(patch.value, at, strideI, strideJ, places));
  }
}

// alignedBody where tool and clay have cells of one size along k: rows of 8 from rows as they lie,
// in a tile or in the box of the whole tool. Left to itself the compiler cuts these rows into
// pieces of 4, 2, 1 and 1.
BOZZETTO_TARGET_AVX2 inline void oneByOneAvx2(const TilePatch& patch, float* result) {
  const std::int32_t strideJ = patch.wide[2], strideI = patch.wide[1] * strideJ;
  const auto placeOf = [&](Axis axis, int n) {
    Key corner = patch.first;
    corner[axis] += n;
    const int a = index(axis);
    return placeOn(positionOn(patch.frame, a, corner), patch.low[axis] - patch.base[axis]);
  };
  Place along[8];
  for (int j = 0; j < 8; ++j) along[j] = placeOf(Axis::y, j);
  const Place k = placeOf(Axis::z, 0);
  const __m256 tk = _mm256_set1_ps(k.fraction), restK = _mm256_set1_ps(1.0f - k.fraction);
  for (int i = 0; i < 8; ++i) {
    const Place at = placeOf(Axis::x, i);
    const float* plane = patch.value + at.corner * strideI + k.corner;
    const __m256 ti = _mm256_set1_ps(at.fraction), restI = _mm256_set1_ps(1.0f - at.fraction);
    for (int j = 0; j < 8; ++j) {
      const float* near = plane + along[j].corner * strideJ;
      const float* far = near + strideI;
      const __m256 tj = _mm256_set1_ps(along[j].fraction),
                   restJ = _mm256_set1_ps(1.0f - along[j].fraction);
      __m256 row[2];
      for (int n = 0; n < 2; ++n) {
        const __m256 low = mixed(_mm256_loadu_ps(near + n), _mm256_loadu_ps(far + n), ti, restI);
        const __m256 high = mixed(_mm256_loadu_ps(near + strideJ + n),
                                  _mm256_loadu_ps(far + strideJ + n), ti, restI);
        row[n] = mixed(low, high, tj, restJ);
      }
      _mm256_storeu_ps(result + (i * 8 + j) * 8, mixed(row[0], row[1], tk, restK));
    }
  }
}

}  // namespace bozzetto
#endif
