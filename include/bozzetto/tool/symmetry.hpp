// One stroke, many images: mirrors and radial copies.
#pragma once
#include <array>
#include <vector>

#include "bozzetto/base/axis.hpp"
#include "bozzetto/tool/potential.hpp"

namespace bozzetto {

struct Symmetry {
  std::array<bool, 3> mirror{};  ///< about planes across x, y, z through `centre`
  glm::dvec3 centre{0};          ///< world units
  Axis radialAxis = Axis::y;     ///< through `centre`
  int radialCount = 1;           ///< copies in all, 1…256
};

/// Throws Error when the count or the centre is out of range.
void requireValid(const Symmetry& symmetry);

/// The linear parts of all images, the identity first, none twice.
std::vector<glm::dmat3> imagesOf(const Symmetry& symmetry);

/// `pose` and its images; those that are the same dab (at a fixed point of the symmetry) once.
/// `centre` is the symmetry's, in cells from the poses' origin.
std::vector<DabPose> imagesOf(const DabPose& pose, Shape shape,
                              const std::vector<glm::dmat3>& images, const glm::dvec3& centre);

}  // namespace bozzetto
