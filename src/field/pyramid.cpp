#include "bozzetto/field/pyramid.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <map>
#include <mutex>
#include <unordered_set>

#include "bozzetto/base/parallel.hpp"
#include "bozzetto/grid/block_pool.hpp"
#include "field/column_sweep.hpp"
#include "field/halve.hpp"

namespace bozzetto {
namespace {

using Block = DensityBlock;

// The shared blocks of equal densities. Those nobody uses any more go when there are many.
class UniformBlocks {
 public:
  Ref<Block> get(float value) {
    if (value == 0) return nullptr;
    const std::lock_guard lock(mutex_);
    if (blocks_.size() >= limit_) dropUnused();
    Ref<Block>& block = blocks_[std::bit_cast<std::uint32_t>(value)];
    if (!block) {
      block = Ref<Block>(new Block());
      block->value.fill(value);
      block->uniform = true;
    }
    return block;
  }

 private:
  void dropUnused() {
    std::erase_if(blocks_, [](const auto& entry) { return entry.second->holders() == 1; });
    limit_ = std::max<std::size_t>(1024, 2 * blocks_.size());
  }
  std::mutex mutex_;
  std::map<std::uint32_t, Ref<Block>> blocks_;
  std::size_t limit_ = 1024;
};

UniformBlocks& uniformBlocks() {
  static auto* const table = new UniformBlocks();  // outlives every static pyramid
  return *table;
}

Ref<Block> canonical(Ref<Block> block) {
  for (const float value : block->value) {
    if (value != block->value[0]) return block;
  }
  return uniformBlocks().get(block->value[0]);
}

bool isUniform(const CornerBlock<8>* block) { return block == nullptr || block->interned; }
bool isUniform(const Block* block) { return block == nullptr || block->uniform; }

// One block of the level above from the 4×4×4 blocks that it averages.
template <class Source>
Ref<Block> halved(const std::array<const Source*, 64>& sources) {
  const Source* first = sources[0];
  const bool alike = std::all_of(sources.begin(), sources.end(),
                                 [&](const Source* source) { return source == first; });
  if (alike && isUniform(first)) return first ? uniformBlocks().get(first->value[0]) : nullptr;
  std::array<const float*, 64> values;
  for (std::size_t n = 0; n < 64; ++n) values[n] = sources[n] ? sources[n]->value.data() : nullptr;
  Ref<Block> block(new Block());
  halve(values, block->value);
  return canonical(std::move(block));
}

// What a changed run of blocks means for the level above, in block keys; unsorted, overlapping.
std::vector<KeyRun> dependents(std::span<const KeyRun> changed) {
  const auto low = [](std::int32_t n) { return (n - 1) >> 1; };
  const auto high = [](std::int32_t n) { return (n + 1) >> 1; };
  std::vector<KeyRun> result;
  result.reserve(4 * changed.size());
  for (const KeyRun& run : changed) {
    const std::int32_t k = low(run.key.k);
    const std::int32_t length = high(run.key.k + run.length - 1) - k + 1;
    for (const std::int32_t i : {low(run.key.i), high(run.key.i)}) {
      for (const std::int32_t j : {low(run.key.j), high(run.key.j)}) {
        result.push_back({{i, j, k}, length});
      }
    }
  }
  return result;
}

struct Piece {
  KeyRun run;
  Ref<Block> block;
  bool changed = true;
};

// Computes the blocks of one run of the level above. Where all source columns stay in one run each
// (or in a gap), one block stands for the whole stretch.
template <class Source>
std::vector<Piece> halveRun(const KeyTree<Source>& below, const KeyRun& run) {
  constexpr Key kBefore{1, 1, 1};
  ColumnSweep<Source, 4> sweep(below, run.key * 2 - kBefore);
  std::vector<Piece> pieces;
  const std::int32_t end = run.key.k + run.length;
  for (std::int32_t k = run.key.k; k < end;) {
    std::array<const Source*, 64> sources;
    const std::int32_t steady = sweep.window(2 * k - 1, sources);
    // The window of block K ends before 2K + 3.
    const std::int32_t last = (steady - 3) >> 1;
    const std::int32_t next = std::clamp(last + 1, k + 1, end);
    pieces.push_back({{{run.key.i, run.key.j, k}, next - k}, halved(sources)});
    k = next;
  }
  return pieces;
}

bool equal(const Block* a, const Block* b) {
  if (a == b) return true;
  return a != nullptr && b != nullptr && std::memcmp(&a->value, &b->value, sizeof a->value) == 0;
}

// Leaves what is already there, so that the levels above are spared too.
void markUnchanged(const DensityTree& tree, Piece& piece) {
  const auto node = tree.at(piece.run.key);
  const bool absent = node == tree.end();
  if (piece.run.length == 1) {
    piece.changed = !equal(absent ? nullptr : node->second.block.get(), piece.block.get());
  }
}

// Brings the level above up to date; returns what changed there.
template <class Source>
std::vector<KeyRun> refreshLevel(const KeyTree<Source>& below, DensityTree& above,
                                 std::vector<KeyRun> runs) {
  const std::vector<KeyRun> todo = merged(std::move(runs));
  std::vector<std::vector<Piece>> made(todo.size());
  parallelFor(todo.size(), 2, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      made[n] = halveRun(below, todo[n]);
      for (Piece& piece : made[n]) markUnchanged(above, piece);
    }
  });
  std::vector<KeyRun> changed;
  for (const auto& pieces : made) {
    for (const Piece& piece : pieces) {
      if (!piece.changed) continue;
      Delta<Block>::putOrErase(above, piece.run, piece.block);
      above.join(piece.run.key);
      changed.push_back(piece.run);
    }
  }
  return changed;
}

}  // namespace

void* DensityBlock::operator new(std::size_t size) { return allocateBlock(size); }
void DensityBlock::operator delete(void* block, std::size_t size) { releaseBlock(block, size); }

void Pyramid::rebuild(const Clay& field) {
  for (DensityTree& tree : trees_) tree.clear();
  std::vector<KeyRun> all;
  all.reserve(field.tree.nodeCount());
  for (const auto& [key, run] : field.tree) all.push_back({key, run.length});
  refresh(field, all);
}

void Pyramid::refresh(const Clay& field, std::span<const KeyRun> changed) {
  std::vector<KeyRun> runs = refreshLevel(field.tree, trees_[0], dependents(changed));
  for (std::size_t n = 1; n < trees_.size() && !runs.empty(); ++n) {
    runs = refreshLevel(trees_[n - 1], trees_[n], dependents(runs));
  }
}

std::size_t Pyramid::bytes() const {
  std::size_t sum = 0;
  std::unordered_set<const Block*> seen;
  for (const DensityTree& tree : trees_) {
    sum += tree.nodeBytes();
    for (const auto& [key, run] : tree) seen.insert(run.block.get());
  }
  return sum + seen.size() * sizeof(Block);
}

}  // namespace bozzetto
