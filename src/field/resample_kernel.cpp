#include "field/resample_kernel.hpp"

#include <algorithm>
#include <cmath>

#include "bozzetto/base/simd.hpp"

namespace bozzetto {
namespace {

using Block = CornerBlock<8>;

constexpr int kSide = 8;
constexpr int kWide = 20;  // the longest span

double reach(double ratio) { return std::max(1.0, ratio); }

// The first old corner strictly within reach of x.
std::int32_t firstTap(double x, double ratio) {
  return static_cast<std::int32_t>(std::floor(x - reach(ratio))) + 1;
}

// Tent weights about x, made to sum to 1 and to have their mean at x.
std::array<double, AxisTaps::kMost> tent(double x, std::int32_t first, int taps, double half) {
  std::array<double, AxisTaps::kMost> weight{};
  double sum = 0, moment = 0, spread = 0;
  for (int t = 0; t < taps; ++t) {
    const double off = first + t - x;
    weight[t] = std::max(0.0, 1.0 - std::abs(off) / half);
    moment += weight[t] * off;
    spread += weight[t] * off * off;
  }
  const double bend = spread > 0 ? -moment / spread : 0;
  for (int t = 0; t < taps; ++t) {
    weight[t] *= std::max(0.0, 1.0 + bend * (first + t - x));
    sum += weight[t];
  }
  for (int t = 0; t < taps; ++t) weight[t] /= sum;
  return weight;
}

// The old corners a block needs: values and attributes in a box of the taps' spans.
struct Box {
  std::array<int, 3> span;
  alignas(64) double value[kWide * kWide * kWide];
  Attributes attributes[kWide * kWide * kWide];
  float high = 0;
  Attributes colour = 0;  // of the first corner with clay, hold apart
  bool oneColour = true;

