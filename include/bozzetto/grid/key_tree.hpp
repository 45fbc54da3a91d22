// Balanced binary trees keyed by (i,j,k): where corners, cubes and edges live (Ferley §3.1).
//
// A node holds a run: `length` equal neighbours along k that share one block. Runs longer than 1
// are made of interned blocks only (uniform clay), so the inside of a solid costs a node per row
// and memory grows with the surface. With blocks of side 1 and no interning this is the paper's
// structure to the letter: one corner a node.
#pragma once
#include <algorithm>
#include <boost/container/map.hpp>
#include <boost/container/node_allocator.hpp>
#include <cassert>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "bozzetto/grid/key.hpp"
#include "bozzetto/grid/ref.hpp"

namespace bozzetto {

/// `length` blocks from the key of the node upwards along k. A null block marks room that is known
/// to be empty (edits keep such runs; trees of clay do not).
template <class Block>
struct Run {
  std::int32_t length = 1;
  Ref<Block> block;
};

/// `length` block keys from `key` upwards along k.
struct KeyRun {
  Key key;
  std::int32_t length = 1;
};

/// The same keys, sorted and each once.
inline std::vector<KeyRun> withoutOverlaps(std::vector<KeyRun> runs) {
  std::ranges::sort(runs, {}, &KeyRun::key);
  std::vector<KeyRun> clear;
  for (const KeyRun& run : runs) {
    if (!clear.empty()) {
      KeyRun& last = clear.back();
      const bool sameRow = last.key.i == run.key.i && last.key.j == run.key.j;
      const std::int32_t end = last.key.k + last.length;
      if (sameRow && run.key.k < end) {
        last.length = std::max(end, run.key.k + run.length) - last.key.k;
        continue;
      }
    }
    clear.push_back(run);
  }
  return clear;
}

// Pools hide overruns from the address sanitizer; there the standard allocator serves.
#ifdef BOZZETTO_SANITIZED
template <class T>
using TreeAllocator = std::allocator<T>;
#else
template <class T>
using TreeAllocator = boost::container::node_allocator<T>;
#endif

template <class Block>
class KeyTree {
  using AvlOptions = boost::container::tree_assoc_options_t<
      boost::container::tree_type<boost::container::avl_tree>,
      boost::container::optimize_size<true>>;
  using Map = boost::container::map<Key, Run<Block>, std::less<Key>,
                                    TreeAllocator<std::pair<const Key, Run<Block>>>, AvlOptions>;

 public:
  using const_iterator = typename Map::const_iterator;

  /// The block at `key`, null when there is none. O(log n).
  Block* find(Key key) const {
    const const_iterator node = at(key);
    return node == map_.end() ? nullptr : node->second.block.get();
  }

  /// The node whose run covers `key`, or end(). O(log n).
  const_iterator at(Key key) const {
    const const_iterator node = from(key);
    return node != map_.end() && !(key < node->first) ? node : map_.end();
  }

  /// The first node that covers `key` or comes after it. O(log n); from there, ++ walks on.
  const_iterator from(Key key) const {
    const const_iterator after = map_.upper_bound(key);
    if (after == map_.begin()) return after;
    const const_iterator before = std::prev(after);
    return covers(*before, key) ? before : after;
  }

  /// from(key) for keys that come in order: walks a few nodes on from `near`, a node at or before
  /// `key` that was found last (or end()), and searches only when that does not reach.
  const_iterator from(Key key, const_iterator near) const {
    constexpr int kSteps = 4;
    if (near == map_.end() || key < near->first) return from(key);
    for (int step = 0; step < kSteps; ++step) {
      const const_iterator next = std::next(near);
      if (next == map_.end() || key < next->first) return covers(*near, key) ? near : next;
      near = next;
    }
    return from(key);
  }

  const_iterator begin() const { return map_.begin(); }
  const_iterator end() const { return map_.end(); }
  std::size_t nodeCount() const { return map_.size(); }
  bool empty() const { return map_.empty(); }
  void clear() { map_.clear(); }

  /// Makes `block` stand at `length` keys from `key` upwards along k, whatever stood there.
  void put(Key key, std::int32_t length, Ref<Block> block) {
    assert(length > 0);
    const const_iterator next = cut(from(key), key, length);
    map_.emplace_hint(next, key, Run<Block>{length, std::move(block)});
  }

  /// Puts one block; replaces in place where a node of length 1 stands there already. O(log n).
  void put(Key key, Ref<Block> block) { put(from(key), key, std::move(block)); }

