// Reconstruction of straight tools for AVX2 by hand, and what that of turned ones shares with it.
// The same arithmetic, bit for bit, as alignedBody.
#pragma once
#if defined(__x86_64__)
#include <immintrin.h>

#include "tool/trilinear.hpp"

namespace bozzetto {

BOZZETTO_TARGET_AVX2 inline __m256 mixed(__m256 a, __m256 b, __m256 t, __m256 rest) {
  return _mm256_add_ps(_mm256_mul_ps(a, rest), _mm256_mul_ps(b, t));
}

// Steps along a row of 8.
BOZZETTO_TARGET_AVX2 inline __m256i alongRow(const FixedFrame& frame, int axis) {
  const __m256i lanes = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
  return _mm256_mullo_epi32(lanes, _mm256_set1_epi32(frame.step[2][axis]));
}

// Eight places on one axis, one after the other.
struct AxisPlaces {
  std::array<Place, 8> place;
  std::int32_t low = INT32_MAX, high = INT32_MIN;  // the corners among them
};

inline AxisPlaces axisPlaces(const TilePatch& patch, Axis axis) {
  AxisPlaces places;
  const int a = index(axis);
  for (int n = 0; n < 8; ++n) {
    Key corner = patch.first;
    corner[axis] += n;
    Place& place = places.place[std::size_t(n)];
    place = placeOn(positionOn(patch.frame, a, corner), patch.low[axis] - patch.base[axis]);
    places.low = std::min(places.low, place.corner);
    places.high = std::max(places.high, place.corner);
  }
  return places;
}

// Two planes of a box side by side, between which a plane of the clay lies.
struct PlanePair {
  const float *near, *far;
  __m256 t, rest;
};

BOZZETTO_TARGET_AVX2 inline PlanePair planesAt(const TilePatch& patch, const Place& place) {
  const std::ptrdiff_t strideI = std::ptrdiff_t{patch.wide[1]} * patch.wide[2];
  const float* near = patch.value + std::clamp(place.corner, 0, patch.wide[0] - 2) * strideI;
  return {near, near + strideI, _mm256_set1_ps(place.fraction),
          _mm256_set1_ps(1.0f - place.fraction)};
}

BOZZETTO_TARGET_AVX2 inline __m256 betweenPlanes(const PlanePair& planes, std::ptrdiff_t at) {
  return mixed(_mm256_loadu_ps(planes.near + at), _mm256_loadu_ps(planes.far + at), planes.t,
               planes.rest);
}

// Where tool and clay have cells of one size along k: rows of 8 from rows as they lie, in a tile or
// in the box of the whole tool. Rows of the tool between two of the clay serve both.
BOZZETTO_TARGET_AVX2 inline void oneByOneAvx2(const TilePatch& patch, float* result) {
  const AxisPlaces alongI = axisPlaces(patch, Axis::x), alongJ = axisPlaces(patch, Axis::y);
  const Place k = axisPlaces(patch, Axis::z).place[0];
  const std::int32_t start = std::clamp(k.corner, 0, patch.wide[2] - 9);
  const __m256 tk = _mm256_set1_ps(k.fraction), restK = _mm256_set1_ps(1.0f - k.fraction);
  const auto rowAt = [&](std::int32_t j) {
    return std::ptrdiff_t{std::clamp(j, 0, patch.wide[1] - 1)} * patch.wide[2] + start;
  };
  for (std::size_t i = 0; i < 8; ++i) {
    const PlanePair planes = planesAt(patch, alongI.place[i]);
    __m256 low[2], high[2] = {};
    std::int32_t known = INT32_MIN;
    for (std::size_t j = 0; j < 8; ++j) {
      const std::int32_t corner = alongJ.place[j].corner;
      const std::ptrdiff_t at = rowAt(corner), next = rowAt(corner + 1);
      for (int n = 0; n < 2; ++n) {
        low[n] = corner == known ? high[n] : betweenPlanes(planes, at + n);
        high[n] = betweenPlanes(planes, next + n);
      }
      known = corner + 1;
      const __m256 tj = _mm256_set1_ps(alongJ.place[j].fraction),
                   restJ = _mm256_set1_ps(1.0f - alongJ.place[j].fraction);
      _mm256_storeu_ps(
          result + (i * 8 + j) * 8,
          mixed(mixed(low[0], high[0], tj, restJ), mixed(low[1], high[1], tj, restJ), tk, restK));
    }
  }
}

// Sixteen entries in two halves, any eight of them at once.
struct Sixteen {
  __m256 low, high;
};

BOZZETTO_TARGET_AVX2 inline __m256 entriesOf(const Sixteen& all, __m256i at) {
  const __m256 upper = _mm256_castsi256_ps(_mm256_cmpgt_epi32(at, _mm256_set1_epi32(7)));
  return _mm256_blendv_ps(_mm256_permutevar8x32_ps(all.low, at),
                          _mm256_permutevar8x32_ps(all.high, at), upper);
}

// Where the tool's cells have another size: rows of 8 from 16 of the box of the whole tool, which
// has rims that wide.
BOZZETTO_TARGET_AVX2 inline void scaledAvx2(const TilePatch& patch, float* result) {
  const AxisPlaces alongI = axisPlaces(patch, Axis::x), alongJ = axisPlaces(patch, Axis::y);
  const AxisPlaces alongK = axisPlaces(patch, Axis::z);
  const std::int32_t start = std::clamp(alongK.low, 0, patch.wide[2] - 16);
  alignas(32) std::int32_t corners[8];
  alignas(32) float fractions[8];
  for (std::size_t n = 0; n < 8; ++n) {
    corners[n] = alongK.place[n].corner - alongK.low;
    fractions[n] = alongK.place[n].fraction;
  }
  const __m256i at = _mm256_load_si256(reinterpret_cast<const __m256i*>(corners));
  const __m256i next = _mm256_add_epi32(at, _mm256_set1_epi32(1));
  const __m256 tk = _mm256_load_ps(fractions), restK = _mm256_sub_ps(_mm256_set1_ps(1.0f), tk);
  for (std::size_t i = 0; i < 8; ++i) {
    const PlanePair planes = planesAt(patch, alongI.place[i]);
    Sixteen rows[16];  // of the tool, between the planes
    for (std::int32_t j = alongJ.low; j <= alongJ.high + 1; ++j) {
      const std::ptrdiff_t row =
          std::ptrdiff_t{std::clamp(j, 0, patch.wide[1] - 1)} * patch.wide[2] + start;
      rows[j - alongJ.low] = {betweenPlanes(planes, row), betweenPlanes(planes, row + 8)};
    }
    for (std::size_t j = 0; j < 8; ++j) {
      const Place& place = alongJ.place[j];
      const Sixteen *near = rows + (place.corner - alongJ.low), *far = near + 1;
      const __m256 tj = _mm256_set1_ps(place.fraction),
                   restJ = _mm256_set1_ps(1.0f - place.fraction);
      const Sixteen row{mixed(near->low, far->low, tj, restJ),
                        mixed(near->high, far->high, tj, restJ)};
      _mm256_storeu_ps(result + (i * 8 + j) * 8,
                       mixed(entriesOf(row, at), entriesOf(row, next), tk, restK));
    }
  }
}

}  // namespace bozzetto
#endif
