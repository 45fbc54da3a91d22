#include "clay/pieces.hpp"

#include <algorithm>

namespace bozzetto::clay {

void Pieces::find(const Region& region, float threshold) {
  const auto cells = static_cast<std::size_t>(region.box().count());
  if (cells != size_) label_ = Cells<std::uint32_t>(size_ = cells);
  listRuns(region, threshold);
  for (std::uint32_t n = 0; n < runs_.size(); ++n) {
    const Run& run = runs_[n];
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const std::size_t below = run.base - region.strides()[axis];
      for (std::size_t k = 0; k < static_cast<std::size_t>(run.count); ++k)
        if (region.value[below + k] >= threshold && region.owner[below + k] != kRim)
          join(n, label_[below + k]);
    }
  }
  for (std::uint32_t n = 0; n < runs_.size(); ++n) runs_[n].root = rootOf(n);
}

void Pieces::listRuns(const Region& region, float threshold) {
  runs_.clear();
  for (const Row& row : region.rows()) {
    for (std::size_t cell = row.base, end = row.base + row.count; cell < end;) {
      while (cell < end && region.value[cell] < threshold) ++cell;
      const std::size_t first = cell;
      const auto number = static_cast<std::uint32_t>(runs_.size());
      while (cell < end && region.value[cell] >= threshold) label_[cell++] = number;
      if (cell > first) runs_.push_back({first, static_cast<std::int32_t>(cell - first), number});
    }
  }
}

std::uint32_t Pieces::rootOf(std::uint32_t run) {
  while (runs_[run].root != run) run = runs_[run].root = runs_[runs_[run].root].root;
  return run;
}

void Pieces::join(std::uint32_t a, std::uint32_t b) {
  a = rootOf(a);
  b = rootOf(b);
  runs_[std::max(a, b)].root = std::min(a, b);
}

}  // namespace bozzetto::clay
