#include "bozzetto/field/smoothed.hpp"

#include <algorithm>
#include <vector>

#include "bozzetto/base/parallel.hpp"
#include "bozzetto/field/block_cache.hpp"

namespace bozzetto {
namespace {

using Block = CornerBlock<8>;
constexpr int kSide = 8, kReach = kSide + 2;  // a block and a corner more on every side

// A block with the 26 round it, null where nothing is stored.
struct Neighbourhood {
  std::array<const Block*, 27> blocks;

  Neighbourhood(BlockCache<Block>& cache, Key key) {
    for (std::int32_t n = 0; n < 27; ++n)
      blocks[static_cast<std::size_t>(n)] =
          cache.find(key + Key{n / 9 - 1, n / 3 % 3 - 1, n % 3 - 1});
  }
  bool allOne() const {
    return (blocks[0] == nullptr || blocks[0]->interned) &&
           std::all_of(blocks.begin(), blocks.end(),
                       [&](const Block* block) { return block == blocks[0]; });
  }
  // Local coordinates −1 … 8.
  const Block* at(Key local, int& index) const {
    index = BlockGeometry<kSide>::indexOf(local.i & 7, local.j & 7, local.k & 7);
    const std::int32_t n = ((local.i >> 3) + 1) * 9 + ((local.j >> 3) + 1) * 3 + (local.k >> 3) + 1;
    return blocks[static_cast<std::size_t>(n)];
  }
  float value(Key local) const {
    int index;
    const Block* block = at(local, index);
    return block == nullptr ? 0.0f : block->value[static_cast<std::size_t>(index)];
  }
  Attributes attributes(Key local) const {
    int index;
    const Block* block = at(local, index);
    return block == nullptr ? 0 : block->attributes[static_cast<std::size_t>(index)];
  }
};

using Values = std::array<float, kReach * kReach * kReach>;

Values gathered(const Neighbourhood& around) {
  Values values;
  std::size_t n = 0;
  for (std::int32_t i = -1; i <= kSide; ++i)
    for (std::int32_t j = -1; j <= kSide; ++j)
      for (std::int32_t k = -1; k <= kSide; ++k) values[n++] = around.value({i, j, k});
  return values;
}

// [1 2 1]/4 along an axis; what is beyond the array's ends is left as it was, and not asked for.
void filter(Values& values, std::size_t step) {
  const Values old = values;
  for (std::size_t n = step; n + step < values.size(); ++n)
    values[n] = 0.25f * (old[n - step] + old[n + step]) + 0.5f * old[n];
}

Attributes densestAround(const Neighbourhood& around, Key local) {
  float most = 0;
  Attributes found = 0;
  for (std::int32_t n = 0; n < 27; ++n) {
    const Key next = local + Key{n / 9 - 1, n / 3 % 3 - 1, n % 3 - 1};
    const float value = around.value(next);
    if (value > most) most = value, found = around.attributes(next);
  }
  return found;
}

Ref<Block> smoothedBlock(const Neighbourhood& around) {
  Values values = gathered(around);
  for (const std::size_t step : {kReach * kReach, kReach, 1}) filter(values, step);
  Ref<Block> block(new Block());
  for (std::int32_t n = 0; n < Block::kCount; ++n) {
    const Key local{n / 64, n / 8 % 8, n % 8};
    const auto at = static_cast<std::size_t>(n);
    block->value[at] = values[static_cast<std::size_t>(
        ((local.i + 1) * kReach + local.j + 1) * kReach + local.k + 1)];
    if (block->value[at] <= 0) continue;
    block->attributes[at] =
        around.value(local) > 0 ? around.attributes(local) : densestAround(around, local);
  }
  block->updateRange();
  return Block::canonical(std::move(block));
}

// These blocks and those beside them, each once.
std::vector<Key> around(std::vector<KeyRun> runs) {
  const std::size_t count = runs.size();
  runs.reserve(count * 9);
  for (std::size_t n = 0; n < count; ++n)
    for (std::int32_t m = 0; m < 9; ++m)
      runs.push_back({runs[n].key + Key{m / 3 - 1, m % 3 - 1, -1}, runs[n].length + 2});
  std::vector<Key> keys;
  for (const KeyRun& run : withoutOverlaps(std::move(runs)))
    for (std::int32_t k = 0; k < run.length; ++k) keys.push_back(run.key + Key{0, 0, k});
  return keys;
}

// What the copy is to have there, null for nothing. Among its like a block is shared.
std::vector<Ref<Block>> smoothedAt(const Clay& field, const std::vector<Key>& keys) {
  std::vector<Ref<Block>> made(keys.size());
  parallelFor(keys.size(), 16, [&](std::size_t begin, std::size_t end) {
    BlockCache<Block> cache(field.tree);
    for (std::size_t n = begin; n < end; ++n) {
      const Neighbourhood near(cache, keys[n]);
      made[n] = near.allOne() ? Ref<Block>(field.tree.find(keys[n])) : smoothedBlock(near);
    }
  });
  return made;
}

bool areSame(const Block* a, const Block* b) {
  return a == b || (a != nullptr && b != nullptr && a->sameAs(*b));
}

}  // namespace

std::vector<KeyRun> refreshSmoothed(Clay& copy, const Clay& field,
                                    std::span<const KeyRun> changed) {
  copy.scale = field.scale;
  const std::vector<Key> keys = around({changed.begin(), changed.end()});
  std::vector<Ref<Block>> made = smoothedAt(field, keys);
  std::vector<KeyRun> altered;
  for (std::size_t n = 0; n < keys.size(); ++n) {
    if (areSame(made[n].get(), copy.tree.find(keys[n]))) continue;
    altered.push_back({keys[n], 1});
    if (made[n])
      copy.tree.put(keys[n], std::move(made[n]));
    else
      copy.tree.erase(keys[n]);
  }
  return altered;
}

Clay smoothed(const Clay& field) {
  std::vector<KeyRun> stored;
  for (const auto& [first, run] : field.tree) stored.push_back({first, run.length});
  Clay result = field;
  refreshSmoothed(result, field, stored);
  return result;
}

}  // namespace bozzetto
