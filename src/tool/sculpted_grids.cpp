#include "tool/sculpted_grids.hpp"

#include <algorithm>
#include <cmath>

#include "tool/float_bits.hpp"
#include "tool/trilinear.hpp"

namespace bozzetto {

SculptedGrids::SculptedGrids(const ToolShape& tool, double rim) : sculpture_(tool.sculpture) {
  constexpr double widest = 128;
  const glm::dvec3 half = sculpture_->halfExtents();
  const double R = sculpture_->referenceRadius();
  const double cells = 2 * (std::max({half.x, half.y, half.z}) + rim * R + 2);
  const int toolLevel = levelFor(*sculpture_, tool.radii);
  level_ = std::max(toolLevel, static_cast<int>(std::ceil(std::log2(cells / widest))));
  level_ = std::clamp(level_, 0, Sculpture::kLevels);
  const double scale = std::ldexp(1.0, -level_);
  reach_ = static_cast<int>(std::ceil(rim * R * scale)) + 2;
  radius_ = R * scale;
  shrink_ = std::ldexp(1.0, toolLevel - level_);
  const Key base = baseOf(*sculpture_, toolLevel);
  base_ = shrink_ * glm::dvec3(base.i, base.j, base.k);
  contact_ = sculpture_->contact() * half / tool.radii;
}

GridRow SculptedGrids::rowsFrom(const LocalFrame& frame, Key low) const {
  const glm::vec3 offset = base_ - glm::dvec3(low.i, low.j, low.k);
  const auto perUnit = static_cast<float>(std::ldexp(shrink_, -kFractionBits));
  return {{}, frame.fixed.step[2], perUnit, {offset.x, offset.y, offset.z}, 1};
}

void SculptedGrids::begin(const LocalFrame& frame, Key corner, GridRow& row) {
  for (const Axis axis : kAxes) {
    const int a = index(axis);
    row.start[std::size_t(a)] = positionOn(frame.fixed, a, corner);
  }
}

}  // namespace bozzetto
