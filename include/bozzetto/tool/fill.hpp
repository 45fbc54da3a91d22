// Fill: deposits a whole primitive of clay at once.
#pragma once
#include "bozzetto/base/progress.hpp"
#include "bozzetto/tool/dab.hpp"

namespace bozzetto {

struct Primitive {
  Shape shape = Shape::ellipsoid;
  glm::dvec3 centre{0};             ///< world units
  glm::dvec3 radii{8, 8, 8};        ///< world units; the surface
  glm::dquat rotation{1, 0, 0, 0};  ///< w, x, y, z
  Colour colour;
};

/// Raises every corner to clamp(½ − distance/(2·spacing)), distance signed, negative inside, and
/// gives it the primitive's colour where that raises it; held corners less so, as actions do.
/// In the report, computed counts the corners near the surface. Throws Error, before anything
/// changes, for radii that are not finite and above 0, and where the surface would need more than
/// 2²³ blocks or leave the workspace. Cancelling rolls the edit back. O(surface), in parallel.
template <int Side>
DabReport fill(Edit<CornerBlock<Side>>& edit, const FieldScale& scale, const Primitive& primitive,
               Progress& progress = Progress::none());

extern template DabReport fill(Edit<CornerBlock<1>>&, const FieldScale&, const Primitive&,
                               Progress&);
extern template DabReport fill(Edit<CornerBlock<8>>&, const FieldScale&, const Primitive&,
                               Progress&);

}  // namespace bozzetto
