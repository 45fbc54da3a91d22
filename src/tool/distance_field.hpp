// Distances to a sculpted tool's surface, outside of it, on a grid of their own.
#pragma once
#include <array>
#include <vector>

#include "bozzetto/field/field.hpp"
#include "tool/grid_rows.hpp"

namespace bozzetto {

/// Made once for a tool: O(cells of its box and `reach` cells round it).
class DistanceField {
 public:
  DistanceField(const Clay& clay, const KeyBox& bounds, float iso, int reach);

  /// Distances along a row of up to 8 places: in cells × scale, trilinear. Beyond the grid the
  /// nearest value.
  void row(const GridRow& places, int count, float* distance) const;
  const Key& low() const { return low_; }

 private:
  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(i) * static_cast<std::size_t>(wide_[1]) +
            static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(wide_[2]) +
           static_cast<std::size_t>(k);
  }
  void beginAtSurface(float iso);

  Key low_;
  std::array<int, 3> wide_{};
  std::vector<float> density_, distance_;
  std::vector<std::uint8_t> fixed_;
};

}  // namespace bozzetto
