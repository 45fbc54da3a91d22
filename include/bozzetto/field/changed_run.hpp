// Which corners changed: what a dab knows while it writes, so that nobody has to compare blocks.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "bozzetto/grid/key_tree.hpp"

namespace bozzetto {

/// Corners of a block: bit j · 8 + k of slice i. Side 1 has bit 0 of slice 0 alone.
using CornerBits = std::array<std::uint64_t, 8>;
inline constexpr std::uint64_t kAllCorners = ~std::uint64_t{0};

/// A run of blocks in each of which these corners changed; all of them where nobody knows better.
struct ChangedRun : KeyRun {
  CornerBits corners{kAllCorners, kAllCorners, kAllCorners, kAllCorners,
                     kAllCorners, kAllCorners, kAllCorners, kAllCorners};

  ChangedRun() = default;
  ChangedRun(const KeyRun& run) : KeyRun(run) {}  // NOLINT(google-explicit-constructor)
  ChangedRun(Key block, const CornerBits& bits) : KeyRun{block, 1}, corners(bits) {}
};

/// In key order, each block once with all its corners: for dabs and their images, which list blocks
/// one after the other. Runs of more than one block must not overlap others.
std::vector<ChangedRun> sortedOnce(std::vector<ChangedRun> runs);

}  // namespace bozzetto
