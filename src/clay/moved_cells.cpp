#include "clay/moved_cells.hpp"

namespace bozzetto::clay {

void MovedCells::follow(const Region& region) {
  const KeyBox before = box_;
  box_ = region.box();
  if (before.low == box_.low && before.high == box_.high) return;
  const Key size = before.high - before.low + Key{1, 1, 1};
  std::vector<std::uint32_t> same;
  for (const std::uint32_t cell : cells_) {
    const auto n = static_cast<std::int32_t>(cell);
    const Key key = before.low + Key{n / (size.j * size.k), n / size.k % size.j, n % size.k};
    if (!region.inRim(key)) same.push_back(static_cast<std::uint32_t>(region.index(key)));
  }
  cells_.swap(same);
}

}  // namespace bozzetto::clay
