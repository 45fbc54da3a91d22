// The only way to change a tree. The first write to a block clones it (copy-on-write); commit()
// tidies the written blocks and returns the delta; an edit that is not committed leaves the tree as
// it was.
//
// A Block derives from RefCounted and offers
//   kCount                                   elements
//   static Ref<Block> canonical(Ref<Block>)  null when empty, the interned twin when uniform, else
//                                            the block itself, settled
//   bool sameAs(const Block&) const          equal content, bit for bit
#pragma once
#include <atomic>
#include <optional>
#include <vector>

#include "bozzetto/base/parallel.hpp"
#include "bozzetto/grid/delta.hpp"

namespace bozzetto {

/// One number per edit, never 0, never used twice.
inline std::uint64_t nextEditNumber() {
  static std::atomic<std::uint64_t> number{0};
  return ++number;
}

template <class Block>
class Edit {
 public:
  explicit Edit(KeyTree<Block>& tree) : tree_(&tree), number_(nextEditNumber()) {}
  Edit(const Edit&) = delete;
  Edit& operator=(const Edit&) = delete;
  ~Edit() { rollback(); }

  /// The block as it is now, null when there is none.
  const Block* read(Key key) const { return tree_->find(key); }
  const KeyTree<Block>& tree() const { return *tree_; }

  /// Calls back piece(KeyRun, const Block*) for every node part and every hole (null) of the run,
  /// in order. O(log n + pieces).
  template <class Callback>
  void visit(KeyRun run, Callback&& piece) const {
    forPieces(*tree_, run, [&](KeyRun part, const Ref<Block>& block) { piece(part, block.get()); });
  }

  /// `present` for writing in place when this edit made it and nobody shares it (the tree may be
  /// duplicated in the middle of an edit), else null. O(1).
  Block* own(const Block* present) const {
    const bool mine = present != nullptr && present->editor == number_ && present->holders() == 1;
    if (!mine) return nullptr;
    auto* const block = const_cast<Block*>(present);  // made by this edit, not const then
    block->settled = false;
    return block;
  }

  /// The block to write in place: this edit's own, cloned or made empty at the first call for a
  /// key. The reference stays good until commit, rollback, or replace of this key. Not from
  /// several threads; the blocks returned may be filled in parallel. O(log n).
  Block& write(Key key) {
    const auto node = tree_->at(key);
    const Block* present = node == tree_->end() ? nullptr : node->second.block.get();
    if (Block* mine = own(present)) return *mine;
    Ref<Block> block(present != nullptr ? new Block(*present) : new Block());
    block->editor = number_;
    remember({key, 1});
    Block& result = *block;
    tree_->put(key, std::move(block));
    return result;
  }

  /// A block to fill that replaces the one at `key` when handed to `replace`: for kernels that
  /// read the old values of the neighbourhood while they write.
  Ref<Block> fresh() const { return own(Ref<Block>(new Block())); }

  /// A block of the caller's making, as if from fresh().
  Ref<Block> own(Ref<Block> block) const {
    block->editor = number_;
    block->settled = false;
    return block;
  }

  /// Puts `block` (null = empty space) at every key of the run.
  void replace(KeyRun run, const Ref<Block>& block) {
    remember(run);
    Delta<Block>::putOrErase(*tree_, run, block);
  }

  /// Where the last key was found: for keys that come in order. Good while nothing else changes
  /// the tree.
  class Place {
   public:
    explicit Place(const Edit& edit) : node_(edit.tree_->end()), noted_(edit.before_.end()) {}

   private:
    friend class Edit;
    typename KeyTree<Block>::const_iterator node_, noted_;
  };

  /// replace({key, 1}, block) for ascending keys. Amortised O(1) where they are close.
  void replace(Key key, const Ref<Block>& block, Place& place) {
    const auto node = tree_->from(key, place.node_);
    remember(key, node, place);
    if (block) {
      place.node_ = tree_->put(node, key, block);
    } else {
      tree_->erase(key);
      place.node_ = tree_->end();
    }
  }

