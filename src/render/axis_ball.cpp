// The axis ball: where the six half axes point on the screen, and what clicking one does.
#include <algorithm>
#include <glm/matrix.hpp>
#include <numbers>

#include "bozzetto/render/overlays.hpp"

namespace bozzetto {

std::array<AxisEnd, 6> axisEnds(const Camera& camera) {
  const glm::dmat3 viewFromWorld = glm::transpose(camera.worldFromView());
  std::array<AxisEnd, 6> ends;
  for (int n = 0; n < 6; ++n) {
    const bool positive = n % 2 == 0;
    const glm::dvec3 seen = viewFromWorld[n / 2] * (positive ? 1.0 : -1.0);
    ends[std::size_t(n)] = {n / 2, positive, {seen.x, -seen.y}, seen.z};
  }
  std::stable_sort(ends.begin(), ends.end(),
                   [](const AxisEnd& a, const AxisEnd& b) { return a.depth < b.depth; });
  return ends;
}

Camera lookingFrom(const AxisEnd& end, Camera camera) {
  constexpr double quarter = std::numbers::pi / 2;
  const double sign = end.positive ? 1 : -1;
  camera.roll = 0;
  camera.pitch = end.axis == 1 ? sign * quarter : 0;
  camera.yaw = end.axis == 0 ? sign * quarter : end.axis == 2 && !end.positive ? 2 * quarter : 0;
  return camera;
}

}  // namespace bozzetto
