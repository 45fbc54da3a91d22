// A float in [0, 2048) as mass units, vectorisable: adding 1.5·2¹² leaves multiples of 2⁻⁴⁰ in the
// low bits of a double.
#pragma once
#include <bit>

#include "bozzetto/base/simd.hpp"
#include "bozzetto/field/corner_block.hpp"

namespace bozzetto {

BOZZETTO_KERNEL MassUnits massUnits(float value) {
  constexpr double shift = 0x1.8p12;
  return std::bit_cast<MassUnits>(static_cast<double>(value) + shift) -
         std::bit_cast<MassUnits>(shift);
}

}  // namespace bozzetto
