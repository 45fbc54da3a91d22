#include "bozzetto/clay/idle.hpp"

#include <utility>

#include "clay/layer.hpp"

namespace bozzetto::clay {

std::string idleIn(const Stroke& stroke, Role role, const Settings& settings) {
  const Placement& how = stroke.placement;
  std::string names;
  const auto name = [&](bool idle, const char* what) {
    if (idle) names += (names.empty() ? "" : ", ") + std::string(what);
  };
  name(stroke.pressure.strength, "pressure as strength");
  name(how.toNormal || how.alongStroke, "orient");
  name(how.jitter != Jitter{}, "jitter");
  name(how.roll != 0, "roll");
  name(how.grid > 0, "grid");
  name(how.anchored, "anchored");
  if (!names.empty()) names = "where clay is moved these play no part: " + names;
  const bool drags =
      runs(settings, LayerKind::displacement) || runs(settings, LayerKind::automaton);
  if (role == Role::grip && !drags)
    names += std::string(names.empty() ? "" : "; ") +
             "a grip drags nothing: neither displacement nor automaton is among the layers";
  return names;
}

Stroke withoutIdle(Stroke stroke) {
  stroke.pressure.strength = false;
  if (!stroke.pressure.size)
    for (StrokePoint& point : stroke.points) point.pressure = 1;
  const Placement asked = std::exchange(stroke.placement, {});
  stroke.placement.copies = asked.copies;
  stroke.placement.copyStep = asked.copyStep;
  return stroke;
}

}  // namespace bozzetto::clay
