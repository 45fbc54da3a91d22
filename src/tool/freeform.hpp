// Freeform tools on the grid (Ferley §4.1.2): a sculpture at a place, turned and scaled.
#pragma once
#include "bozzetto/tool/potential.hpp"
#include "bozzetto/tool/sculpture.hpp"
#include "tool/tool_tile.hpp"

namespace bozzetto {

/// One resolution of a tool, ready to be read.
struct SculptureLevel {
  explicit SculptureLevel(Clay clay_)
      : clay(std::move(clay_)), bounds(boundsOf(clay)), blocks(clay) {}
  SculptureLevel(const SculptureLevel&) = delete;
  SculptureLevel& operator=(const SculptureLevel&) = delete;

  Clay clay;
  KeyBox bounds;
  BlockTable blocks;
};

/// How many times the tool's cells are smaller than the clay's, on the axis where they are most.
double minification(const Sculpture& sculpture, const glm::dvec3& radiiCells);
inline constexpr double kMostMinified = 1 << Sculpture::kLevels;

/// Moves a pose that stands on its pivot to the centre of the tool's box.
void putOnPivot(const Sculpture& sculpture, DabPose& pose);

std::unique_ptr<Potential> makeFreeform(std::shared_ptr<const Sculpture> sculpture,
                                        const glm::dvec3& radiiCells);

}  // namespace bozzetto
