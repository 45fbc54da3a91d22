// Cells that matter came to, noted over several steps though the region may be another by then.
#pragma once
#include "clay/region.hpp"

namespace bozzetto::clay {

class MovedCells {
 public:
  /// In any order, more than once or not.
  void note(std::size_t cell) { cells_.push_back(static_cast<std::uint32_t>(cell)); }
  /// From now on they are cells of this region; those that it does not move are forgotten.
  void follow(const Region& region);
  void clear() { cells_.clear(); }
  const std::vector<std::uint32_t>& cells() const { return cells_; }

 private:
  KeyBox box_;  // of the region
  std::vector<std::uint32_t> cells_;
};

}  // namespace bozzetto::clay
