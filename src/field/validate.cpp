#include <cmath>

#include "bozzetto/field/field.hpp"

namespace bozzetto {
namespace {

// Some corner with clay has other attributes than those said to be its only ones.
template <int Side>
bool hasOther(const CornerBlock<Side>& block) {
  for (int n = 0; n < block.kCount; ++n) {
    if (block.value[n] > 0 && block.attributes[n] != block.only) return true;
  }
  return false;
}

template <int Side>
std::optional<std::string> faultOf(const CornerBlock<Side>& block) {
  for (int n = 0; n < block.kCount; ++n) {
    if (!std::isfinite(block.value[n]) || block.value[n] < 0) return "value not finite and ≥ 0";
    if (block.value[n] == 0 && block.attributes[n] != 0) return "attributes without clay";
  }
  CornerBlock<Side> copy(block);
  copy.updateRange();
  if (copy.low != block.low || copy.high != block.high) return "range out of date";
  if (block.high <= 0) return "empty block stored";
  if (block.settled && block.oneColour && hasOther(block)) return "a second colour";
  const auto canonical =
      CornerBlock<Side>::canonical(Ref<CornerBlock<Side>>(new CornerBlock<Side>(block)));
  if (canonical->interned != block.interned) return "uniform block not interned";
  if (canonical->mass != block.mass) return "mass out of date";
  return std::nullopt;
}

}  // namespace

template <int Side>
std::optional<std::string> validate(const Field<Side>& field) {
  if (auto fault = field.tree.validate()) return fault;
  for (const auto& [key, run] : field.tree) {
    if (!run.block) return "null block at " + toText(key);
    if (run.length > 1 && !run.block->interned) return "run of an own block at " + toText(key);
    if (auto fault = faultOf(*run.block)) return *fault + " in block " + toText(key);
  }
  return std::nullopt;
}

template std::optional<std::string> validate(const Field<1>&);
template std::optional<std::string> validate(const Field<8>&);

}  // namespace bozzetto
