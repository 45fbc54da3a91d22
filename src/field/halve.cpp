#include "field/halve.hpp"

#include <cstring>

#include "bozzetto/base/simd.hpp"

namespace bozzetto {
namespace {

constexpr int kSide = 8;
constexpr int kWide = 2 * kSide + 4;  // fine corners −2 … 17
constexpr int kRow = 24;              // padded

// One axis: `planes` of `length` floats, plane p of the result from planes 2p … 2p+5. Symmetric
// pairs, so that equal values sum without rounding.
BOZZETTO_KERNEL void filter(const float* in, int stride, int length, float* out) {
  for (int p = 0; p < kSide; ++p) {
    const float* a = in + 2 * p * stride;
    float* to = out + p * length;
    for (int n = 0; n < length; ++n) {
      const float outer = a[n] + a[n + 5 * stride];
      const float middle = a[n + stride] + a[n + 4 * stride];
      const float inner = a[n + 2 * stride] + a[n + 3 * stride];
      to[n] = ((outer + middle) + 2.0f * inner) * 0.125f;
    }
  }
}

BOZZETTO_KERNEL void filterAll(const float* in, float* out) {
  alignas(64) float alongI[kSide * kWide * kRow];
  alignas(64) float alongJ[kSide * kRow];
  filter(in, kWide * kRow, kWide * kRow, alongI);
  for (int i = 0; i < kSide; ++i) {
    filter(alongI + i * kWide * kRow, kRow, kRow, alongJ);
    for (int j = 0; j < kSide; ++j) filter(alongJ + j * kRow, 1, 1, out + (i * kSide + j) * kSide);
  }
}

BOZZETTO_SIMD_DISPATCH(void, filterBlock, filterAll, (const float* in, float* out), (in, out))

alignas(64) constexpr float kZeros[kSide * kSide * kSide] = {};

// Fine corner −2 + n along an axis lies in block (n + 6) / 8 at (n + 6) % 8.
void gather(const std::array<const float*, 64>& blocks, float* out) {
  std::array<const float*, 64> from;
  for (int n = 0; n < 64; ++n) from[n] = blocks[n] != nullptr ? blocks[n] : kZeros;
  for (int i = 0; i < kWide; ++i) {
    for (int j = 0; j < kWide; ++j) {
      const float* const* column = &from[(i + 6) / kSide * 16 + (j + 6) / kSide * 4];
      const int row = ((i + 6) % kSide * kSide + (j + 6) % kSide) * kSide;
      float* to = out + (i * kWide + j) * kRow;
      std::memcpy(to, column[0] + row + kSide - 2, 2 * sizeof(float));
      std::memcpy(to + 2, column[1] + row, kSide * sizeof(float));
      std::memcpy(to + 2 + kSide, column[2] + row, kSide * sizeof(float));
      std::memcpy(to + 2 + 2 * kSide, column[3] + row, 2 * sizeof(float));
      std::memset(to + kWide, 0, (kRow - kWide) * sizeof(float));
    }
  }
}

}  // namespace

void halve(const std::array<const float*, 64>& blocks, std::array<float, 512>& out) {
  alignas(64) float fine[kWide * kWide * kRow];
  gather(blocks, fine);
  filterBlock(fine, out.data());
}

}  // namespace bozzetto
