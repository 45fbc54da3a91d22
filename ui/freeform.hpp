// A sculpture as the hand holds it, and a shelf as the window shows it: finished values from the
// worker's thread.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "bozzetto/render/overlays.hpp"
#include "bozzetto/sculptor/shelf_tool.hpp"

namespace bozzetto::ui {

struct Freeform {
  std::string name;
  ToolSource source;                      ///< says pivot and contact where the hand has moved them
  std::shared_ptr<const Sculpture> kept;  ///< as the shelf has it; null: a preset without
  std::shared_ptr<const ToolMesh> mesh;   ///< its cells, from the middle of its bounds
  double size = 8;                        ///< largest radius as it was made, world units
  std::vector<Operation> preset;          ///< what it was kept with
  std::shared_ptr<const Sculpture> sculpture;  ///< as the hand holds it

  /// From the middle of its bounds, in halves of its extent: 1 is its right, upper, front side.
  glm::dvec3 pivot() const;
  void setPivot(const glm::dvec3& halves);
  void setContact(const glm::dvec3& direction);
  /// With the shelf's pivot and contact.
  void standAsKept();
  bool standsAsKept() const { return sculpture == kept; }

 private:
  void stand();
};

/// A direction by angles in degrees: 0, 0 is −z, where tools touch as a rule; right and up of it.
struct Heading {
  double right = 0, up = 0;
};
Heading headingOf(const glm::dvec3& direction);
glm::dvec3 directionOf(const Heading& heading);

/// Of a sculpture's surface, in its cells, from the middle of its bounds; light enough to be drawn
/// in every frame.
std::shared_ptr<const ToolMesh> meshOf(const Sculpture& sculpture);

/// Loads nothing: of a tool that is there; `sculpture` is null for a preset without one.
Freeform freeformOf(const ShelfTool& tool, const ToolSource& source,
                    std::shared_ptr<const Sculpture> sculpture);

struct ShelfCard {
  ToolEntry entry;
  std::shared_ptr<const Bytes> picture;  ///< a PNG; null: not made yet
  std::uint64_t pictureId = 0;           ///< equal for equal pictures, never 0
  std::string trouble{};                 ///< why it cannot be used; empty where it can
};

}  // namespace bozzetto::ui
