// Walks through a field by columns: all blocks of one (i, j), in order of k. A patch needs the
// blocks of nine columns; walking them side by side costs a step each, not a search.
#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "bozzetto/field/field.hpp"
#include "surface/block_window.hpp"

namespace bozzetto {

template <int Side>
using FieldNode = typename KeyTree<CornerBlock<Side>>::const_iterator;

template <int Side>
struct Column {
  std::int32_t i, j;
  FieldNode<Side> first;  ///< the first node of interest, or one that comes after the column
};

/// A window of kSpan blocks that moves up one column.
template <int Side>
class ColumnCursor {
 public:
  using Block = CornerBlock<Side>;
  static constexpr int kSpan = BlockWindow<Side>::kSpan;

  ColumnCursor() { blocks_.fill(BlockWindow<Side>::empty()); }
  ColumnCursor(const Column<Side>& column, FieldNode<Side> end)
      : node_(column.first),
        next_(column.first == end ? end : std::next(column.first)),
        end_(end),
        i_(column.i),
        j_(column.j),
        present_(true) {}

  /// Lets blocks()[0] be the one at k - 1. k never goes down.
  void moveTo(std::int32_t k) {
    if (!present_ || (placed_ && k == k_)) return;
    const std::int32_t kept = placed_ && k - k_ < kSpan ? kSpan - (k - k_) : 0;
    for (std::int32_t n = 0; n < kept; ++n) blocks_[n] = blocks_[n + k - k_];
    for (std::int32_t n = kept; n < kSpan; ++n) blocks_[n] = fetch(k - 1 + n);
    k_ = k;
    placed_ = true;
  }

  const std::array<const Block*, kSpan>& blocks() const { return blocks_; }

  /// The first key after `k` whose block may be another one than that at `k`, in the window.
  std::int32_t constantFrom(std::int32_t k) const {
    if (!present_) return kNever;
    for (std::int32_t n = k - k_ + 2; n < kSpan; ++n)
      if (blocks_[n] != blocks_[n - 1]) return k_ - 1 + n;
    if (!inColumn()) return kNever;
    const std::int32_t last = k_ + kSpan - 2, first = node_->first.k;
    return last < first ? first : std::max(last + 1, first + node_->second.length);
  }

  static constexpr std::int32_t kNever = 2147483647;

 private:
  bool inColumn() const { return node_ != end_ && node_->first.i == i_ && node_->first.j == j_; }

  // Calls come with ascending keys.
  const Block* fetch(std::int32_t k) {
    while (inColumn() && node_->first.k + node_->second.length <= k) advance();
    if (!inColumn() || node_->first.k > k) return BlockWindow<Side>::empty();
    return node_->second.block.get();
  }

  // The range of the block after the next is soon asked for.
  void advance() {
    node_ = next_;
    if (next_ != end_) ++next_;
    if (Side > 1 && next_ != end_) __builtin_prefetch(&next_->second.block->low);
  }

  FieldNode<Side> node_, next_, end_;
  std::int32_t i_ = 0, j_ = 0, k_ = 0;
  bool present_ = false, placed_ = false;
  std::array<const Block*, kSpan> blocks_;
};

/// The columns of a field that a piece of work looks at, sorted by (i, j).
template <int Side>
class Columns {
 public:
  /// All columns of the field. O(nodes).
  explicit Columns(const Field<Side>& field) : end_(field.tree.end()) {
    for (auto node = field.tree.begin(); node != end_; ++node) {
      const Key key = node->first;
      if (columns_.empty() || columns_.back().i != key.i || columns_.back().j != key.j)
        columns_.push_back({key.i, key.j, node});
    }
  }

  /// The columns of these runs, each from its first run on. O(runs · log nodes).
  Columns(const Field<Side>& field, std::span<const KeyRun> runs) : end_(field.tree.end()) {
    for (const auto& [key, length] : runs) {
      if (!columns_.empty() && columns_.back().i == key.i && columns_.back().j == key.j) continue;
      columns_.push_back({key.i, key.j, field.tree.from(key)});
    }
  }

  std::span<const Column<Side>> all() const { return columns_; }
  FieldNode<Side> end() const { return end_; }

  /// Cursors for the kSpan² columns about (i, j), in the order of BlockWindow.
  template <class Cursors>
  void placeAround(std::int32_t i, std::int32_t j, Cursors& cursors) const {
    constexpr int span = BlockWindow<Side>::kSpan;
    for (int a = 0; a < span; ++a) {
      auto column = firstFrom(i + a - 1, j - 1);
      for (int b = 0; b < span; ++b) {
        const bool found =
            column != columns_.end() && column->i == i + a - 1 && column->j == j + b - 1;
        cursors[a * span + b] = found ? ColumnCursor<Side>(*column++, end_) : ColumnCursor<Side>();
      }
    }
  }

 private:
  auto firstFrom(std::int32_t i, std::int32_t j) const {
    return std::partition_point(columns_.begin(), columns_.end(), [i, j](const auto& column) {
      return column.i < i || (column.i == i && column.j < j);
    });
  }

  FieldNode<Side> end_;
  std::vector<Column<Side>> columns_;
};

}  // namespace bozzetto
