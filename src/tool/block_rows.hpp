// The walk inside a block (Ferley §3.2): the local position of every corner by one expression,
// given to a functor of |x|, |y|, |z|, row by row.
#pragma once
#include <cmath>

#include "bozzetto/base/simd.hpp"
#include "bozzetto/tool/potential.hpp"

namespace bozzetto {

struct Patch {
  const LocalFrame& frame;
  Key first;  // corner, counted from the frame's cell
};

// `Side` is a constant so that a row of 8 becomes one vector.
template <int Side, class Rule>
BOZZETTO_KERNEL void forRowsBody(const Patch& patch, const Rule& rule, float* result) {
  const auto& first = patch.frame.first;
  const auto& step = patch.frame.step;
  float along[3][Side];
  for (int axis = 0; axis < 3; ++axis)
    for (int k = 0; k < Side; ++k)
      along[axis][k] = static_cast<float>(patch.first.k + k) * step[2][axis];
  for (int i = 0; i < Side; ++i) {
    for (int j = 0; j < Side; ++j) {
      float base[3];
      for (int axis = 0; axis < 3; ++axis) {
        base[axis] = (first[axis] + static_cast<float>(patch.first.i + i) * step[0][axis]) +
                     static_cast<float>(patch.first.j + j) * step[1][axis];
      }
      for (int k = 0; k < Side; ++k) {
        result[(i * Side + j) * Side + k] =
            rule(std::abs(base[0] + along[0][k]), std::abs(base[1] + along[1][k]),
                 std::abs(base[2] + along[2][k]));
      }
    }
  }
}

template <int Side, class Rule>
BOZZETTO_TARGET_AVX2 void forRowsAvx2(const Patch& patch, const Rule& rule, float* result) {
  forRowsBody<Side>(patch, rule, result);
}

template <int Side, class Rule>
void forRowsPlain(const Patch& patch, const Rule& rule, float* result) {
  forRowsBody<Side>(patch, rule, result);
}

template <class Rule>
void forRows(const Patch& patch, int side, const Rule& rule, float* result) {
  if (side == 1) return forRowsPlain<1>(patch, rule, result);
  return hasAvx2() ? forRowsAvx2<8>(patch, rule, result) : forRowsPlain<8>(patch, rule, result);
}

}  // namespace bozzetto