  std::size_t indexOf(int i, int j, int k) const {
    return (static_cast<std::size_t>(i) * span[1] + j) * span[2] + k;
  }
};

constexpr Attributes kColourBits = 0xffffff;

void noteCorner(Box& box, std::size_t at, float value, Attributes attributes) {
  box.value[at] = value;
  box.attributes[at] = attributes;
  if (!(value > 0)) return;
  if (box.high == 0) box.colour = attributes & kColourBits;
  box.oneColour &= (attributes & kColourBits) == box.colour;
  box.high = std::max(box.high, value);
}

void gather(const SourceBlocks& sources, const std::array<const AxisTaps*, 3>& taps, Box& box) {
  std::array<int, 3> in;
  for (int a = 0; a < 3; ++a) {
    box.span[a] = taps[a]->span;
    in[a] = taps[a]->low & (kSide - 1);
  }
  for (int i = 0; i < box.span[0]; ++i) {
    for (int j = 0; j < box.span[1]; ++j) {
      const int oi = i + in[0], oj = j + in[1];
      for (int k = 0; k < box.span[2]; ++k) {
        const int ok = k + in[2];
        const Block* block = sources[(oi / kSide * 4 + oj / kSide) * 4 + ok / kSide];
        const int at = (oi % kSide * kSide + oj % kSide) * kSide + ok % kSide;
        noteCorner(box, box.indexOf(i, j, k), block ? block->value[at] : 0.0f,
                   block ? block->attributes[at] : 0);
      }
    }
  }
}

// Weighted sums along one axis: `groups` times, 8 rows of `length` numbers from `span` rows.
BOZZETTO_KERNEL void sumAlong(const AxisTaps& taps, int groups, int length, const double* in,
                              double* out) {
  for (int g = 0; g < groups; ++g) {
    for (int n = 0; n < kSide; ++n) {
      const double* from = in + (g * taps.span + taps.first[n]) * length;
      double* to = out + (g * kSide + n) * length;
      for (int m = 0; m < length; ++m) to[m] = taps.weight[n][0] * from[m];
      for (int t = 1; t < taps.taps; ++t) {
        for (int m = 0; m < length; ++m) to[m] += taps.weight[n][t] * from[t * length + m];
      }
    }
  }
}

struct Filter {
  const std::array<const AxisTaps*, 3>& taps;
};

BOZZETTO_KERNEL void filterBox(const Filter& filter, const double* in, double* out) {
  double first[kSide * kWide * kWide];
  double second[kSide * kSide * kWide];
  const auto& taps = filter.taps;
  sumAlong(*taps[0], 1, taps[1]->span * taps[2]->span, in, first);
  sumAlong(*taps[1], kSide, taps[2]->span, first, second);
  sumAlong(*taps[2], kSide * kSide, 1, second, out);
}

BOZZETTO_SIMD_DISPATCH(void, filtered, filterBox,
                       (const Filter& filter, const double* in, double* out), (filter, in, out))

// Sums of one colour channel times density.
void filterChannel(const Filter& filter, const Box& box, int shift, double* out) {
  double weighted[kWide * kWide * kWide];
  const std::size_t count = box.indexOf(box.span[0], 0, 0);
  for (std::size_t n = 0; n < count; ++n) {
    weighted[n] = box.value[n] * static_cast<double>(box.attributes[n] >> shift & 0xff);
  }
  filtered(filter, weighted, out);
}

void addColours(const Filter& filter, const Box& box, const double* density, Block& block) {
  if (box.oneColour) {
    block.attributes.fill(box.colour);
    return;
  }
  double channel[Block::kCount];
  for (const int shift : {0, 8, 16}) {
    filterChannel(filter, box, shift, channel);
    for (int n = 0; n < Block::kCount; ++n) {
      if (!(density[n] > 0)) continue;
      const double mean = std::min(255.0, channel[n] / density[n]);
      block.attributes[n] |= static_cast<Attributes>(mean + 0.5) << shift;
    }
  }
}

void addHold(const Box& box, const std::array<const AxisTaps*, 3>& taps, Block& block) {
  for (int n = 0; n < Block::kCount; ++n) {
    const std::size_t at =
        box.indexOf(taps[0]->nearest[n / 64], taps[1]->nearest[n / 8 % 8], taps[2]->nearest[n % 8]);
    block.attributes[n] |= box.attributes[at] & ~kColourBits;
  }
}

// The interned block that fills all that is used, where one does; null where several or none do.
const Block* commonBlock(const SourceBlocks& sources, const std::array<const AxisTaps*, 3>& taps,
                         bool& common) {
  for (int i = 0; i < taps[0]->blocks(); ++i) {
    for (int j = 0; j < taps[1]->blocks(); ++j) {
      for (int k = 0; k < taps[2]->blocks(); ++k) {
        common &= sources[(i * 4 + j) * 4 + k] == sources[0];
      }
    }
  }
  common &= sources[0] == nullptr || sources[0]->interned;
  return sources[0];
}

}  // namespace

AxisTaps::AxisTaps(std::int32_t block, double ratio) {
  taps = ratio <= 1 ? 2 : ratio == 2 ? 3 : kMost;
  low = firstTap(block * kSide * ratio, ratio);
  for (int n = 0; n < kSide; ++n) {
    const double x = (block * double{kSide} + n) * ratio;
    const std::int32_t from = firstTap(x, ratio);
    first[n] = from - low;
    weight[n] = tent(x, from, taps, reach(ratio));
    nearest[n] = static_cast<std::int32_t>(std::floor(x + 0.5)) - low;
    span = first[n] + taps;
  }
}

std::int32_t firstSourceBlock(std::int32_t block, double ratio) {
  return firstTap(block * double{kSide} * ratio, ratio) >> 3;
}

Ref<CornerBlock<8>> resampleBlock(const SourceBlocks& sources,
                                  const std::array<const AxisTaps*, 3>& taps, float dropBelow) {
  bool common = true;
  const Block* filling = commonBlock(sources, taps, common);
  if (common && filling == nullptr) return nullptr;
  if (common) return Block::uniform(filling->value[0], filling->attributes[0]);
  static thread_local Box box;
  box.high = 0;
  box.oneColour = true;
  gather(sources, taps, box);
  if (box.high == 0) return nullptr;
  double density[Block::kCount];
  const Filter filter{taps};
  filtered(filter, box.value, density);
  Ref<Block> block(new Block());
  for (int n = 0; n < Block::kCount; ++n) {
    const float value = std::min(static_cast<float>(density[n]), box.high);
    block->value[n] = value >= dropBelow ? value : 0.0f;
  }
  addColours(filter, box, density, *block);
  addHold(box, taps, *block);
  return Block::canonical(std::move(block));
}

}  // namespace bozzetto
