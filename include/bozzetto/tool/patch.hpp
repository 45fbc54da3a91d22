// Patches: what is sculpted on a plane, undercuts and all, without the plane (vector displacement
// in clay).
#pragma once
#include <glm/vec3.hpp>
#include <optional>

#include "bozzetto/field/field.hpp"

namespace bozzetto {

/// World units; clay fills what is under it.
struct ClayPlane {
  glm::dvec3 at{0};
  glm::dvec3 normal{0, 0, 1};  ///< of any length
};

/// What stands on the plane, closed where it stood. What rises less than a quarter of a cell counts
/// as plane. Blocks well over it are shared. Throws Error for a plane that is none. O(nodes +
/// corners of blocks at the plane).
Clay standingOn(const Clay& clay, const ClayPlane& plane);

/// The plane along two axes, seen from the side that most of it can be seen from, on which
/// something stands: where most columns of clay end. Nothing where there is none such. O(air above
/// the clay ÷ 8), of at most 128² columns a side.
std::optional<ClayPlane> planeUnder(const Clay& clay);

}  // namespace bozzetto
