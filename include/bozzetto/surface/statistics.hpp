// What `info` tells about a surface.
#pragma once
#include "bozzetto/surface/surface.hpp"

namespace bozzetto {

struct SurfaceStatistics {
  std::int64_t cubes = 0;          ///< with at least one corner that holds clay (Ferley's cubes)
  std::int64_t crossingCubes = 0;  ///< the crossing list
  std::int64_t edges = 0;          ///< crossing edges = vertices
  std::int64_t triangles = 0;
  std::int64_t components = 0;  ///< connected pieces of surface; a cavity counts as one
};

/// `surface` is up to date with `field`. O(blocks near the surface).
template <int Side>
SurfaceStatistics statistics(const Surface<Side>& surface, const Field<Side>& field);

/// In cells; the volume is positive.
struct SurfaceMeasure {
  double volume = 0, area = 0;
};
/// What the surface encloses and how large it is. O(triangles).
template <int Side>
SurfaceMeasure measure(const Surface<Side>& surface);

}  // namespace bozzetto
