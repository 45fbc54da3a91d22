// The ball as OpenVDB keeps it, as a level set and as a density, and the brush on it.
#pragma once
#include <openvdb/openvdb.h>

#include "report.hpp"
#include "workload.hpp"

namespace bozzetto::peer {

using openvdb::Coord;
using openvdb::FloatGrid;
using openvdb::Vec3d;
using Leaf = openvdb::FloatTree::LeafNodeType;

inline constexpr float kHalfWidth = 3;  ///< of the narrow band, voxels

struct Brush {
  Vec3d centre;
  double radius = 0;
};

enum class Change { add, remove };

inline const char* nameOf(Change change) { return change == Change::add ? "add" : "remove"; }

/// The ball as a level set: 4.94 million active voxels in 26,600 leaves.
const FloatGrid& levelSetBall();

/// The ball as a density: 1 inside, falling to 0 over kHalfWidth voxels.
const FloatGrid& fogBall();

/// The brushes of one stroke.
std::vector<Brush> strokeOf(double radius);

/// Squared distances from a point to the nearest and to the farthest voxel of the leaf at `origin`.
struct LeafDistance {
  double nearest2 = 0, farthest2 = 0;
};
LeafDistance distanceTo(const Coord& origin, const Vec3d& point);

/// Calls visit(origin) for every leaf position that meets the ball of `reach` round `centre`.
template <class Visit>
void forLeavesWithin(const Vec3d& centre, double reach, Visit visit) {
  const Coord low = Coord::floor(centre - Vec3d(reach)) & ~7;
  const Coord high = Coord::ceil(centre + Vec3d(reach));
  for (int x = low.x(); x <= high.x(); x += 8) {
    for (int y = low.y(); y <= high.y(); y += 8) {
      for (int z = low.z(); z <= high.z(); z += 8) {
        const Coord origin(x, y, z);
        const LeafDistance distance = distanceTo(origin, centre);
        if (distance.nearest2 < reach * reach) visit(origin, distance);
      }
    }
  }
}

/// Of all values, in tree order.
std::uint64_t fingerprintOf(const FloatGrid& grid);

void addCounts(Result& result, const FloatGrid& grid);

/// One measurement to make; radius 0 where there is no tool.
struct Job {
  std::string name;
  double radius = 0;
  int repeats = 1;

  Result result() const { return {name, radius, {}, 0, {}}; }
};

/// Mean milliseconds a dab of whole strokes, each over a fresh copy of `base`.
/// `dab(grid, brush)` is timed; `prepare()` runs before each stroke and is not.
template <class Dab, class Prepare>
Result measureStroke(const Job& job, const FloatGrid& base, Dab dab, Prepare prepare) {
  Result result = job.result();
  const std::vector<Brush> brushes = strokeOf(job.radius);
  double worst = 0;
  for (int n = 0; n < job.repeats; ++n) {
    prepare();
    const FloatGrid::Ptr grid = base.deepCopy();
    double sum = 0;
    for (const Brush& brush : brushes) {
      const Clock clock;
      dab(*grid, brush);
      const double ms = clock.ms();
      sum += ms;
      worst = std::max(worst, ms);
    }
    result.ms.push_back(sum / static_cast<double>(brushes.size()));
    if (n + 1 < job.repeats) continue;
    result.fingerprint = fingerprintOf(*grid);
    addCounts(result, *grid);
  }
  result.detail.emplace_back("worst_dab_ms", worst);
  return result;
}

}  // namespace bozzetto::peer
