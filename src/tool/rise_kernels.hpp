// What conserving stamps do to many corners at once.
#pragma once
#include <cstddef>

#include "tool/stamp_weight.hpp"

namespace bozzetto {

/// A corner that has risen so far, in cells.
BOZZETTO_KERNEL float risen(float value, float climb, float most, float way) {
  return lesser(value + way * climb, most);
}

/// Corners that may rise, `climb` density a cell of way, to `most`.
struct Climbers {
  const float *value, *climb, *most;
  std::size_t count;
};

/// Their mass when they have risen so far.
MassUnits risenSum(const Climbers& all, float way);

/// The corners of a block as they may rise: what they are, how far they go and how much of a bulge
/// is there.
struct Room {
  const float *value, *most, *curve;
  const Attributes* held;
  float strength;
};

/// How fast each rises where the clay climbs so; 0 where it cannot.
void ratesOf(const Room& room, int count, float* climb);

}  // namespace bozzetto
