#include "bozzetto/clay/stiffness.hpp"

#include <algorithm>
#include <cmath>

#include "bozzetto/base/error.hpp"
#include "bozzetto/field/block_cache.hpp"

namespace bozzetto::clay {
namespace {

template <int Side>
float densityAt(BlockCache<CornerBlock<Side>>& blocks, Key corner) {
  using Geometry = BlockGeometry<Side>;
  const CornerBlock<Side>* block = blocks.find(Geometry::blockOf(corner));
  return block == nullptr ? 0.0f : block->value[Geometry::indexOf(corner)];
}

template <int Side>
void keepOnClay(Edit<CornerBlock<8>>& painted, Key block, BlockCache<CornerBlock<Side>>& clay) {
  const CornerBlock<8>* old = painted.read(block);
  if (old == nullptr) return;
  std::array<bool, CornerBlock<8>::kCount> bare;
  bool any = false;
  const Key first = BlockGeometry<8>::firstCornerOf(block);
  for (int n = 0; n < CornerBlock<8>::kCount; ++n) {
    const Key corner = first + Key{n / 64, n / 8 % 8, n % 8};
    bare[n] = old->value[n] > 0 && densityAt<Side>(clay, corner) <= 0;
    any = any || bare[n];
  }
  if (!any) return;
  CornerBlock<8>& target = painted.write(block);
  for (int n = 0; n < CornerBlock<8>::kCount; ++n)
    if (bare[n]) target.value[n] = 0, target.attributes[n] = 0;
  target.updateRange();
}

// Until the first block that differs; what both share is not read.
bool sameContent(const KeyTree<CornerBlock<8>>& a, const KeyTree<CornerBlock<8>>& b) {
  auto one = a.begin(), other = b.begin();
  std::int32_t into = 0, intoOther = 0;  // their runs
  while (one != a.end() && other != b.end()) {
    const auto& [key, run] = *one;
    const auto& [otherKey, otherRun] = *other;
    if (key + Key{0, 0, into} != otherKey + Key{0, 0, intoOther}) return false;
    if (!(run.block == otherRun.block) && !run.block->sameAs(*otherRun.block)) return false;
    const std::int32_t both = std::min(run.length - into, otherRun.length - intoOther);
    into += both;
    intoOther += both;
    if (into == run.length) ++one, into = 0;
    if (intoOther == otherRun.length) ++other, intoOther = 0;
  }
  return one == a.end() && other == b.end();
}

}  // namespace

double Stiffness::at(Key corner) const {
  if (!painted) return 0;
  return offsetOf(painted->value(corner), painted->attributes(corner));
}

bool operator==(const Stiffness& a, const Stiffness& b) {
  if (a.painted == b.painted) return true;
  if (a.any() != b.any()) return false;
  return !a.any() ||
         (a.painted->scale == b.painted->scale && sameContent(a.painted->tree, b.painted->tree));
}

Stiffness stiffnessOf(Clay painted) {
  if (painted.tree.empty()) return {};
  return {std::make_shared<const Clay>(std::move(painted))};
}

void requireValid(const Stiffness& stiffness, const std::string& name) {
  if (!stiffness.any()) return;
  for (const auto& [key, run] : stiffness.painted->tree)
    for (const float value : run.block->value)
      if (!(value >= 0 && value <= 1)) {
        throw Error(name + ": stiffness offset " + std::to_string(value) + " found in block " +
                    toText(key) + ", a number in 0…1 expected");
      }
}

template <int Side>
void keepOnClay(Edit<CornerBlock<8>>& painted, std::span<const KeyRun> blocks,
                const KeyTree<CornerBlock<Side>>& clay) {
  BlockCache<CornerBlock<Side>> cache(clay);
  for (const KeyRun& run : blocks)
    for (std::int32_t n = 0; n < run.length; ++n)
      keepOnClay<Side>(painted, run.key + Key{0, 0, n}, cache);
}

template void keepOnClay(Edit<CornerBlock<8>>&, std::span<const KeyRun>,
                         const KeyTree<CornerBlock<1>>&);
template void keepOnClay(Edit<CornerBlock<8>>&, std::span<const KeyRun>,
                         const KeyTree<CornerBlock<8>>&);

}  // namespace bozzetto::clay
