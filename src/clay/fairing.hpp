// Matter that comes out cell by cell leaves teeth: the surface where it came is faired, as wet clay
// draws itself together, by matter that moves along it from where it bulges to where it lacks.
#pragma once
#include <vector>

#include "clay/layer.hpp"
#include "clay/moved_cells.hpp"

namespace bozzetto::clay {

class Fairing {
 public:
  /// Fairs round these cells, in the scheme `projected`, and forgets them. Uses mark2 and leaves it
  /// 0.
  void run(Work& work, MovedCells& moved, int passes);

 private:
  void list(Region& region, const MovedCells& moved);
  void exchange(Region& region, std::size_t cell);

  std::vector<std::uint32_t> cells_;
  struct Group {
    std::uint32_t first;    // of eight cells in a row
    std::uint32_t cells;    // those listed, a bit each
    std::uint32_t surface;  // of these, by the last measurement
    bool free;              // no tool and nothing held is near
  };
  std::vector<Group> groups_;
};

}  // namespace bozzetto::clay
