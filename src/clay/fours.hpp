// Four cells in a row as a vector, for loops that compilers leave scalar: those that count, compare
// and look for a greatest. Four are what every machine has; the results are those of plain loops.
#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace bozzetto::clay {

using Four = float __attribute__((vector_size(16)));
using FourMasks = std::int32_t __attribute__((vector_size(16)));  ///< −1 where true, else 0

inline Four fourAt(const float* cells) {
  Four four;
  std::memcpy(&four, cells, sizeof four);
  return four;
}
inline FourMasks fourAt(const std::uint32_t* cells) {
  FourMasks four;
  std::memcpy(&four, cells, sizeof four);
  return four;
}
inline void put(const Four& four, float* cells) { std::memcpy(cells, &four, sizeof four); }
inline Four allFour(float x) { return Four{x, x, x, x}; }
inline Four lesser(const Four& a, const Four& b) { return b < a ? b : a; }
inline Four greater(const Four& a, const Four& b) { return a < b ? b : a; }
inline FourMasks bitsOf(const Four& four) { return std::bit_cast<FourMasks>(four); }

inline bool any(const FourMasks& masks) {
  const auto halves = std::bit_cast<std::array<std::uint64_t, 2>>(masks);
  return (halves[0] | halves[1]) != 0;
}
/// How often they were true, of sums of masks.
inline int count(const FourMasks& sums) { return -(sums[0] + sums[1] + sums[2] + sums[3]); }
inline float least(const Four& four) {
  const float a = four[0] < four[1] ? four[0] : four[1], b = four[2] < four[3] ? four[2] : four[3];
  return a < b ? a : b;
}

}  // namespace bozzetto::clay
