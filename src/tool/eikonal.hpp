// Distances from a surface whose neighbours know theirs, all over a grid.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

namespace bozzetto {

inline constexpr float kFarAway = 1e9f;

/// Solves |∇d| = 1 upwind by fast sweeping (Zhao 2005, "A fast sweeping method for Eikonal
/// equations"): `orders` sweeps of the eight orders in turn, fewer when eight in a row changed
/// nothing. `distance` ≥ 0, kFarAway where nothing is known, k fastest; `fixed` ones stay. The same
/// bits on any number of threads.
void sweepDistances(const std::array<int, 3>& wide, const std::vector<std::uint8_t>& fixed,
                    int orders, std::vector<float>& distance);

}  // namespace bozzetto
