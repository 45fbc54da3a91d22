#include "ui/layout.hpp"

#include <algorithm>
#include <cmath>

namespace bozzetto::ui {

Layout layoutFor(glm::dvec2 window, double scale, bool panels, Drawer drawer) {
  const auto size = [&](double at1) { return std::floor(at1 * scale); };
  const double w = window.x, h = window.y;
  Layout layout;
  layout.viewport = {{0, 0}, window};
  if (!panels) return layout;
  layout.panels = true;
  layout.shelf = drawer;
  const double top = size(44), bottom = h - size(28), left = size(60);
  const double shelf = drawer == Drawer::open ? left + size(236) : left;
  // A narrow window keeps some clay in sight.
  const double right = std::max(w - size(288), shelf + 64);
  layout.topBar = {{0, 0}, {w, top}};
  layout.status = {{0, bottom}, {w, h}};
  layout.tools = {{0, top}, {left, bottom}};
  layout.properties = {{right, top}, {w, bottom}};
  layout.drawer = {{left, top}, {shelf, bottom}};
  layout.viewport = {{shelf, top}, {right, std::max(bottom, top + 64)}};
  return layout;
}

}  // namespace bozzetto::ui
