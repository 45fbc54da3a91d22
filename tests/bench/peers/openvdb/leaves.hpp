// Which leaves a brush must write: the serial half of every leaf-wise dab.
#pragma once
#include <tbb/parallel_for.h>

#include "scene.hpp"

namespace bozzetto::peer {

struct Reach {
  double outer = 0;     ///< leaves beyond it are left alone
  double swallow = 0;   ///< leaves wholly within it become tiles; <= 0: none do
  float saturated = 0;  ///< value of such a tile; tiles that have it already are skipped
  bool active = false;  ///< state of such a tile
};

inline void listLeaves(FloatGrid& grid, const Brush& brush, const Reach& reach,
                       std::vector<Leaf*>& leaves) {
  leaves.clear();
  auto accessor = grid.getAccessor();
  forLeavesWithin(brush.centre, reach.outer, [&](const Coord& origin, const LeafDistance& far) {
    Leaf* leaf = accessor.probeLeaf(origin);
    if (leaf == nullptr && accessor.getValue(origin) == reach.saturated) return;
    if (reach.swallow > 0 && far.farthest2 <= reach.swallow * reach.swallow) {
      accessor.addTile(1, origin, reach.saturated, reach.active);
    } else {
      leaves.push_back(leaf != nullptr ? leaf : accessor.touchLeaf(origin));
    }
  });
}

/// Calls write(leaf, brush centre relative to the leaf's first voxel, negated) on all, in parallel.
template <class Write>
void forEachLeaf(const std::vector<Leaf*>& leaves, const Brush& brush, Write write) {
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, leaves.size(), 4), [&](const Range& range) {
    for (std::size_t n = range.begin(); n != range.end(); ++n) {
      const Vec3d offset = leaves[n]->origin().asVec3d() - brush.centre;
      write(*leaves[n], openvdb::Vec3f(offset));
    }
  });
}

}  // namespace bozzetto::peer
