// What an edit changed: blocks before and after. History, surface, pyramid, saving and the mass
// ledger live on deltas and know no tool. Costs pointers: the blocks are shared with the tree.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "bozzetto/grid/key_tree.hpp"

namespace bozzetto {

/// A null block stands for empty space.
template <class Block>
struct Change {
  Key key;
  std::int32_t length = 1;
  Ref<Block> before, after;
};

enum class Direction { backward, forward };

/// Changes in key order, none overlapping, each with before ≠ after.
template <class Block>
struct Delta {
  std::vector<Change<Block>> changes;

  bool empty() const { return changes.empty(); }

  std::vector<KeyRun> keys() const {
    std::vector<KeyRun> runs;
    runs.reserve(changes.size());
    for (const auto& change : changes) runs.push_back({change.key, change.length});
    return runs;
  }

  /// Puts the blocks after (forward) or before (backward) into the tree: redo and undo.
  /// O(changes · log n), no block is copied.
  void apply(KeyTree<Block>& tree, Direction direction) const {
    for (const auto& change : changes) {
      const Ref<Block>& block = direction == Direction::forward ? change.after : change.before;
      putOrErase(tree, {change.key, change.length}, block);
    }
    for (const auto& change : changes) tree.join(change.key);
  }

  static void putOrErase(KeyTree<Block>& tree, KeyRun run, const Ref<Block>& block) {
    if (!block) {
      tree.erase(run.key, run.length);
    } else if (run.length == 1) {
      tree.put(run.key, block);
    } else {
      tree.put(run.key, run.length, block);
    }
  }
};

/// What differs between two trees inside `runs` (sorted, not overlapping): from `before` to
/// `after`. Compares block pointers. O(runs · log n).
template <class Block>
Delta<Block> difference(const KeyTree<Block>& before, const KeyTree<Block>& after,
                        std::span<const KeyRun> runs) {
  Delta<Block> delta;
  for (const KeyRun& run : runs) {
    forPieces(before, run, [&](KeyRun whole, const Ref<Block>& old) {
      forPieces(after, whole, [&](KeyRun piece, const Ref<Block>& now) {
        if (!(old == now)) delta.changes.push_back({piece.key, piece.length, old, now});
      });
    });
  }
  return delta;
}

}  // namespace bozzetto
