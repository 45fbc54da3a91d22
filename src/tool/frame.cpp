#include <cmath>

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
  std::array<std::int64_t, 3> low, high;
  const std::array<std::int64_t, 3> origin{pose.origin.i, pose.origin.j, pose.origin.k};
  for (int grid = 0; grid < 3; ++grid) {
    double reach = 0;
    for (int axis = 0; axis < 3; ++axis)
      reach += std::abs(tidied(pose.orientation[axis][grid])) * pose.radii[axis];
    low[grid] = origin[grid] + std::llround(std::ceil(pose.position[grid] - reach * slack));
    high[grid] = origin[grid] + std::llround(std::floor(pose.position[grid] + reach * slack));
    if (low[grid] < -kWorkspaceRim || high[grid] > kWorkspaceRim) {
      throw Error("a tool at cell " + std::to_string(low[grid]) + " to " +
                  std::to_string(high[grid]) + " on axis " + "xyz"[grid] +
                  " leaves the workspace of ±2^30 cells");
    }
  }
  const auto key = [](const std::array<std::int64_t, 3>& at) {
    return Key{static_cast<std::int32_t>(at[0]), static_cast<std::int32_t>(at[1]),
               static_cast<std::int32_t>(at[2])};
  };
  return {key(low), key(high)};
}

}  // namespace bozzetto
