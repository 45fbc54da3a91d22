// Where things stand in the window, pixels from its top left corner.
#pragma once
#include <glm/vec2.hpp>

namespace bozzetto::ui {

struct Rect {
  glm::dvec2 low{0}, high{0};
  double width() const { return high.x - low.x; }
  double height() const { return high.y - low.y; }
  glm::dvec2 centre() const { return (low + high) / 2.0; }
  bool contains(glm::dvec2 p) const {
    return p.x >= low.x && p.y >= low.y && p.x < high.x && p.y < high.y;
  }
};

/// Whether the shelf stands beside the tools.
enum class Drawer { closed, open };

/// What a frame draws is what it laid out: a key pressed in between counts in the next one.
struct Layout {
  bool panels = false;
  Drawer shelf = Drawer::closed;
  Rect topBar, tools, drawer, properties, status, viewport;
};

/// Panels of whole pixels around what is left for the clay; without panels all of it is.
Layout layoutFor(glm::dvec2 window, double scale, bool panels, Drawer drawer = Drawer::closed);

}  // namespace bozzetto::ui
