// Matter that comes out cell by cell leaves teeth: the surface where it came is faired, as wet clay
// draws itself together, by matter that moves along it from where it bulges to where it lacks.
#pragma once
#include <vector>

#include "clay/layer.hpp"

namespace bozzetto::clay {

/// Cells that matter came to in a step, in any order, more than once or not.
using MovedCells = std::vector<std::uint32_t>;

class Fairing {
 public:
  /// Fairs round these cells, in the scheme `projected`, and forgets them. Uses mark2 and leaves it
  /// 0.
  void run(Work& work, MovedCells& moved, int passes);

 private:
  void list(Region& region, const MovedCells& moved);
  void exchange(Region& region, std::size_t cell);

  MovedCells cells_;
  std::vector<std::uint32_t> groups_;  // the first of eight cells in a row
};

}  // namespace bozzetto::clay
