// A smoothing dab, a leaf at a time: every leaf is gathered with one voxel round it, averaged with
// its six neighbours into a stage, and all are written back when all were read.
#include <cmath>
#include <cstring>

#include "cases.hpp"
#include "leaves.hpp"

namespace bozzetto::peer {
namespace {

using Accessor = openvdb::tree::ValueAccessor<const openvdb::FloatTree>;
using Voxels = float[10][10][16];

// A neighbouring leaf's values, or one value where it is a tile.
struct Neighbour {
  const float* values = nullptr;
  float tile = 0;
  float at(int x, int y, int z) const { return values ? values[x * 64 + y * 8 + z] : tile; }
};

Neighbour neighbourAt(const Accessor& accessor, const Coord& origin) {
  const Leaf* leaf = accessor.probeConstLeaf(origin);
  return leaf ? Neighbour{leaf->buffer().data(), 0} : Neighbour{nullptr, accessor.getValue(origin)};
}

void gatherSides(const Accessor& accessor, const Coord& origin, bool above, Voxels& voxels) {
  const int step = above ? 8 : -8, from = above ? 0 : 7, to = above ? 9 : 0;
  const Neighbour x = neighbourAt(accessor, origin.offsetBy(step, 0, 0));
  const Neighbour y = neighbourAt(accessor, origin.offsetBy(0, step, 0));
  const Neighbour z = neighbourAt(accessor, origin.offsetBy(0, 0, step));
  for (int u = 0; u < 8; ++u) {
    for (int v = 0; v < 8; ++v) {
      voxels[to][u + 1][v + 1] = x.at(from, u, v);
      voxels[u + 1][to][v + 1] = y.at(u, from, v);
      voxels[u + 1][v + 1][to] = z.at(u, v, from);
    }
  }
}

void gather(const Accessor& accessor, const Leaf& leaf, Voxels& voxels) {
  const float* values = leaf.buffer().data();
  for (int x = 0; x < 8; ++x) {
    for (int y = 0; y < 8; ++y) {
      std::memcpy(&voxels[x + 1][y + 1][1], values + x * 64 + y * 8, 8 * sizeof(float));
    }
  }
  gatherSides(accessor, leaf.origin(), false, voxels);
  gatherSides(accessor, leaf.origin(), true, voxels);
}

float smoothStep(float t) { return t * t * (3 - 2 * t); }

// The smoothed values of the leaf's active voxels; the others as they are.
void average(const Voxels& voxels, const Leaf& leaf, const Brush& brush, float* out) {
  const openvdb::Vec3f offset(leaf.origin().asVec3d() - brush.centre);
  const auto radius = static_cast<float>(brush.radius);
  for (int x = 0; x < 8; ++x) {
    const auto active = leaf.getValueMask().getWord<std::uint64_t>(static_cast<openvdb::Index>(x));
    for (int y = 0; y < 8; ++y) {
      const float dx = offset.x() + static_cast<float>(x), dy = offset.y() + static_cast<float>(y);
      const unsigned row = static_cast<unsigned>(active >> (y * 8)) & 255u;
      for (int z = 0; z < 8; ++z) {
        const float old = voxels[x + 1][y + 1][z + 1];
        const float mean =
            (voxels[x + 2][y + 1][z + 1] + voxels[x][y + 1][z + 1] + voxels[x + 1][y + 2][z + 1] +
             voxels[x + 1][y][z + 1] + voxels[x + 1][y + 1][z + 2] + voxels[x + 1][y + 1][z]) *
            (1.f / 6);
        const float dz = offset.z() + static_cast<float>(z);
        const float distance = std::sqrt(dx * dx + dy * dy + dz * dz);
        const float weight = smoothStep(std::max(0.f, 1 - distance / radius));
        out[x * 64 + y * 8 + z] = ((row >> z) & 1u) ? old + weight * (mean - old) : old;
      }
    }
  }
}

void smooth(FloatGrid& grid, const Brush& brush) {
  static std::vector<Leaf*> leaves;
  static std::vector<float> stage;
  leaves.clear();
  auto writer = grid.getAccessor();
  forLeavesWithin(brush.centre, brush.radius, [&](const Coord& origin, const LeafDistance&) {
    if (Leaf* leaf = writer.probeLeaf(origin)) leaves.push_back(leaf);
  });
  stage.resize(leaves.size() * Leaf::SIZE);
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, leaves.size(), 4), [&](const Range& range) {
    const Accessor accessor(grid.constTree());
    alignas(64) Voxels voxels;
    for (std::size_t n = range.begin(); n != range.end(); ++n) {
      gather(accessor, *leaves[n], voxels);
      average(voxels, *leaves[n], brush, &stage[n * Leaf::SIZE]);
    }
  });
  tbb::parallel_for(Range(0, leaves.size(), 8), [&](const Range& range) {
    for (std::size_t n = range.begin(); n != range.end(); ++n) {
      std::memcpy(leaves[n]->buffer().data(), &stage[n * Leaf::SIZE], Leaf::SIZE * sizeof(float));
    }
  });
}

}  // namespace

std::vector<Case> smoothCases() {
  return {{"smooth", true,
           [](const Job& job) { return measureStroke(job, levelSetBall(), smooth, [] {}); }}};
}

}  // namespace bozzetto::peer
