// A straight line from cell to cell through their faces, so that it slips between no two cells that
// meet in an edge.
#pragma once
#include <array>
#include <cstdlib>

#include "bozzetto/base/axis.hpp"
#include "bozzetto/grid/key.hpp"

namespace bozzetto::clay {

class LineOfCells {
 public:
  /// `way`: not all 0, each below 2¹⁵ in size.
  LineOfCells(const Key& way, const std::array<std::ptrdiff_t, 3>& strides)
      : way_(way), strides_(strides) {}

  /// The step to the next cell: along the axis that lags most behind.
  std::ptrdiff_t step() {
    Axis best = kAxes[0];
    for (const Axis axis : kAxes)
      if (way_[axis] != 0 && (way_[best] == 0 || lags(axis, best))) best = axis;
    ++done_[best];
    const std::ptrdiff_t stride = strides_[std::size_t(index(best))];
    return way_[best] < 0 ? -stride : stride;
  }

 private:
  bool lags(Axis a, Axis b) const {
    return std::int64_t{2 * done_[a] + 1} * std::abs(way_[b]) <
           std::int64_t{2 * done_[b] + 1} * std::abs(way_[a]);
  }

  Key way_, done_{};
  std::array<std::ptrdiff_t, 3> strides_;
};

}  // namespace bozzetto::clay
