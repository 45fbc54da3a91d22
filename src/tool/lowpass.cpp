#include "tool/lowpass.hpp"

#include <algorithm>

#include "tool/block_work.hpp"
#include "tool/float_bits.hpp"

namespace bozzetto {
namespace {

// The block with a rim of one corner all round.
template <int Side>
struct Tile {
  static constexpr int kWide = Side + 2;
  static constexpr int kCount = kWide * kWide * kWide;
  alignas(64) float value[kCount];
  Attributes attributes[kCount];
};

template <int Side>
void gatherRow(const Neighbourhood<Side>& blocks, int i, int j, Tile<Side>& tile) {
  constexpr int wide = Tile<Side>::kWide;
  const int bi = i == 0 ? 0 : i > Side ? 2 : 1, bj = j == 0 ? 0 : j > Side ? 2 : 1;
  const int row = (((i - 1) & (Side - 1)) * Side + ((j - 1) & (Side - 1))) * Side;
  float* value = tile.value + (i * wide + j) * wide;
  Attributes* attributes = tile.attributes + (i * wide + j) * wide;
  const auto take = [&]<int kCount>(int bk, int from, int to) {
    const CornerBlock<Side>* near = blocks[(bi * 3 + bj) * 3 + bk];
    const CornerBlock<Side>& block = near == nullptr ? emptyBlock<Side>() : *near;
    std::copy_n(block.value.data() + row + from, kCount, value + to);
    std::copy_n(block.attributes.data() + row + from, kCount, attributes + to);
  };
  take.template operator()<1>(0, Side - 1, 0);
  take.template operator()<Side>(1, 0, 1);
  take.template operator()<1>(2, 0, Side + 1);
}

// The values of the block and of what lies across its faces; edges stay as they are.
template <int Side>
BOZZETTO_KERNEL void gatherFaces(const std::array<const float*, 7>& from, float* tile) {
  constexpr int wide = Side + 2, last = Side - 1;
  const auto row = [&](const float* block, int i, int j) { return block + (i * Side + j) * Side; };
  const auto to = [&](int i, int j) { return tile + ((i + 1) * wide + j + 1) * wide + 1; };
  for (int i = 0; i < Side; ++i) {
    std::copy_n(row(from[1], last, i), Side, to(-1, i));
    std::copy_n(row(from[2], 0, i), Side, to(Side, i));
    std::copy_n(row(from[3], i, last), Side, to(i, -1));
    std::copy_n(row(from[4], i, 0), Side, to(i, Side));
    for (int j = 0; j < Side; ++j) {
      float* const out = to(i, j);
      out[-1] = row(from[5], i, j)[last];
      std::copy_n(row(from[0], i, j), Side, out);
      out[Side] = row(from[6], i, j)[0];
    }
  }
}

// (1 2 1) along k, j and i in turn; always in this order, so that all sides agree to the bit.
template <int Side>
BOZZETTO_KERNEL void binomialBody(const float* in, float* out) {
  constexpr int wide = Side + 2;
  alignas(64) float alongK[wide * wide * Side], alongJ[wide * Side * Side];
  for (int row = 0; row < wide * wide; ++row)
    for (int k = 0; k < Side; ++k) {
      const float* at = in + row * wide + k;
      alongK[row * Side + k] = (at[0] + at[2]) + 2.0f * at[1];
    }
  constexpr int line = Side, plane = Side * Side;
  for (int i = 0; i < wide; ++i)
    for (int n = 0; n < plane; ++n) {
      const float* at = alongK + i * wide * line + n;
      alongJ[i * plane + n] = (at[0] + at[2 * line]) + 2.0f * at[line];
    }
  for (int n = 0; n < Side * plane; ++n) {
    const float* at = alongJ + n;
    out[n] = ((at[0] + at[2 * plane]) + 2.0f * at[plane]) * (1.0f / 64.0f);
  }
}

// How steeply the clay climbs from a corner to its neighbours, in density a cell (Godunov's
// upwind gradient: Osher and Sethian 1988).
template <int Side>
BOZZETTO_KERNEL void climbBody(const float* in, float* out) {
  constexpr int wide = Side + 2;
  for (int i = 0; i < Side; ++i)
    for (int j = 0; j < Side; ++j)
      for (int k = 0; k < Side; ++k) {
        const float* at = in + ((i + 1) * wide + j + 1) * wide + k + 1;
        const float x = positive(greater(at[wide * wide], at[-wide * wide]) - at[0]);
        const float y = positive(greater(at[wide], at[-wide]) - at[0]);
        const float z = positive(greater(at[1], at[-1]) - at[0]);
        out[(i * Side + j) * Side + k] = std::sqrt((x * x + y * y) + z * z);
      }
}

struct Colours {
  Attributes any = 0, every = 0xffffff;
  bool single() const { return any == 0 || any == every; }
};

// Which colour bits occur among corners with clay.
BOZZETTO_KERNEL Colours coloursBody(const float* value, const Attributes* attributes, int count) {
  Attributes any = 0, every = 0xffffff;
  for (int n = 0; n < count; ++n) {
    const Attributes colour = attributes[n] & 0xffffff;
    const auto clay = static_cast<Attributes>(positiveMask(value[n]));
    any |= colour & clay;
    every &= colour | ~clay;
  }
  return {any, every};
}

BOZZETTO_KERNEL void premultiplyBody(const float* value, const Attributes* attributes, int shift,
                                     int count, float* out) {
  for (int n = 0; n < count; ++n)
    out[n] = value[n] * static_cast<float>(static_cast<int>(attributes[n] >> shift & 255));
}

template <int Side>
BOZZETTO_KERNEL void lowpassBody(const Tile<Side>& tile, LowpassBuffer<Side>& buffer) {
  constexpr int count = Tile<Side>::kCount;
  binomialBody<Side>(tile.value, buffer.arrays[0].data());
  buffer.result = {buffer.arrays[0].data(), {nullptr, nullptr, nullptr}, 0};
  climbBody<Side>(tile.value, buffer.arrays[4].data());
  buffer.result.climb = buffer.arrays[4].data();
  const Colours colours = coloursBody(tile.value, tile.attributes, count);
  buffer.result.onlyColour = colours.any;
  if (colours.single()) return;
  for (int channel = 0; channel < 3; ++channel) {
    alignas(64) float premultiplied[count];
    premultiplyBody(tile.value, tile.attributes, 8 * channel, count, premultiplied);
    binomialBody<Side>(premultiplied, buffer.arrays[1 + channel].data());
    buffer.result.premultiplied[channel] = buffer.arrays[1 + channel].data();
  }
}

template <int Side>
BOZZETTO_TARGET_AVX2 void lowpassAvx2(const Tile<Side>& tile, LowpassBuffer<Side>& buffer) {
  lowpassBody<Side>(tile, buffer);
}

template <int Side>
void lowpassPlain(const Tile<Side>& tile, LowpassBuffer<Side>& buffer) {
  lowpassBody<Side>(tile, buffer);
}

template <int Side>
BOZZETTO_KERNEL bool climbOfBody(const std::array<const float*, 7>& from, float* climb) {
  alignas(64) float tile[Tile<Side>::kCount];
  gatherFaces<Side>(from, tile);
  climbBody<Side>(tile, climb);
  std::int32_t any = 0;
  for (int n = 0; n < Side * Side * Side; ++n) any |= bits(climb[n]);
  return any != 0;
}

template <int Side>
BOZZETTO_TARGET_AVX2 bool climbOfAvx2(const std::array<const float*, 7>& from, float* climb) {
  return climbOfBody<Side>(from, climb);
}

template <int Side>
bool climbOfPlain(const std::array<const float*, 7>& from, float* climb) {
  return climbOfBody<Side>(from, climb);
}

}  // namespace

template <int Side>
bool climbOf(const Faces<Side>& blocks, float* climb) {
  std::array<const float*, 7> from;
  for (std::size_t n = 0; n < from.size(); ++n)
    from[n] = (blocks[n] == nullptr ? emptyBlock<Side>() : *blocks[n]).value.data();
  return hasAvx2() ? climbOfAvx2<Side>(from, climb) : climbOfPlain<Side>(from, climb);
}

template <int Side>
void lowpass(const Neighbourhood<Side>& blocks, LowpassBuffer<Side>& buffer) {
  Tile<Side> tile;
  for (int i = 0; i < Side + 2; ++i)
    for (int j = 0; j < Side + 2; ++j) gatherRow<Side>(blocks, i, j, tile);
  hasAvx2() ? lowpassAvx2<Side>(tile, buffer) : lowpassPlain<Side>(tile, buffer);
}

template bool climbOf<1>(const Faces<1>&, float*);
template bool climbOf<8>(const Faces<8>&, float*);
template void lowpass<1>(const Neighbourhood<1>&, LowpassBuffer<1>&);
template void lowpass<8>(const Neighbourhood<8>&, LowpassBuffer<8>&);

}  // namespace bozzetto
