// A deformable solid as the window shows it: finished values from the worker's thread.
#pragma once
#include <array>
#include <memory>
#include <vector>

#include "bozzetto/render/unpack.hpp"
#include "bozzetto/solid/pick.hpp"
#include "bozzetto/solid/solid.hpp"
#include "bozzetto/solid/tools.hpp"

namespace bozzetto::ui {

/// What the smooth surface's colours say.
enum class SolidMap { none, stiffness, mass, strain };

struct SolidShown {
  std::shared_ptr<const Solid> solid;
  Topology topology;             ///< of the control lattice
  Lattice mass;                  ///< the surface as physics has it, with all refined points
  std::optional<RunReport> ran;  ///< of the physics that made it so
  SolidMap map = SolidMap::none;
  std::vector<UnpackedPatch> surface;            ///< smooth, by where it lies
  std::vector<std::array<glm::dvec3, 2>> wires;  ///< refined edges of the surface, world units
  std::size_t refinedCells = 0, refinedPoints = 0;
  double low = 0, high = 0;  ///< of what the colours show

  const Lattice& control() const { return solid->control; }
};

struct SolidStyle {
  SolidMap map = SolidMap::none;
  Colour colour;       ///< where nothing is mapped
  double spacing = 1;  ///< of the clay's grid
};
/// Refines it, once more than physics does as long as that is little.
std::shared_ptr<const SolidShown> shownSolid(std::shared_ptr<const Solid> solid,
                                             const SolidStyle& style);

/// Blue for little, over pale, to red for much; 0…1.
Colour heat(double part);

}  // namespace bozzetto::ui
