// Corner I of the copy is the mean of fine corners 2I−1…2I+1 with weights [1 2 1]/4 along each
// axis: on the fine lattice's own places, and wide enough for slopes of two fine cells.
#include "render/coarse_clay.hpp"

#include <algorithm>
#include <iterator>

#include "bozzetto/base/parallel.hpp"
#include "bozzetto/field/block_cache.hpp"
#include "bozzetto/grid/edit.hpp"

namespace bozzetto {
namespace {

using Block = Clay::Block;
using Geometry = Clay::Geometry;
constexpr int kSide = 8;

// Fine corners under one coarse block, with one more on each low side: 17³ from corner 2I − 1 on.
class FineCorners {
 public:
  static constexpr int kRow = 2 * kSide + 1;
  FineCorners(const Clay& clay, Key coarseBlock);

  std::size_t at(int i, int j, int k) const { return std::size_t((i * kRow + j) * kRow + k); }
  std::vector<float> value;
  std::vector<Attributes> attributes;
  const Block* uniform = nullptr;  // the one block that all corners lie in, interned

 private:
  void copy(const Block& block, Key low, Key from);
};

FineCorners::FineCorners(const Clay& clay, Key coarseBlock)
    : value(std::size_t(kRow) * kRow * kRow), attributes(value.size()) {
  const Key low = coarseBlock * (2 * kSide) - Key{1, 1, 1};
  const Key first = Geometry::blockOf(low);
  BlockCache<Block> blocks(clay.tree);
  uniform = blocks.find(first);
  for (int n = 0; n < 27; ++n) {
    const Key key = first + Key{n / 9, n / 3 % 3, n % 3};
    const Block* block = blocks.find(key);
    if (block != uniform) uniform = nullptr;
    if (block != nullptr) copy(*block, low, Geometry::firstCornerOf(key));
  }
  if (uniform != nullptr && !uniform->interned) uniform = nullptr;
}

void FineCorners::copy(const Block& block, Key low, Key from) {
  const auto begin = [](std::int32_t a, std::int32_t b) { return std::max(a, b); };
  const auto end = [](std::int32_t a, std::int32_t b) { return std::min(a + kRow, b + kSide); };
  for (std::int32_t i = begin(low.i, from.i); i < end(low.i, from.i); ++i) {
    for (std::int32_t j = begin(low.j, from.j); j < end(low.j, from.j); ++j) {
      for (std::int32_t k = begin(low.k, from.k); k < end(low.k, from.k); ++k) {
        const auto source = std::size_t(Geometry::indexOf({i, j, k}));
        const std::size_t target = at(i - low.i, j - low.j, k - low.k);
        value[target] = block.value[source];
        attributes[target] = block.attributes[source];
      }
    }
  }
}

// Mean density about a place, and the attributes of its densest corner.
void mean(const FineCorners& fine, std::size_t centre, float& value, Attributes& attributes) {
  constexpr float weight[3] = {.25f, .5f, .25f};
  float sum = 0, densest = -1;
  for (int n = 0; n < 27; ++n) {
    const int i = n / 9 - 1, j = n / 3 % 3 - 1, k = n % 3 - 1;
    const std::size_t at =
        std::size_t(std::ptrdiff_t(centre) + (i * FineCorners::kRow + j) * FineCorners::kRow + k);
    const float v = fine.value[at];
    sum += v * weight[i + 1] * weight[j + 1] * weight[k + 1];
    if (v > densest || (v == densest && at == centre)) {
      densest = v;
      attributes = fine.attributes[at];
    }
  }
  value = sum;
}

Ref<Block> halved(const FineCorners& fine, Ref<Block> block) {
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      for (int k = 0; k < kSide; ++k) {
        const auto at = std::size_t(Geometry::indexOf(i, j, k));
        mean(fine, fine.at(2 * i + 1, 2 * j + 1, 2 * k + 1), block->value[at],
             block->attributes[at]);
      }
    }
  }
  block->updateRange();
  return block;
}

// Coarse blocks that a run of fine ones is felt in.
void addTouched(KeyRun run, std::set<Key>& blocks) {
  const auto low = [](std::int32_t b) { return b >> 1; };
  const auto high = [](std::int32_t b) { return (b + 1) >> 1; };
  const Key& key = run.key;
  for (std::int32_t i = low(key.i); i <= high(key.i); ++i) {
    for (std::int32_t j = low(key.j); j <= high(key.j); ++j) {
      for (std::int32_t k = low(key.k); k <= high(key.k + run.length - 1); ++k) {
        blocks.insert({i, j, k});
      }
    }
  }
}

bool tooLarge(const Clay& clay) {
  std::int64_t sum = 0;
  for (const auto& [key, run] : clay.tree) sum += run.length;
  return sum > CoarseClay::kMostBlocks;
}

}  // namespace

std::vector<Key> CoarseClay::rebuild(const Clay& clay) {
  std::vector<Key> before;
  for (const auto& [block, run] : surface_.patches()) before.push_back(block);
  clay_ = Clay{{}, clay.scale};
  surface_ = Surface<8>();
  std::set<Key> blocks;
  if (!tooLarge(clay)) {
    for (const auto& [key, run] : clay.tree) addTouched({key, run.length}, blocks);
  }
  const std::vector<Key> made = update(clay, blocks);
  std::vector<Key> changed;
  std::set_union(before.begin(), before.end(), made.begin(), made.end(),
                 std::back_inserter(changed));
  return changed;
}

std::vector<Key> CoarseClay::refresh(const Clay& clay, std::span<const KeyRun> changed) {
  if (tooLarge(clay)) return {};
  std::set<Key> blocks;
  for (const KeyRun& run : changed) addTouched(run, blocks);
  return update(clay, blocks);
}

std::vector<Key> CoarseClay::update(const Clay& clay, const std::set<Key>& blocks) {
  clay_.scale = clay.scale;
  Edit<Block> edit(clay_.tree);
  const std::vector<Key> keys(blocks.begin(), blocks.end());
  std::vector<Ref<Block>> made(keys.size());
  for (Ref<Block>& block : made) block = edit.fresh();
  parallelFor(keys.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const FineCorners fine(clay, keys[n]);
      made[n] = fine.uniform != nullptr
                    ? Block::uniform(fine.uniform->value[0], fine.uniform->attributes[0])
                    : halved(fine, std::move(made[n]));
    }
  });
  for (std::size_t n = 0; n < keys.size(); ++n) edit.replace({keys[n], 1}, made[n]);
  const Delta<Block> delta = edit.commit();
  return surface_.refresh(clay_, delta.keys()).changed;
}

UnpackedPatch CoarseClay::patch(Key block) const {
  const Key origin = block * (2 * kSide);
  const SurfacePatch* found = surface_.patches().find(block);
  UnpackedPatch patch = found == nullptr ? UnpackedPatch(origin) : UnpackedPatch(origin, *found);
  for (glm::vec3& p : patch.positions) p *= 2.f;
  patch.fineness = Fineness::coarse;
  return patch;
}

}  // namespace bozzetto
