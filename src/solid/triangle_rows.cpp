#include "solid/triangle_rows.hpp"

#include <glm/geometric.hpp>

#include "solid/bit_select.hpp"

namespace bozzetto {

MeasuredTriangle::MeasuredTriangle(const std::array<glm::vec3, 3>& corners) : corner(corners) {
  normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const float length = glm::length(normal);
  normal = length > 0 ? normal / length : glm::vec3(0);
  for (std::size_t n = 0; n < 3; ++n) {
    side[n] = corners[(n + 1) % 3] - corners[n];
    inward[n] = glm::cross(normal, side[n]);
    const float squared = glm::dot(side[n], side[n]);
    inverse[n] = squared > 0 ? 1 / squared : 0;
  }
  // A needle is its sides: everything lies beyond one of them.
  if (length <= 0) inward[0] = {0, 0, 0};
}

namespace {

// Square of the distance to one side, and whether the place lies beyond it.
BOZZETTO_KERNEL void measureSide(const MeasuredTriangle& t, std::size_t n, glm::vec3 place,
                                 float& nearest, std::int32_t& beyond) {
  const float x = place.x - t.corner[n].x, y = place.y - t.corner[n].y, z = place.z - t.corner[n].z;
  const glm::vec3& side = t.side[n];
  const float along = atLeastZero((x * side.x + y * side.y + z * side.z) * t.inverse[n]);
  const float u = lesserOf(along, 1.0f);
  const float dx = x - u * side.x, dy = y - u * side.y, dz = z - u * side.z;
  nearest = lesserOf(nearest, dx * dx + dy * dy + dz * dz);
  const glm::vec3& inward = t.inward[n];
  beyond |= negativeMask(x * inward.x + y * inward.y + z * inward.z);
}

BOZZETTO_KERNEL void lowerRow(const MeasuredTriangle& t, float i, float j, float* squared) {
  for (int k = 0; k < 8; ++k) {
    const glm::vec3 place(i, j, static_cast<float>(k));
    float nearest = 1e30f;
    std::int32_t beyond = 0;
    for (std::size_t n = 0; n < 3; ++n) measureSide(t, n, place, nearest, beyond);
    const float height = (place.x - t.corner[0].x) * t.normal.x +
                         (place.y - t.corner[0].y) * t.normal.y +
                         (place.z - t.corner[0].z) * t.normal.z;
    squared[k] = lesserOf(squared[k], select(beyond, nearest, height * height));
  }
}

BOZZETTO_KERNEL void lowerRows(const MeasuredTriangle& triangle, const KeyBox& rows,
                               SquaredDistances& squared) {
  for (int i = rows.low.i; i <= rows.high.i; ++i)
    for (int j = rows.low.j; j <= rows.high.j; ++j)
      lowerRow(triangle, static_cast<float>(i), static_cast<float>(j), &squared[(i * 8 + j) * 8]);
}

}  // namespace

BOZZETTO_SIMD_DISPATCH(void, lowerDistances, lowerRows,
                       (const MeasuredTriangle& triangle, const KeyBox& rows,
                        SquaredDistances& squared),
                       (triangle, rows, squared))

}  // namespace bozzetto
