// Sets of block keys as sorted runs along k: what changed, and what that touches.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "bozzetto/grid/delta.hpp"

namespace bozzetto {

/// How far a changed run is felt along each axis.
enum class Reach : std::uint8_t { none = 0, below = 1, above = 2, both = 3 };

constexpr bool reachesBelow(Reach r) { return (static_cast<int>(r) & 1) != 0; }
constexpr bool reachesAbove(Reach r) { return (static_cast<int>(r) & 2) != 0; }

struct TouchedRun {
  KeyRun run;
  std::array<Reach, 3> reach{Reach::both, Reach::both, Reach::both};
};

/// Joins neighbours along k of equal reach. Sorted in, sorted out.
std::vector<TouchedRun> joined(std::vector<TouchedRun> touched);

/// All keys at offsets -below…above (as far as each run reaches) from the touched ones, as sorted
/// runs that neither overlap nor touch. O(runs · (below + above + 1)²).
std::vector<KeyRun> dilated(const std::vector<TouchedRun>& touched, int below, int above);

}  // namespace bozzetto
