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

enum class Turn { aligned, free };  // aligned: along k only the tool's z varies

// `Side` is a constant so that a row of 8 becomes one vector. Aligned tools give the same bits
// either way: they leave out sums with 0.
template <int Side, Turn kTurn, class Rule>
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
        const float x = kTurn == Turn::aligned ? base[0] : base[0] + along[0][k];
        const float y = kTurn == Turn::aligned ? base[1] : base[1] + along[1][k];
        const float z = base[2] + along[2][k];
        result[(i * Side + j) * Side + k] = rule(std::abs(x), std::abs(y), std::abs(z));
      }
    }
  }
}

template <int Side, Turn kTurn, class Rule>
BOZZETTO_TARGET_AVX2 void forRowsAvx2(const Patch& patch, const Rule& rule, float* result) {
  forRowsBody<Side, kTurn>(patch, rule, result);
}

template <int Side, Turn kTurn, class Rule>
void forRowsPlain(const Patch& patch, const Rule& rule, float* result) {
  forRowsBody<Side, kTurn>(patch, rule, result);
}

template <Turn kTurn, class Rule>
void forRowsTurned(const Patch& patch, int side, const Rule& rule, float* result) {
  if (side == 1) return forRowsPlain<1, kTurn>(patch, rule, result);
  hasAvx2() ? forRowsAvx2<8, kTurn>(patch, rule, result)
            : forRowsPlain<8, kTurn>(patch, rule, result);
}

template <class Rule>
void forRows(const Patch& patch, int side, const Rule& rule, float* result) {
  const auto& alongK = patch.frame.step[2];
  const bool aligned = alongK[0] == 0 && alongK[1] == 0;
  aligned ? forRowsTurned<Turn::aligned>(patch, side, rule, result)
          : forRowsTurned<Turn::free>(patch, side, rule, result);
}

}  // namespace bozzetto
