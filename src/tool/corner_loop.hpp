// The loop every action shares: a corner's new value and attributes from its old ones, and what
// that makes of the block. One functor an action; compiled plain and for AVX2.
#pragma once
#include <algorithm>
#include <bit>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

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

inline constexpr int kMostCorners = 512;  // of a block

// The highest bits of up to 16 entries.
BOZZETTO_KERNEL std::uint32_t markBits(const Attributes* marks, int count) {
#if defined(__SSE2__)
  if (count >= 16) {
    const auto load = [&](int n) {
      return _mm_load_si128(reinterpret_cast<const __m128i*>(marks + 4 * n));
    };
    const __m128i low = _mm_packs_epi32(load(0), load(1)), high = _mm_packs_epi32(load(2), load(3));
    return static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_packs_epi16(low, high)));
  }
#endif
  std::uint32_t bits = 0;
  for (int n = 0; n < std::min(count, 16); ++n) bits |= (marks[n] >> 31) << n;
  return bits;
}

// Bit n of the corners: the highest bit of entry n.
BOZZETTO_KERNEL CornerBits cornerBits(const Attributes* marks, int count) {
  CornerBits bits{};
  for (int n = 0; n < count; n += 16)
    bits[n / 64] |= std::uint64_t{markBits(marks + n, count - n)} << n % 64;
  return bits;
}

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

// What a loop over corners gathers beside the corners themselves.
struct Gathered {
  std::int32_t low = bits(1e30f), high = 0;
  Attributes every = ~Attributes{0}, any = 0;  // of corners with clay
  int dirty = 0;
};

BOZZETTO_KERNEL Outcome outcomeOf(const Gathered& all, const Attributes* differs, int count) {
  Outcome outcome{all.dirty, real(all.low), real(all.high)};
  outcome.oneColour = all.every == all.any || all.high == 0;
  outcome.only = all.any;
  outcome.uniform = all.low == all.high && outcome.oneColour;
  outcome.settled = true;
  if (all.dirty != count || count < 64) outcome.corners = cornerBits(differs, count);
  return outcome;
}

// `corner(old, n)` gives the new corner n. Corners without clay lose their attributes.
template <class Rule>
BOZZETTO_KERNEL Outcome forCorners(const BlockView& block, const Rule& corner) {
  const int count = block.count;
  const float* value = block.value;
  const Attributes* attributes = block.attributes;
  float* newValue = block.newValue;
  Attributes* newAttributes = block.newAttributes;
  alignas(64) Attributes differs[kMostCorners];
  Gathered all;
  BOZZETTO_INDEPENDENT
  for (int n = 0; n < count; ++n) {
    const Corner old{value[n], attributes[n]};
    Corner made = corner(old, n);
    const auto clay = static_cast<Attributes>(positiveMask(made.value));
    made.attributes &= clay;
    newValue[n] = made.value;
    newAttributes[n] = made.attributes;
    const auto changed = static_cast<Attributes>(bits(made.value) ^ bits(old.value));
    const Attributes other = changed | (made.attributes ^ old.attributes);
    differs[n] = other | (0 - other);  // the highest bit
    all.dirty += static_cast<int>(differs[n] >> 31);
    all.low = std::min(all.low, bits(made.value));
    all.high = std::max(all.high, bits(made.value));
    all.every &= made.attributes | ~clay;
    all.any |= made.attributes;
  }
  return outcomeOf(all, differs, count);
}

// The same where all clay, old and new, has one colour: `value(old, n)` gives the new value.
// Attributes are not read, and written only where clay may have come or gone.
template <class Rule>
BOZZETTO_KERNEL Outcome forValues(const BlockView& block, const Rule& value, Attributes only) {
  const int count = block.count;
  const float* oldValue = block.value;
  float* newValue = block.newValue;
  alignas(64) Attributes differs[kMostCorners];
  Gathered all;
  BOZZETTO_INDEPENDENT
  for (int n = 0; n < count; ++n) {
    const float old = oldValue[n], made = value(old, n);
    newValue[n] = made;
    const auto other = static_cast<Attributes>(bits(made) ^ bits(old));
    differs[n] = other | (0 - other);
    all.dirty += static_cast<int>(differs[n] >> 31);
    all.low = std::min(all.low, bits(made));
    all.high = std::max(all.high, bits(made));
  }
  all.every = all.any = only;
  const bool kept = block.newAttributes == block.attributes && block.low > 0 && all.low > 0;
  if (!kept) {
    Attributes* newAttributes = block.newAttributes;
    BOZZETTO_INDEPENDENT
    for (int n = 0; n < count; ++n)
      newAttributes[n] = only & static_cast<Attributes>(positiveMask(newValue[n]));
  }
  return outcomeOf(all, differs, count);
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

template <class Rule>
BOZZETTO_TARGET_AVX2 Outcome runValuesAvx2(const BlockView& block, const Rule& rule,
                                           Attributes only) {
  return forValues(block, rule, only);
}

template <class Rule>
Outcome runValuesPlain(const BlockView& block, const Rule& rule, Attributes only) {
  return forValues(block, rule, only);
}

template <class Rule>
Outcome runValues(const BlockView& block, const Rule& rule, Attributes only) {
  return hasAvx2() ? runValuesAvx2(block, rule, only) : runValuesPlain(block, rule, only);
}

/// Some corner with clay that the tool covers has another colour than `tool`.
bool meetsOtherColour(const BlockView& block, Attributes tool);

}  // namespace bozzetto
