// Clay that is divided by a wall: what is taken and what stays are together what there was.
#pragma once
#include "bozzetto/base/simd.hpp"

namespace bozzetto {

/// Of clay of this density, what stays where a share of it is taken. What is taken is value − rest,
/// and that is exact: the smaller of the two is a difference of numbers within a factor of two.
BOZZETTO_KERNEL float restOf(float value, float share) {
  return share >= 0.5f ? value - value * share : value * (1.0f - share);
}

}  // namespace bozzetto
