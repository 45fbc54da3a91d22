// The part of clay that a lasso holds.
#include <cmath>

#include "bozzetto/base/parallel.hpp"
#include "bozzetto/tool/sculpture.hpp"
#include "tool/share.hpp"

namespace bozzetto {
namespace {

using Block = CornerBlock<8>;
using Geometry = BlockGeometry<8>;

struct Found {
  Key key;
  Ref<Block> block;
};

// What is held of one block.
Ref<Block> heldCorners(const Block& block, Key key, const Lasso& lasso, double spacing) {
  Ref<Block> copy(new Block(block));
  const Key first = Geometry::firstCornerOf(key);
  for (int n = 0; n < Geometry::kCount; ++n) {
    const Key corner = first + Key{n >> 6, n >> 3 & 7, n & 7};
    const glm::dvec3 place = glm::dvec3(corner.i, corner.j, corner.k) * spacing;
    float& value = copy->value[static_cast<std::size_t>(n)];
    value -= restOf(value, static_cast<float>(lasso.share(place, spacing)));
    if (value == 0) copy->attributes[static_cast<std::size_t>(n)] = 0;
  }
  return Block::canonical(std::move(copy));
}

Ref<Block> heldPart(const Found& found, const Lasso& lasso, double spacing) {
  const Key first = Geometry::firstCornerOf(found.key);
  const glm::dvec3 middle = (glm::dvec3(first.i, first.j, first.k) + 3.5) * spacing;
  switch (coverageOf(lasso, middle, (3.5 * std::sqrt(3.0) + 1) * spacing * (1 + 1e-9))) {
    case Coverage::none:
      return nullptr;
    case Coverage::all:
      return found.block;
    case Coverage::some:
      break;
  }
  return heldCorners(*found.block, found.key, lasso, spacing);
}

}  // namespace

Clay partOf(const Clay& clay, const KeyBox& box, const Lasso& lasso) {
  requireValid(lasso);
  const Clay inside = partOf(clay, box);
  std::vector<Found> blocks;
  for (const auto& [key, run] : inside.tree)
    for (std::int32_t n = 0; n < run.length; ++n) blocks.push_back({key + Key{0, 0, n}, run.block});
  parallelFor(blocks.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
      blocks[n].block = heldPart(blocks[n], lasso, clay.scale.spacing);
  });
  Clay part;
  part.scale = clay.scale;
  for (Found& found : blocks)
    if (found.block) part.tree.put(found.key, std::move(found.block));
  return part;
}

}  // namespace bozzetto
