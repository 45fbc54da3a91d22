#include "tool/grid_rows.hpp"

#include <algorithm>

#include "tool/float_bits.hpp"
#include "tool/squares_avx2.hpp"
#include "tool/trilinear_avx2.hpp"

namespace bozzetto {
namespace {

BOZZETTO_KERNEL float between(float a, float b, float t) { return a * (1.0f - t) + b * t; }

BOZZETTO_KERNEL void rowKernel(const float* grid, const std::array<int, 3>& wide,
                               const GridRow& places, float* result) {
  const std::int32_t stride[3] = {wide[1] * wide[2], wide[2], 1};
  std::int32_t at[8] = {};
  float t[3][8];
  for (std::size_t a = 0; a < 3; ++a) {
    const float most = static_cast<float>(wide[a] - 1) - 0.001f;
    for (std::int32_t n = 0; n < 8; ++n) {
      const auto units = static_cast<float>(places.start[a] + n * places.step[a]);
      const float place = units * places.perUnit + places.offset[a];
      const float inside = lesser(positive(place), most);
      const auto corner = static_cast<std::int32_t>(inside);
      t[a][n] = inside - static_cast<float>(corner);
      at[n] += corner * stride[a];
    }
  }
  for (int n = 0; n < 8; ++n) {
    const float* cell = grid + at[n];
    const std::int32_t i = stride[0], j = stride[1];
    const float near = between(between(cell[0], cell[1], t[2][n]),
                               between(cell[j], cell[j + 1], t[2][n]), t[1][n]);
    const float far = between(between(cell[i], cell[i + 1], t[2][n]),
                              between(cell[i + j], cell[i + j + 1], t[2][n]), t[1][n]);
    result[n] = between(near, far, t[0][n]) * places.scale;
  }
}

#if defined(__x86_64__)
// Between the corners of eight squares, along k and j.
BOZZETTO_TARGET_AVX2 inline __m256 squareAvx2(const Sorted& all, const __m256 (&t)[3],
                                              const __m256 (&rest)[3]) {
  return mixed(mixed(all.corner, all.next, t[2], rest[2]),
               mixed(all.beside, all.besideNext, t[2], rest[2]), t[1], rest[1]);
}

[[gnu::always_inline]] BOZZETTO_TARGET_AVX2 inline Sorted squaresAvx2(const float* grid,
                                                                      const std::int32_t* at,
                                                                      std::ptrdiff_t strideJ) {
  __m256 two[4];
  for (int n = 0; n < 4; ++n)
    two[n] = both(squareAt(grid + at[n], strideJ), squareAt(grid + at[n + 4], strideJ));
  return sorted(two[0], two[1], two[2], two[3]);
}

// The same arithmetic, bit for bit; compilers make scalar loads of its scattered reads.
BOZZETTO_TARGET_AVX2 void rowAvx2(const float* grid, const std::array<int, 3>& wide,
                                  const GridRow& places, float* result) {
  const std::int32_t stride[3] = {wide[1] * wide[2], wide[2], 1};
  const __m256i lanes = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
  const __m256 perUnit = _mm256_set1_ps(places.perUnit), one = _mm256_set1_ps(1.0f);
  __m256i at = _mm256_setzero_si256();
  __m256 t[3], rest[3];
  for (std::size_t a = 0; a < 3; ++a) {
    const float most = static_cast<float>(wide[a] - 1) - 0.001f;
    const __m256i along = _mm256_mullo_epi32(lanes, _mm256_set1_epi32(places.step[a]));
    const __m256i units = _mm256_add_epi32(_mm256_set1_epi32(places.start[a]), along);
    const __m256 place = _mm256_add_ps(_mm256_mul_ps(_mm256_cvtepi32_ps(units), perUnit),
                                       _mm256_set1_ps(places.offset[a]));
    const __m256 inside =
        _mm256_min_ps(_mm256_max_ps(place, _mm256_setzero_ps()), _mm256_set1_ps(most));
    const __m256i corner = _mm256_cvttps_epi32(inside);
    t[a] = _mm256_sub_ps(inside, _mm256_cvtepi32_ps(corner));
    rest[a] = _mm256_sub_ps(one, t[a]);
    at = _mm256_add_epi32(at, _mm256_mullo_epi32(corner, _mm256_set1_epi32(stride[a])));
  }
  alignas(32) std::int32_t cells[8];
  _mm256_store_si256(reinterpret_cast<__m256i*>(cells), at);
  const __m256 nearest = squareAvx2(squaresAvx2(grid, cells, stride[1]), t, rest);
  const __m256 farthest = squareAvx2(squaresAvx2(grid + stride[0], cells, stride[1]), t, rest);
  _mm256_storeu_ps(
      result, _mm256_mul_ps(mixed(nearest, farthest, t[0], rest[0]), _mm256_set1_ps(places.scale)));
}
#endif

void rowOf(const float* grid, const std::array<int, 3>& wide, const GridRow& places,
           float* result) {
#if defined(__x86_64__)
  if (hasAvx2()) return rowAvx2(grid, wide, places, result);
#endif
  rowKernel(grid, wide, places, result);
}

}  // namespace

void readRow(const float* grid, const std::array<int, 3>& wide, const GridRow& places, int count,
             float* result) {
  if (count == 8) return rowOf(grid, wide, places, result);
  float all[8];
  rowOf(grid, wide, places, all);
  std::copy_n(all, count, result);
}

}  // namespace bozzetto
