// Sharp transport of a density: the part of a cell that leaves through a face is read off a steep
// profile that is fitted to the cell (THINC: Xiao, Honma & Kono 2005), so that edges stay one to
// two cells wide whatever the number of steps.
#pragma once
#include <bit>
#include <cstdint>

#include "bozzetto/base/simd.hpp"

namespace bozzetto::clay {

// β, with e^β and e^−β.
struct Steepness {
  float beta, end, endInverse;
};
inline constexpr Steepness kSoft{2.5f, 12.18249396f, 0.08208499862f};  // clay.md §2: used
inline constexpr Steepness kHard{3.5f, 33.11545196f, 0.03019738342f};  // clay.md §11, case 5

// eˣ for |x| ≤ 80, relative error 2e-7: the same bits on every machine.
BOZZETTO_KERNEL float exponential(float x) {
  constexpr float toInteger = 0x1.8p23f;
  const float shifted = x * 1.44269504f + toInteger;
  const float whole = shifted - toInteger;
  const float f = (x - whole * 0.693359375f) + whole * 2.12194440e-4f;
  float p = 1.9875691500e-4f;
  p = p * f + 1.3981999507e-3f;
  p = p * f + 8.3334519073e-3f;
  p = p * f + 4.1665795894e-2f;
  p = p * f + 1.6666665459e-1f;
  p = p * f + 5.0000001201e-1f;
  const float mantissa = (p * f) * f + f + 1.0f;
  const auto exponent = std::bit_cast<std::int32_t>(shifted) << 23;
  return std::bit_cast<float>(std::bit_cast<std::int32_t>(mantissa) + exponent);
}

// ln x for normal x > 0, error 1e-7.
BOZZETTO_KERNEL float logarithm(float x) {
  const auto bits = std::bit_cast<std::int32_t>(x);
  const std::int32_t exponent = (bits - 0x3f3504f3) >> 23;  // mantissa in [√½, √2)
  const float f = std::bit_cast<float>(bits - (exponent << 23)) - 1.0f;
  const float z = f * f;
  float p = 7.0376836292e-2f;
  p = p * f - 1.1514610310e-1f;
  p = p * f + 1.1676998740e-1f;
  p = p * f - 1.2420140846e-1f;
  p = p * f + 1.4249322787e-1f;
  p = p * f - 1.6668057665e-1f;
  p = p * f + 2.0000714765e-1f;
  p = p * f - 2.4999993993e-1f;
  p = p * f + 3.3333331174e-1f;
  const auto e = static_cast<float>(exponent);
  return f + ((f * z * p + e * -2.12194440e-4f) - 0.5f * z) + e * 0.693359375f;
}

// What leaves a cell with mean `density` in (0, 1) through a face, over a width `u` in [0, 1], when
// the density rises towards that face; falling is density − what would leave a rising 1 − …, here
// by the sign of the exponent.
//   ½(u + γ/β · ln(cosh(β(1 − x̃)) / cosh(β(1 − u − x̃)))), x̃ from the mean, γ = ±1.
BOZZETTO_KERNEL float thincFlux(float density, float u, float sign, const Steepness& by = kSoft) {
  const auto [beta, end, endInverse] = by;
  const float e = exponential((beta * sign) * (2.0f * density - 1.0f));
  const float jump = (end - e) / (e - endInverse);  // e^(2β·x̃)
  const float s = exponential(beta * (1.0f - u));
  const float ratio = (end + endInverse * jump) / (s + jump / s);
  return 0.5f * (u + sign * logarithm(ratio) * (1.0f / beta));
}

}  // namespace bozzetto::clay
