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
  ToolSource source;
  std::shared_ptr<const Sculpture> sculpture;
  std::shared_ptr<const ToolMesh> mesh;  ///< cells of the sculpture, from its pivot
  double size = 8;                       ///< largest radius as it was made, world units
  std::vector<Operation> preset;         ///< what it was kept with
};

/// Of a sculpture's surface, in its cells, from its pivot; light enough to be drawn in every frame.
std::shared_ptr<const ToolMesh> meshOf(const Sculpture& sculpture);

/// Loads nothing: of a tool that is there. Throws Error for one without clay.
Freeform freeformOf(const ShelfTool& tool, const ToolSource& source,
                    std::shared_ptr<const Sculpture> sculpture);

struct ShelfCard {
  ToolEntry entry;
  std::shared_ptr<const Bytes> picture;  ///< a PNG; null: not made yet
  std::uint64_t pictureId = 0;           ///< equal for equal pictures, never 0
};

}  // namespace bozzetto::ui
