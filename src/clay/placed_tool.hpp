// A tool at one step: where it is, what it does, how far it moved.
#pragma once
#include <glm/mat3x3.hpp>
#include <memory>
#include <vector>

#include "bozzetto/clay/settings.hpp"
#include "bozzetto/tool/solid.hpp"
#include "clay/region.hpp"

namespace bozzetto::clay {

/// A rigid motion as a displacement field: p moves by turn·p + shift, p in cells from the stroke's
/// origin.
struct Motion {
  glm::dmat3 turn{0};
  glm::dvec3 shift{0};
  glm::dvec3 at(const glm::dvec3& p) const { return turn * p + shift; }
};

struct PlacedTool {
  std::unique_ptr<Solid> solid;
  KeyBox box;  ///< corners it may cover
  Role role = Role::push;
  Motion motion;
  double radius = 1;    ///< the largest, in cells
  double core = 1;      ///< how deep in it its core begins, in cells
  glm::dvec3 stand{0};  ///< where its middle, or the pivot of a sculpture, is; from solid->cell
  float strength = 0;   ///< of swelling

  /// Part of the cell that the tool takes, 0 … 1 over one cell across its surface.
  float cover(Key key) const;
  /// Bits of the directions that lead out of the tool at this cell, within 60° of the way to its
  /// surface (Dewaele §3.2.2). Bit n is neighbours()[n].
  std::uint8_t waysOut(Key key) const;
  /// Outwards, of length 1.
  glm::dvec3 normal(Key key) const;
};

/// Keeps `cover` and `owner` of a region: static tools once, moving tools anew each step.
class CoverPainter {
 public:
  /// For a region just loaded. Where clay stands inside a support, the support gives way to it.
  void paintStatic(Region& region, const std::vector<PlacedTool>& supports);
  /// Takes the last step's moving tools away and paints these, as far as they are in this box.
  void paintMoving(Region& region, const std::vector<PlacedTool>& moving, const KeyBox& within);

 private:
  struct Painted {  // what eight cells were before
    std::size_t first;
    std::array<float, Region::kTile> cover;
    std::array<std::uint8_t, Region::kTile> owner;
  };
  void sparePastClay(Region& region);
  void holdFaces(Region& region, Axis axis);
  void paint(Region& region, const PlacedTool& tool, const KeyBox& box, std::uint8_t owner);
  struct Brush {
    const PlacedTool& tool;
    std::uint8_t owner;
    std::size_t first;  // of the eight cells
  };
  void paintTile(Region& region, const PlacedTool& tool, std::uint8_t owner, Key tile);
  void paintRow(Region& region, const Brush& brush, const float* value);

  std::vector<Painted> before_;
  std::vector<std::size_t> staticTiles_;  // a cell of each
  std::size_t staticRows_ = 0;            // in the region's `covered`
};

/// Any cell of clay that the tool covers.
bool touchesClay(const Region& region, const PlacedTool& tool);

}  // namespace bozzetto::clay
