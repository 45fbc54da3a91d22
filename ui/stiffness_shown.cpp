#include "ui/stiffness_shown.hpp"

#include <cmath>

#include "bozzetto/field/block_cache.hpp"
#include "bozzetto/field/difference.hpp"

namespace bozzetto::ui {

std::vector<std::int8_t> stiffnessOn(const UnpackedPatch& patch, const clay::Stiffness& stiffness) {
  BlockCache<CornerBlock<8>> blocks(stiffness.painted->tree);
  std::vector<std::int8_t> tint;
  bool any = false;
  for (const glm::vec3& position : patch.positions) {
    const auto nearest = [&](int axis) { return std::int32_t(std::lround(position[axis])); };
    const Key corner = patch.origin + Key{nearest(0), nearest(1), nearest(2)};
    const CornerBlock<8>* block = blocks.find(BlockGeometry<8>::blockOf(corner));
    const int n = BlockGeometry<8>::indexOf(corner);
    const float offset = block ? clay::offsetOf(block->value[n], block->attributes[n]) : 0;
    tint.push_back(std::int8_t(std::lround(127 * offset)));
    any = any || tint.back() != 0;
  }
  if (!any) tint.clear();
  return tint;
}

CellBounds differenceOf(const clay::Stiffness& a, const clay::Stiffness& b) {
  const Clay none;
  CellBounds bounds;
  for (const KeyRun& run :
       differingBlocks(a.painted ? *a.painted : none, b.painted ? *b.painted : none)) {
    const glm::dvec3 low(run.key.i, run.key.j, run.key.k);
    bounds.add({low * 8.0 - 1.0, (low + glm::dvec3(1, 1, run.length)) * 8.0 + 1.0});
  }
  return bounds;
}

bool meet(const CellBounds& a, const CellBounds& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a.low[axis] > b.high[axis] || a.high[axis] < b.low[axis]) return false;
  return !a.empty() && !b.empty();
}

}  // namespace bozzetto::ui
