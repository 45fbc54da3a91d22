// Freeform tools on the grid (Ferley §4.1.2): a sculpture at a place, turned and scaled.
#pragma once
#include <map>

#include "bozzetto/tool/potential.hpp"
#include "bozzetto/tool/sculpture.hpp"
#include "tool/distance_field.hpp"
#include "tool/handle_room.hpp"
#include "tool/tool_box.hpp"
#include "tool/tool_tile.hpp"

namespace bozzetto {

/// One resolution of a tool, ready to be read.
struct SculptureLevel {
  explicit SculptureLevel(Clay clay_)
      : clay(std::move(clay_)), bounds(boundsOf(clay)), blocks(clay) {}
  SculptureLevel(const SculptureLevel&) = delete;
  SculptureLevel& operator=(const SculptureLevel&) = delete;

  /// Distances to its surface outside, as far as `reach` cells; made when first asked for.
  std::shared_ptr<const DistanceField> outside(float iso, int reach) const;

  /// Of it and a handle away from `contact`, in its cells; as far; made when first asked for.
  std::shared_ptr<const HandleRoom> handle(const glm::dvec3& contact, int reach) const;

  /// All its corners; made when first asked for, empty where they are too many.
  const ToolBox& box() const;

  Clay clay;
  KeyBox bounds;
  BlockTable blocks;

 private:
  mutable std::once_flag boxed_;
  mutable std::unique_ptr<const ToolBox> box_;
  mutable std::mutex making_;
  mutable std::map<std::pair<float, int>, std::shared_ptr<const DistanceField>> outside_;
  mutable std::map<std::array<double, 4>, std::shared_ptr<const HandleRoom>> handles_;
};

/// The copy that a tool of these radii is read from: its cells are nearest to those of the clay,
/// never more than √2 times finer.
int levelFor(const Sculpture& sculpture, const glm::dvec3& radiiCells);
/// The corner of that copy that positions count from.
Key baseOf(const Sculpture& sculpture, int level);

/// How many times the tool's cells are smaller than the clay's, on the axis where they are most.
double minification(const Sculpture& sculpture, const glm::dvec3& radiiCells);
inline constexpr double kMostMinified = 1 << Sculpture::kLevels;

/// Moves a pose that stands on its pivot to the centre of the tool's box.
void putOnPivot(const Sculpture& sculpture, DabPose& pose);

/// How deep a tool that only touches the clay, its pivot on its contact side, sinks in to print, in
/// cells of the clay: half its height, but no more than a quarter of its width. 0 for others.
double printDepth(const Sculpture& sculpture, const glm::dvec3& radiiCells);

std::unique_ptr<Potential> makeFreeform(std::shared_ptr<const Sculpture> sculpture,
                                        const glm::dvec3& radiiCells);

}  // namespace bozzetto