  /// The same where `node` is from(key); returns the node. Amortised O(1).
  const_iterator put(const_iterator node, Key key, Ref<Block> block) {
    if (node != map_.end() && node->second.length == 1 && !(key < node->first)) {
      mutableRun(node).block = std::move(block);
      return node;
    }
    const const_iterator next = cut(node, key, 1);
    return map_.emplace_hint(next, key, Run<Block>{1, std::move(block)});
  }

  /// Puts one block where nothing stands, right before `next`. Amortised O(1).
  const_iterator insert(const_iterator next, Key key, Ref<Block> block) {
    return map_.emplace_hint(next, key, Run<Block>{1, std::move(block)});
  }

  /// Takes away what stands at `length` keys from `key` upwards.
  void erase(Key key, std::int32_t length = 1) { cut(from(key), key, length); }

  /// Joins runs of the same block that touch at `key` or at the end of the run there.
  void join(Key key) {
    const_iterator node = at(key);
    if (node == map_.end() || !node->second.block) return;
    if (node != map_.begin()) node = joinWithNext(std::prev(node));
    joinWithNext(node);
  }

  /// The first thing that is wrong, if any: order, overlaps, lengths.
  std::optional<std::string> validate() const {
    for (const_iterator node = map_.begin(); node != map_.end(); ++node) {
      if (node->second.length < 1) return "run of length < 1 at " + toText(node->first);
      const const_iterator next = std::next(node);
      if (next != map_.end() && covers(*node, next->first)) {
        return "runs overlap at " + toText(next->first);
      }
    }
    return std::nullopt;
  }

  /// Bytes of the nodes themselves, blocks not counted.
  std::size_t nodeBytes() const {
    return map_.size() * (sizeof(std::pair<const Key, Run<Block>>) + 3 * sizeof(void*));
  }

 private:
  template <class Node>
  static bool covers(const Node& node, Key key) {
    return key.i == node.first.i && key.j == node.first.j && key.k >= node.first.k &&
           std::int64_t{key.k} < std::int64_t{node.first.k} + node.second.length;
  }

  Run<Block>& mutableRun(const_iterator node) {
    return const_cast<Run<Block>&>(node->second);  // the map is ours; its iterator was const
  }

  // Empties [key, key + length), splitting runs at both ends; `node` is from(key); returns the node
  // that follows.
  const_iterator cut(const_iterator node, Key key, std::int32_t length) {
    const Key end{key.i, key.j, key.k + length};
    while (node != map_.end() && node->first < end) {
      const Key first = node->first;
      const Run<Block> run = node->second;
      const Key runEnd{first.i, first.j, first.k + run.length};
      node = map_.erase(node);
      if (end < runEnd)
        node = map_.emplace_hint(node, end, Run<Block>{runEnd.k - end.k, run.block});
      if (first < key) map_.emplace_hint(node, first, Run<Block>{key.k - first.k, run.block});
    }
    return node;
  }

  // Joins `node` with its successor where they touch and share a block; returns the joined node,
  // or the successor where they do not.
  const_iterator joinWithNext(const_iterator node) {
    const const_iterator next = std::next(node);
    if (next == map_.end()) return node;
    Run<Block>& run = mutableRun(node);
    const Key end{node->first.i, node->first.j, node->first.k + run.length};
    if (next->first != end || !(next->second.block == run.block)) return next;
    run.length += next->second.length;
    map_.erase(next);
    return node;
  }

  Map map_;
};

/// Calls callback(KeyRun, const Ref<Block>&[, bool present]) for every node part and every hole
/// (null, not present) inside `run`, in order. O(log n + pieces). The tree must not change
/// meanwhile. `node` is tree.from(run.key).
template <class Block, class Callback>
void forPieces(const KeyTree<Block>& tree, typename KeyTree<Block>::const_iterator node, KeyRun run,
               Callback&& callback) {
  const std::int32_t end = run.key.k + run.length;
  std::int32_t k = run.key.k;
  const auto call = [&](std::int32_t until, const Ref<Block>& block, bool present) {
    const KeyRun piece{{run.key.i, run.key.j, k}, until - k};
    if constexpr (std::is_invocable_v<Callback, KeyRun, const Ref<Block>&, bool>) {
      callback(piece, block, present);
    } else {
      callback(piece, block);
    }
    k = until;
  };
  for (; k < end; ++node) {
    const bool inside = node != tree.end() && node->first < Key{run.key.i, run.key.j, end};
    if (!inside) return call(end, nullptr, false);
    if (node->first.k > k) call(node->first.k, nullptr, false);
    call(std::min(end, node->first.k + node->second.length), node->second.block, true);
  }
}

template <class Block, class Callback>
void forPieces(const KeyTree<Block>& tree, KeyRun run, Callback&& callback) {
  forPieces(tree, tree.from(run.key), run, callback);
}

}  // namespace bozzetto
