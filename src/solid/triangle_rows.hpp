// Distances from the corners of a block to a triangle, a row of eight at a time.
#pragma once
#include <array>
#include <glm/vec3.hpp>

#include "bozzetto/grid/key.hpp"

namespace bozzetto {

/// Squared distances of 8×8×8 corners, in cells.
using SquaredDistances = std::array<float, 512>;

/// A triangle relative to the first corner of a block, ready to be measured from many places.
struct MeasuredTriangle {
  std::array<glm::vec3, 3> corner, side, inward;
  std::array<float, 3> inverse;  ///< 1 / side²
  glm::vec3 normal;              ///< of length 1; 0 for needles

  explicit MeasuredTriangle(const std::array<glm::vec3, 3>& corners);
};

/// Lowers the distances of the rows (i, j) of `rows` to those of the triangle.
void lowerDistances(const MeasuredTriangle& triangle, const KeyBox& rows,
                    SquaredDistances& squared);

}  // namespace bozzetto
