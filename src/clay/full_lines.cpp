#include "clay/full_lines.hpp"

#include <algorithm>

namespace bozzetto::clay {

void FullLines::begin(const Region& region) {
  for (Known* known : touched_) *known = {};
  touched_.clear();
  const Key size = region.box().high - region.box().low + Key{1, 1, 1};
  for (std::size_t axis = 0; axis < 3; ++axis)
    lines_[axis].resize(static_cast<std::size_t>(region.box().count() / size[kAxes[axis]]));
}

int FullLines::ahead(const Region& region, std::size_t cell, Way way, int most) {
  const Key low = region.box().low, place = region.key(cell) - low;
  const Key size = region.box().high - low + Key{1, 1, 1};
  const std::size_t a = (way.axis + 1) % 3, b = (way.axis + 2) % 3;
  const auto line = std::ptrdiff_t{place[kAxes[a]]} * size[kAxes[b]] + place[kAxes[b]];
  Known& known = lines_[way.axis][line];
  const std::ptrdiff_t step = way.sign * region.strides()[way.axis];
  const std::int32_t here = place[kAxes[way.axis]], first = here + way.sign;
  if (first < known.from || first > known.to) {
    if (!isFull(region, cell + step)) return 0;
    if (known.to < known.from) touched_.push_back(&known);
    known = {first, first};
  }
  std::int32_t& end = way.sign < 0 ? known.from : known.to;
  for (std::size_t next = cell + ((end - here) * way.sign + 1) * step;
       (end - here) * way.sign < most && isFull(region, next); next += step)
    end += way.sign;
  return std::min((end - here) * way.sign, most);
}

}  // namespace bozzetto::clay
