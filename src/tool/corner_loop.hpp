// The loop every action shares: a corner's new value and attributes from its old ones, and what
// that makes of the block. One functor an action; compiled plain and for AVX2.
#pragma once
#include <bit>

#include "bozzetto/base/simd.hpp"
#include "bozzetto/tool/action.hpp"

#if defined(__clang__)
#define BOZZETTO_INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#else
#define BOZZETTO_INDEPENDENT _Pragma("GCC ivdep")
#endif

namespace bozzetto {

inline constexpr Attributes kColourBits = 0xffffff, kHoldBits = 0xff000000;
inline constexpr int kHardHold = 128;  // hard actions act below it

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

// The colour moved toward the tool's by the fraction t, at least one step where `moves` is set.
BOZZETTO_KERNEL Attributes blended(Attributes attributes, Attributes tool, float t, bool moves) {
  Attributes result = attributes & kHoldBits;
  for (int shift = 0; shift < 24; shift += 8) {
    const int channel = static_cast<int>(attributes >> shift & 255);
    const int way = static_cast<int>(tool >> shift & 255) - channel;
    const int step = nearest(t * static_cast<float>(way));
    const int least = moves ? (way > 0) - (way < 0) : 0;
    result |= static_cast<Attributes>(channel + (step == 0 ? least : step)) << shift;
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
  float low = 1e30f, high = -1e30f;
  Attributes every = ~Attributes{0}, any = 0;
  int dirty = 0;
  BOZZETTO_INDEPENDENT
  for (int n = 0; n < count; ++n) {
    const Corner old{value[n], attributes[n]};
    Corner made = corner(old, n);
    made.attributes = made.value > 0 ? made.attributes : 0;
    newValue[n] = made.value;
    newAttributes[n] = made.attributes;
    dirty += (made.value != old.value) | (made.attributes != old.attributes);
    low = made.value < low ? made.value : low;
    high = made.value > high ? made.value : high;
    every &= made.attributes;
    any |= made.attributes;
  }
  return {dirty, low, high, low == high && every == any, 0};
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
