// The clay at half the resolution with a surface of its own: a quarter of the triangles, for frames
// in which the camera moves.
#pragma once
#include <set>
#include <vector>

#include "bozzetto/render/unpack.hpp"
#include "bozzetto/surface/surface.hpp"

namespace bozzetto {

class CoarseClay {
 public:
  /// Clay of more blocks than this (2 × 10⁹ cells) has no coarse copy.
  static constexpr std::int64_t kMostBlocks = 1 << 22;

  /// Patches made, altered or gone; the blocks' keys are CoarseClay's own.
  std::vector<Key> rebuild(const Clay& clay);
  std::vector<Key> refresh(const Clay& clay, std::span<const KeyRun> changed);

  /// In cells of the fine clay; without triangles when it is gone.
  UnpackedPatch patch(Key block) const;

 private:
  std::vector<Key> update(const Clay& clay, const std::set<Key>& blocks);

  Clay clay_;
  Surface<8> surface_;
};

}  // namespace bozzetto
