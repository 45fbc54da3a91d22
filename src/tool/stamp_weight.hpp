// Where a stamp's bulge may rise, and how: from clay, never in the air (algorithms.md §1).
#pragma once
#include "bozzetto/tool/action.hpp"
#include "tool/corner_loop.hpp"

namespace bozzetto {

// A bulge of density n lifts clay whose density falls by ½ a cell, as fills leave it, by n / ½
// cells. That way is what counts, however steep the clay has become: density added as such would
// catch on the cells, and rims of many dabs had terraces.
inline constexpr float kClimbPerDensity = 2.0f;
inline constexpr float kFarthestClimb = 0.577f;  // cells: beyond 1/√3 corners outgrow neighbours
inline constexpr float kThinnestClay = 1e-4f;    // support that would grow a cell a dab

/// smoothstep of (low-passed density) ÷ iso: 0 in air, 1 from iso up.
BOZZETTO_KERNEL float riseWeight(float overIso) {
  const float t = lesser(overIso, 1.0f);
  return (t * t) * (3.0f - 2.0f * t);
}

/// The colour of the clay round a corner that has none of its own.
BOZZETTO_KERNEL Attributes colourAt(const Lowpass& lowpass, int n) {
  if (lowpass.premultiplied[0] == nullptr) return lowpass.onlyColour;
  const float weight = greater(lowpass.value[n], 1e-20f);
  Attributes mixed = 0;
  for (int c = 0; c < 3; ++c)
    mixed |= static_cast<Attributes>(nearest(lowpass.premultiplied[c][n] / weight) & 255) << 8 * c;
  return mixed;
}

}  // namespace bozzetto
