#include "scene.hpp"

#include <openvdb/tools/LevelSetSphere.h>
#include <openvdb/tools/LevelSetUtil.h>

#include <cmath>

namespace bozzetto::peer {

const FloatGrid& levelSetBall() {
  static const FloatGrid::Ptr ball = openvdb::tools::createLevelSetSphere<FloatGrid>(
      static_cast<float>(workload::kBallRadius), openvdb::Vec3f(0), 1.0f, kHalfWidth);
  return *ball;
}

const FloatGrid& fogBall() {
  static const FloatGrid::Ptr ball = [] {
    FloatGrid::Ptr grid = levelSetBall().deepCopy();
    openvdb::tools::sdfToFogVolume(*grid);
    return grid;
  }();
  return *ball;
}

std::vector<Brush> strokeOf(double radius) {
  std::vector<Brush> brushes;
  for (const workload::Point& p : workload::stroke(radius)) {
    brushes.push_back({Vec3d(p[0], p[1], p[2]), radius});
  }
  return brushes;
}

LeafDistance distanceTo(const Coord& origin, const Vec3d& point) {
  LeafDistance distance;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = origin[axis] - point[axis];
    const double high = low + 7;
    const double nearest = low > 0 ? low : high < 0 ? -high : 0;
    const double farthest = std::max(std::fabs(low), std::fabs(high));
    distance.nearest2 += nearest * nearest;
    distance.farthest2 += farthest * farthest;
  }
  return distance;
}

std::uint64_t fingerprintOf(const FloatGrid& grid) {
  Fingerprint fingerprint;
  for (auto leaf = grid.tree().cbeginLeaf(); leaf; ++leaf) {
    for (int axis = 0; axis < 3; ++axis) {
      fingerprint.add(static_cast<std::uint32_t>(leaf->origin()[axis]));
    }
    fingerprint.add(leaf->buffer().data(), Leaf::SIZE);
  }
  return fingerprint.value();
}

void addCounts(Result& result, const FloatGrid& grid) {
  result.detail.emplace_back("active_voxels", static_cast<double>(grid.activeVoxelCount()));
  result.detail.emplace_back("leaves", static_cast<double>(grid.tree().leafCount()));
  result.detail.emplace_back("bytes", static_cast<double>(grid.memUsage()));
}

}  // namespace bozzetto::peer
