// The loop every action shares: a corner's new value and attributes from its old ones, and what
// that makes of the block. One functor an action; compiled plain and for AVX2.
#pragma once
#include <algorithm>
#include <bit>

#include "bozzetto/tool/action.hpp"
#include "tool/float_bits.hpp"

#if defined(__clang__)
#define BOZZETTO_INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#else
#define BOZZETTO_INDEPENDENT _Pragma("GCC ivdep")
#endif

namespace bozzetto {

inline constexpr Attributes kColourBits = 0xffffff, kHoldBits = 0xff000000;

/// The same colour, whatever the hold.
inline bool sameColour(Attributes a, Attributes b) { return ((a ^ b) & kColourBits) == 0; }

// All bits where hard actions act: hold < 128.
BOZZETTO_KERNEL std::int32_t yieldMask(Attributes attributes) {
  return ~signMask(static_cast<std::int32_t>(attributes));
}
inline constexpr int kHardHold = 128;

struct Corner {
  float value;
  Attributes attributes;
};

// s·p of a corner, scaled by what its hold leaves free: exactly s·p at 0, exactly 0 at 255.
BOZZETTO_KERNEL float pull(float strength, float potential, Attributes attributes) {
  const float held = static_cast<float>(static_cast<int>(attributes >> 24)) * (1.0f / 255.0f);
  return (strength * potential) * (1.0f - held);
}

BOZZETTO_KERNEL int nearest(float x) {  // |x| < 2²²; ties to even
  return std::bit_cast<int>(x + 12582912.0f) - std::bit_cast<int>(12582912.0f);
}

// The colour moved toward the tool's by the fraction t, at least one step where the mask `moves` is
// set.
BOZZETTO_KERNEL Attributes blended(Attributes attributes, Attributes tool, float t, int moves) {
  Attributes result = attributes & kHoldBits;
  for (int shift = 0; shift < 24; shift += 8) {
    const int channel = static_cast<int>(attributes >> shift & 255);
    const int way = static_cast<int>(tool >> shift & 255) - channel;
    const int step = nearest(t * static_cast<float>(way));
    const int least = (signMask(way) - signMask(0 - way)) & moves;
    const int stands = ~signMask(step | (0 - step));
    result |= static_cast<Attributes>(channel + pick(stands, least, step)) << shift;
  }
  return result;
}

// `corner(old, n)` gives the new corner n. Corners without clay lose their attributes.
template <class Rule>
BOZZETTO_KERNEL Outcome forCorners(const BlockView& block, const Rule& corner) {
  const int count = block.count;
  const float* value = block.value;
  const Attributes* attributes = block.attributes;
  float* newValue = block.newValue;
  Attributes* newAttributes = block.newAttributes;
  std::int32_t low = bits(1e30f), high = 0;
  Attributes every = ~Attributes{0}, any = 0;
  int dirty = 0;
  BOZZETTO_INDEPENDENT
  for (int n = 0; n < count; ++n) {
    const Corner old{value[n], attributes[n]};
    Corner made = corner(old, n);
    made.attributes &= static_cast<Attributes>(positiveMask(made.value));
    newValue[n] = made.value;
    newAttributes[n] = made.attributes;
    const auto changed = static_cast<Attributes>(bits(made.value) ^ bits(old.value));
    const Attributes differs = changed | (made.attributes ^ old.attributes);
    dirty += static_cast<int>((differs | (0 - differs)) >> 31);
    low = std::min(low, bits(made.value));
    high = std::max(high, bits(made.value));
    every &= made.attributes;
    any |= made.attributes;
  }
  return {dirty, real(low), real(high), low == high && every == any, 0};
}

template <class Rule>
BOZZETTO_TARGET_AVX2 Outcome runAvx2(const BlockView& block, const Rule& rule) {
  return forCorners(block, rule);
}

template <class Rule>
Outcome runPlain(const BlockView& block, const Rule& rule) {
  return forCorners(block, rule);
}

template <class Rule>
Outcome run(const BlockView& block, const Rule& rule) {
  return hasAvx2() ? runAvx2(block, rule) : runPlain(block, rule);
}

/// Some corner with clay that the tool covers has another colour than `tool`.
bool meetsOtherColour(const BlockView& block, Attributes tool);

}  // namespace bozzetto
