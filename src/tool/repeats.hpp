// The images of a stroke as its placement sees them.
#pragma once
#include <vector>

#include "bozzetto/tool/symmetry.hpp"

namespace bozzetto {

struct Repeats {
  Key origin;                     ///< that positions count from
  glm::dvec3 centre{0};           ///< of the symmetry, in cells from it
  std::vector<glm::dmat3> turns;  ///< of every image the turn that comes before its mirroring
};

/// The radial turn in every image of the symmetry: image = mirroring · turn.
std::vector<glm::dmat3> turnsOf(const Symmetry& symmetry, const std::vector<glm::dmat3>& images);

/// Dabs that touch the same clay once, the first of them.
std::vector<DabPose> withoutTwins(const std::vector<DabPose>& poses, Shape shape);

}  // namespace bozzetto
