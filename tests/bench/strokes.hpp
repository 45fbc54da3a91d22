// The stroke of workload.hpp as our tools take it.
#pragma once
#include "bozzetto/tool/stroke.hpp"
#include "workload.hpp"

namespace bozzetto::strokes {

inline Stroke onBall(double radius) {
  Stroke stroke;
  for (const workload::Point& p : workload::stroke(radius)) {
    stroke.points.push_back({{p[0], p[1], p[2]}, 1});
  }
  stroke.spacing = 0.25 * (1 - 1e-3);  // a dab at each point, none in between
  return stroke;
}

inline ToolShape toolOf(double radius) {
  ToolShape tool;
  tool.radii = {radius, radius, radius};
  return tool;
}

inline ActionOptions actionOf(ActionKind kind) {
  return {kind, workload::kStrength, {200, 100, 60}};
}

}  // namespace bozzetto::strokes
