// One block of a resampled field from the blocks of the old one.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "bozzetto/field/corner_block.hpp"

namespace bozzetto {

/// From where along one axis the 8 corners of a block take their values, and how much. Old cells
/// per new cell are in (0, 2]. The weights of a tent of half width max(1, ratio), bent a little so
/// that linear slopes stay exact.
struct AxisTaps {
  static constexpr int kMost = 4;

  AxisTaps(std::int32_t block, double ratio);

  std::int32_t low = 0;  ///< the first old corner used
  int span = 0;          ///< how many from there
  int taps = 0;          ///< per corner
  std::array<int, 8> first{};
  std::array<int, 8> nearest{};
  std::array<std::array<double, kMost>, 8> weight{};

  std::int32_t lowBlock() const { return low >> 3; }
  /// How many old blocks are used, at most 4.
  int blocks() const { return ((low + span - 1) >> 3) - lowBlock() + 1; }
};

/// The old block in which the taps of a block begin: AxisTaps(block, ratio).lowBlock().
std::int32_t firstSourceBlock(std::int32_t block, double ratio);

using SourceBlocks = std::array<const CornerBlock<8>*, 64>;

/// A 4×4×4 window of old blocks that begins at the taps' lowBlock()s, resampled; values below
/// `dropBelow` become empty. Canonical: null when empty, interned when uniform.
Ref<CornerBlock<8>> resampleBlock(const SourceBlocks& sources,
                                  const std::array<const AxisTaps*, 3>& taps, float dropBelow);

}  // namespace bozzetto
