#include <cmath>
#include <cstdio>

#include "bozzetto/base/error.hpp"
#include "bozzetto/tool/dab.hpp"

namespace bozzetto {
namespace {

// Rotations by quarter turns come out of quaternions with entries of 1e-16: make them exact, so
// that turned tools give the bits of tools with swapped radii.
double tidied(double entry) {
  if (std::abs(entry) < 1e-14) return 0;
  return std::abs(std::abs(entry) - 1) < 1e-14 ? std::copysign(1.0, entry) : entry;
}

std::string wholeText(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", number);
  return text;
}

Key nearestCell(const glm::dvec3& position) {
  return {static_cast<std::int32_t>(std::nearbyint(position.x)),
          static_cast<std::int32_t>(std::nearbyint(position.y)),
          static_cast<std::int32_t>(std::nearbyint(position.z))};
}

}  // namespace

LocalFrame localFrame(const DabPose& pose) {
  LocalFrame frame;
  const Key own = nearestCell(pose.position);
  frame.cell = pose.origin + own;
  const glm::dvec3 fraction = pose.position - glm::dvec3(own.i, own.j, own.k);
  for (int axis = 0; axis < 3; ++axis) {  // of the tool
    double first = 0;
    for (int grid = 0; grid < 3; ++grid) {
      const double step = tidied(pose.orientation[axis][grid]) / pose.radii[axis];
      frame.step[grid][axis] = static_cast<float>(step);
      first -= fraction[grid] * step;
    }
    frame.first[axis] = static_cast<float>(first);
  }
  return frame;
}

KeyBox dabBox(const DabPose& pose) {
  constexpr double slack = 1 + 4e-6;  // no corner beyond the box is in the local box after rounding
  std::array<std::int32_t, 3> low, high;
  const std::array<double, 3> origin{double(pose.origin.i), double(pose.origin.j),
                                     double(pose.origin.k)};
  for (int grid = 0; grid < 3; ++grid) {
    double reach = 0;
    for (int axis = 0; axis < 3; ++axis)
      reach += std::abs(tidied(pose.orientation[axis][grid])) * pose.radii[axis];
    const double first = origin[grid] + std::ceil(pose.position[grid] - reach * slack);
    const double last = origin[grid] + std::floor(pose.position[grid] + reach * slack);
    if (!(first >= -kWorkspaceRim && last <= kWorkspaceRim)) {
      throw Error("a tool at cell " + wholeText(first) + " to " + wholeText(last) + " on axis " +
                  "xyz"[grid] + " leaves the workspace of ±2^30 cells");
    }
    low[grid] = static_cast<std::int32_t>(first);
    high[grid] = static_cast<std::int32_t>(last);
  }
  return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

}  // namespace bozzetto
