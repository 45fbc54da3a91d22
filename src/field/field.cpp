#include "bozzetto/field/field.hpp"

#include <unordered_set>

namespace bozzetto {
namespace {

template <int Side>
void growBounds(KeyBox& bounds, Key block, std::int32_t length, const CornerBlock<Side>& content) {
  using Geometry = BlockGeometry<Side>;
  const Key first = Geometry::firstCornerOf(block);
  const auto grow = [&](Key corner) {
    if (bounds.empty()) bounds = {corner, corner};
    for (const Axis axis : kAxes) {
      bounds.low[axis] = std::min(bounds.low[axis], corner[axis]);
      bounds.high[axis] = std::max(bounds.high[axis], corner[axis]);
    }
  };
  if (content.low > 0) {
    grow(first);
    grow(first + Key{Side - 1, Side - 1, Side * length - 1});
    return;
  }
  for (int n = 0; n < content.kCount; ++n) {
    if (content.value[n] > 0) {
      grow(first + Key{n / (Side * Side), n / Side % Side, n % Side});
    }
  }
}

template <int Side>
std::int64_t cornersWithClay(const CornerBlock<Side>& block) {
  if (block.low > 0) return block.kCount;
  std::int64_t count = 0;
  for (const float value : block.value) count += value > 0 ? 1 : 0;
  return count;
}

template <int To, int From>
void copyCorners(Key key, const Run<CornerBlock<From>>& run, Edit<CornerBlock<To>>& edit) {
  const Key first = BlockGeometry<From>::firstCornerOf(key);
  for (std::int32_t n = 0; n < run.length * run.block->kCount; ++n) {
    const int in = n % run.block->kCount;
    if (run.block->value[in] <= 0) continue;
    const Key local{in / (From * From), in / From % From, in % From + n / run.block->kCount * From};
    const Key corner = first + local;
    CornerBlock<To>& block = edit.write(BlockGeometry<To>::blockOf(corner));
    block.value[BlockGeometry<To>::indexOf(corner)] = run.block->value[in];
    block.attributes[BlockGeometry<To>::indexOf(corner)] = run.block->attributes[in];
  }
}

}  // namespace

template <int Side>
float Field<Side>::value(Key corner) const {
  const Block* block = tree.find(Geometry::blockOf(corner));
  return block == nullptr ? 0.0f : block->value[Geometry::indexOf(corner)];
}

template <int Side>
Attributes Field<Side>::attributes(Key corner) const {
  const Block* block = tree.find(Geometry::blockOf(corner));
  return block == nullptr ? 0 : block->attributes[Geometry::indexOf(corner)];
}

template <int Side>
MassSum massUnits(const Field<Side>& field) {
  MassSum sum = 0;
  for (const auto& [key, run] : field.tree) {
    sum += static_cast<MassSum>(run.block->mass) * run.length;
  }
  return sum;
}

template <int Side>
FieldStatistics statistics(const Field<Side>& field) {
  FieldStatistics result;
  std::unordered_set<const void*> interned;
  for (const auto& [key, run] : field.tree) {
    result.corners += cornersWithClay(*run.block) * run.length;
    growBounds<Side>(result.bounds, key, run.length, *run.block);
    if (!run.block->interned || interned.insert(run.block.get()).second) ++result.blocks;
  }
  const double cell = field.scale.spacing;
  result.nodes = field.tree.nodeCount();
  result.bytes = field.tree.nodeBytes() + result.blocks * sizeof(CornerBlock<Side>);
  result.mass = static_cast<double>(massUnits(field)) * kMassUnit * cell * cell * cell;
  return result;
}

template <int To, int From>
Field<To> withSide(const Field<From>& field) {
  if constexpr (To == From) return field;
  Field<To> result{{}, field.scale};
  Edit<CornerBlock<To>> edit(result.tree);
  for (const auto& [key, run] : field.tree) copyCorners(key, run, edit);
  edit.commit();
  return result;
}

template struct Field<1>;
template struct Field<8>;
template FieldStatistics statistics(const Field<1>&);
template FieldStatistics statistics(const Field<8>&);
template MassSum massUnits(const Field<1>&);
template MassSum massUnits(const Field<8>&);
template Field<1> withSide<1, 8>(const Field<8>&);
template Field<8> withSide<8, 1>(const Field<1>&);
template Field<1> withSide<1, 1>(const Field<1>&);
template Field<8> withSide<8, 8>(const Field<8>&);

}  // namespace bozzetto
