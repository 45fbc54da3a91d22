#include "io/mesh_precision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "bozzetto/base/error.hpp"
#include "bozzetto/mesh/check.hpp"

namespace bozzetto {
namespace {

double farthestCoordinate(const MeshBounds& bounds) {
  double farthest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    farthest = std::max({farthest, std::abs(bounds.min[axis]), std::abs(bounds.max[axis])});
  }
  return farthest;
}

}  // namespace

bool needsDouble(const TriangleMesh& mesh) {
  const auto bounds = boundsOf(mesh);
  const double farthest = farthestCoordinate(bounds);
  return farthest > 4 * bounds.longestSide() ||
         farthest > static_cast<double>(std::numeric_limits<float>::max());
}

void requireFloatRange(const TriangleMesh& mesh, const char* format) {
  const double farthest = farthestCoordinate(boundsOf(mesh));
  if (farthest <= static_cast<double>(std::numeric_limits<float>::max())) return;
  throw Error(std::string(format) + ": found coordinate " + std::to_string(farthest) +
              ", expected one that fits single precision");
}

}  // namespace bozzetto