  /// Ends the edit: written blocks become canonical, unchanged ones their old selves again.
  /// O(touched blocks), in parallel. The edit is empty afterwards and may be used again.
  Delta<Block> commit() {
    std::vector<Touched> touched = collect();
    tidy(touched);
    Delta<Block> delta;
    delta.changes.reserve(touched.size());
    for (auto& [change, stands] : touched) {
      if (!stands) Delta<Block>::putOrErase(*tree_, {change.key, change.length}, change.after);
      if (!(change.before == change.after)) delta.changes.push_back(std::move(change));
    }
    for (const auto& change : delta.changes) joinAt(change);
    restart();
    return delta;
  }

  /// Puts everything back as it was before the edit.
  void rollback() {
    for (const auto& [key, run] : before_)
      Delta<Block>::putOrErase(*tree_, {key, run.length}, run.block);
    for (const auto& [key, run] : before_) tree_->join(key);
    restart();
  }

 private:
  void restart() {
    before_.clear();
    number_ = nextEditNumber();
  }

  // Notes what stands at the run, once: what an earlier call noted for a key stays.
  void remember(KeyRun run) {
    forGaps(before_, run, [&](KeyRun gap) {
      forPieces(*tree_, gap, [&](KeyRun piece, const Ref<Block>& block) {
        before_.put(piece.key, piece.length, block);
      });
    });
  }

  // The same for one key; `node` is the tree's from(key).
  void remember(Key key, typename KeyTree<Block>::const_iterator node, Place& place) {
    const auto noted = before_.from(key, place.noted_);
    const bool known = noted != before_.end() && !(key < noted->first);
    const bool present = node != tree_->end() && !(key < node->first);
    place.noted_ =
        known ? noted : before_.insert(noted, key, present ? node->second.block : nullptr);
  }

  // A block that only the tree and the delta hold has no twin beside it.
  void joinAt(const Change<Block>& change) {
    if (change.after && change.after->holders() > 2) tree_->join(change.key);
  }

  // Calls gap(run) for every part of `run` that `tree` has no node for.
  template <class Callback>
  static void forGaps(const KeyTree<Block>& tree, KeyRun run, Callback&& gap) {
    std::vector<KeyRun> gaps;
    forPieces(tree, run, [&](KeyRun piece, const Ref<Block>&, bool present) {
      if (!present) gaps.push_back(piece);
    });
    for (const KeyRun& piece : gaps) gap(piece);
  }

  struct Touched {
    Change<Block> change;
    bool stands = true;  // `after` is what the tree has
  };

  // Before and after of everything touched, in pieces on which both are constant.
  std::vector<Touched> collect() const {
    std::vector<Touched> touched;
    touched.reserve(before_.nodeCount());
    auto near = tree_->end();
    for (const auto& [key, run] : before_) {
      near = tree_->from(key, near);
      const auto add = [&, &old = run.block](KeyRun piece, const Ref<Block>& now) {
        touched.push_back({{piece.key, piece.length, old, now}});
      };
      forPieces(*tree_, near, {key, run.length}, add);
    }
    return touched;
  }

  void tidy(std::vector<Touched>& touched) const {
    constexpr std::size_t grain = Block::kCount >= 512 ? 64 : 4096;
    parallelFor(touched.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) tidy(touched[n]);
    });
  }

  void tidy(Touched& touched) const {
    Change<Block>& change = touched.change;
    if (!change.after || change.after->editor != number_) return;
    const Block* const standing = change.after.get();
    change.after = Block::canonical(std::move(change.after));
    if (change.before && change.after && change.before->sameAs(*change.after)) {
      change.after = change.before;
    }
    touched.stands = change.after.get() == standing;
  }

  KeyTree<Block>* tree_;
  KeyTree<Block> before_;
  std::uint64_t number_;
};

}  // namespace bozzetto
