// Where a stamp's bulge may rise: from clay, never in the air (algorithms.md §1).
#pragma once
#include "bozzetto/tool/action.hpp"
#include "tool/corner_loop.hpp"

namespace bozzetto {

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
