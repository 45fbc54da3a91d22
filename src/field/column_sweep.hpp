// Walking up a bundle of Width × Width neighbouring columns of blocks at once, run by run: how
// filters pass over a tree without touching every key inside long runs.
#pragma once
#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "bozzetto/grid/delta.hpp"
#include "bozzetto/grid/key_tree.hpp"

namespace bozzetto {

template <class Block, int Width>
class ColumnSweep {
 public:
  /// The columns `first` … `first` + (Width−1, Width−1, ·), from first.k upwards.
  ColumnSweep(const KeyTree<Block>& tree, Key first) : end_(tree.end()) {
    for (int n = 0; n < Width * Width; ++n) {
      columns_[n].key = first + Key{n / Width, n % Width, 0};
      columns_[n].node = tree.from(columns_[n].key);
    }
  }

  /// The blocks k … k+Width−1 of all columns, in key order; k never falls from call to call.
  /// Returns the k before which every column stays in the run or gap that fills its window, or k
  /// where some column does not fill its window with one.
  std::int32_t window(std::int32_t k, std::array<const Block*, Width * Width * Width>& blocks) {
    std::int32_t steady = std::numeric_limits<std::int32_t>::max();
    for (int n = 0; n < Width * Width; ++n) {
      steady = std::min(steady, columnWindow(columns_[n], k, &blocks[n * Width]));
    }
    return steady;
  }

 private:
  using Iterator = typename KeyTree<Block>::const_iterator;
  struct Column {
    Key key;
    Iterator node;
  };

  bool inColumn(const Column& column, Iterator node) const {
    return node != end_ && node->first.i == column.key.i && node->first.j == column.key.j;
  }

  std::int32_t columnWindow(Column& column, std::int32_t k, const Block** blocks) const {
    while (inColumn(column, column.node) &&
           column.node->first.k + column.node->second.length <= k) {
      ++column.node;
    }
    Iterator node = column.node;
    std::int32_t stay = k;
    for (std::int32_t at = k; at < k + Width;) {
      const bool present = inColumn(column, node);
      const bool here = present && node->first.k <= at;
      const std::int32_t until = here      ? node->first.k + node->second.length
                                 : present ? node->first.k
                                           : std::numeric_limits<std::int32_t>::max();
      if (at == k && until >= k + Width) stay = until;
      const std::int32_t stop = std::min(until, k + Width);
      std::fill(blocks + (at - k), blocks + (stop - k), here ? node->second.block.get() : nullptr);
      at = stop;
      if (here) ++node;
    }
    return stay;
  }

  Iterator end_;
  std::array<Column, Width * Width> columns_;
};

/// Sorted runs without overlap that cover the same keys.
inline std::vector<KeyRun> merged(std::vector<KeyRun> runs) {
  std::sort(runs.begin(), runs.end(),
            [](const KeyRun& a, const KeyRun& b) { return a.key < b.key; });
  std::vector<KeyRun> result;
  for (const KeyRun& run : runs) {
    const bool sameColumn =
        !result.empty() && result.back().key.i == run.key.i && result.back().key.j == run.key.j;
    if (sameColumn && run.key.k <= result.back().key.k + result.back().length) {
      KeyRun& last = result.back();
      last.length = std::max(last.length, run.key.k + run.length - last.key.k);
    } else {
      result.push_back(run);
    }
  }
  return result;
}

}  // namespace bozzetto
