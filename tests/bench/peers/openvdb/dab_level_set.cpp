// The bar for our brush kernel: the fastest level-set dab that could be written by hand.
#ifdef __AVX2__
#include <immintrin.h>
#endif

#include <cmath>

#include "cases.hpp"
#include "leaves.hpp"

namespace bozzetto::peer {
namespace {

// Writes a row of 8 voxels, `across2` from the brush's centre in x and y and `z` in z; returns
// which of them are in the narrow band.
#ifdef __AVX2__
template <Change kChange>
unsigned writeRow(float* row, float across2, float z, float radius) {
  const __m256 steps = _mm256_setr_ps(0, 1, 2, 3, 4, 5, 6, 7);
  const __m256 dz = _mm256_add_ps(_mm256_set1_ps(z), steps);
  const __m256 length =
      _mm256_sqrt_ps(_mm256_add_ps(_mm256_set1_ps(across2), _mm256_mul_ps(dz, dz)));
  const __m256 old = _mm256_loadu_ps(row), r = _mm256_set1_ps(radius);
  const __m256 high = _mm256_set1_ps(kHalfWidth), low = _mm256_set1_ps(-kHalfWidth);
  __m256 value = kChange == Change::add ? _mm256_min_ps(old, _mm256_sub_ps(length, r))
                                        : _mm256_max_ps(old, _mm256_sub_ps(r, length));
  value = _mm256_max_ps(low, _mm256_min_ps(high, value));
  _mm256_storeu_ps(row, value);
  const __m256 band =
      _mm256_and_ps(_mm256_cmp_ps(value, high, _CMP_LT_OQ), _mm256_cmp_ps(value, low, _CMP_GT_OQ));
  return static_cast<unsigned>(_mm256_movemask_ps(band));
}
#else
template <Change kChange>
unsigned writeRow(float* row, float across2, float z, float radius) {
  unsigned band = 0;
  for (int k = 0; k < 8; ++k) {
    const float dz = z + static_cast<float>(k);
    const float distance = std::sqrt(across2 + dz * dz) - radius;
    const float value =
        kChange == Change::add ? std::min(row[k], distance) : std::max(row[k], -distance);
    row[k] = std::clamp(value, -kHalfWidth, kHalfWidth);
    band |= unsigned{std::fabs(row[k]) < kHalfWidth} << k;
  }
  return band;
}
#endif

template <Change kChange>
void writeLeaf(Leaf& leaf, const openvdb::Vec3f& offset, float radius) {
  float* values = leaf.buffer().data();
  auto mask = leaf.getValueMask();
  for (int x = 0; x < 8; ++x) {
    std::uint64_t word = 0;
    for (int y = 0; y < 8; ++y) {
      const float dx = offset.x() + static_cast<float>(x), dy = offset.y() + static_cast<float>(y);
      float* row = values + x * 64 + y * 8;
      // One rounding, or the compiler chooses anew wherever this is inlined.
      const float across2 = std::fma(dx, dx, dy * dy);
      const unsigned band = writeRow<kChange>(row, across2, offset.z(), radius);
      word |= std::uint64_t{band} << (y * 8);
    }
    mask.getWord<std::uint64_t>(static_cast<openvdb::Index>(x)) = word;
  }
  leaf.setValueMask(mask);
}

template <Change kChange>
void dab(FloatGrid& grid, const Brush& brush) {
  static std::vector<Leaf*> leaves;
  const float saturated = kChange == Change::add ? -kHalfWidth : kHalfWidth;
  listLeaves(grid, brush, {brush.radius + kHalfWidth, brush.radius - kHalfWidth, saturated, false},
             leaves);
  const float radius = static_cast<float>(brush.radius);
  forEachLeaf(leaves, brush, [&](Leaf& leaf, const openvdb::Vec3f& offset) {
    writeLeaf<kChange>(leaf, offset, radius);
  });
}

}  // namespace

void dabLevelSet(FloatGrid& grid, const Brush& brush, Change change) {
  change == Change::add ? dab<Change::add>(grid, brush) : dab<Change::remove>(grid, brush);
}

}  // namespace bozzetto::peer
