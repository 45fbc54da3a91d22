// The data structure as something to look at (Ferley figure 5): cubes with clay, cubes that the
// surface crosses.
#pragma once
#include <string_view>
#include <vector>

#include "bozzetto/render/unpack.hpp"
#include "bozzetto/surface/surface.hpp"

namespace bozzetto {

enum class Structure {
  surface,
  cubes,          ///< all cubes with a corner that holds clay (figure 5a)
  crossingCubes,  ///< those the surface crosses (figure 5b)
  heights,        ///< the surface as cloths thrown over it from where one looks
};

/// The name on the command line → structure. Throws Error naming the choices.
Structure parseStructure(std::string_view name);

/// The outer sides of those cubes as patches to draw instead of the surface's, with Look::cellLines
/// on; otherwise the surface's own. In the clay's colours, without light. O(blocks).
std::vector<UnpackedPatch> structurePatches(const Surface<8>& surface, const Clay& clay,
                                            Structure structure);

}  // namespace bozzetto
