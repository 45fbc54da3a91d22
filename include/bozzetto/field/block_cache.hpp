// Finding blocks again without walking the tree: a small direct-mapped cache of what was found
// last, one slot for each residue of the key, so that neighbours never push each other out.
#pragma once
#include <array>
#include <cstdint>
#include <limits>

#include "bozzetto/grid/key_tree.hpp"

namespace bozzetto {

/// Blocks of one tree by key. Good while the tree does not change; one per thread.
template <class Block>
class BlockCache {
 public:
  explicit BlockCache(const KeyTree<Block>& tree) : tree_(&tree) { forget(); }

  /// The block at `key`, null when there is none.
  const Block* find(Key key) {
    Slot& slot = slots_[(key.i & 3) << 4 | (key.j & 3) << 2 | (key.k & 3)];
    if (slot.key != key) slot = {key, tree_->find(key)};
    return slot.block;
  }

  /// To be called when the tree has changed.
  void forget() { slots_.fill({{kNoKey, kNoKey, kNoKey}, nullptr}); }

 private:
  static constexpr std::int32_t kNoKey = std::numeric_limits<std::int32_t>::min();
  struct Slot {
    Key key;
    const Block* block;
  };
  const KeyTree<Block>* tree_;
  std::array<Slot, 64> slots_;
};

}  // namespace bozzetto
