// The room that a sculpted tool and its handle take: the tool, and all that lies behind it as seen
// from the clay it touches.
#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "bozzetto/field/field.hpp"
#include "tool/grid_rows.hpp"

namespace bozzetto {

/// At every corner the most of the tool from there on towards the clay. Made once for a tool:
/// O(cells of its box and `reach` cells round it).
class HandleRoom {
 public:
  /// `contact`: towards the clay, in the tool's cells, of any length but 0.
  HandleRoom(const Clay& clay, const KeyBox& bounds, const glm::dvec3& contact, int reach);

  /// Along a row of up to 8 places, trilinear. Beyond the grid the nearest value.
  void row(const GridRow& places, int count, float* room) const {
    readRow(room_.data(), wide_, places, count, room);
  }
  const Key& low() const { return low_; }

 private:
  Key low_;
  std::array<int, 3> wide_{};
  std::vector<float> room_;
};

}  // namespace bozzetto
