#include "clay/drawing.hpp"

#include <cmath>

#include "bozzetto/clay/stiffness.hpp"

namespace bozzetto::clay {
namespace {

constexpr float kStrain = 0.02f;  // of a step: less is bending, which rounding does not spoil
constexpr float kAir = 0.02f, kFull = 0.98f;
constexpr float kDry = 0.9f;  // stiffer clay keeps its form

// Twice the displacement of a cell along an axis.
float moved(const Region& region, std::size_t cell, std::size_t axis) {
  return region.face[axis][cell] + region.face[axis][cell - region.strides()[axis]];
}

// To the next cell along an axis, where there is more clay.
std::ptrdiff_t inwards(const Region& region, std::size_t cell, std::size_t axis) {
  const std::ptrdiff_t step = region.strides()[axis];
  return region.value[cell + step] < region.value[cell - step] ? -step : step;
}

// How the displacement along `a` grows along `b`, doubled, by the clay within.
float growth(const Region& region, std::size_t cell, std::size_t a, std::size_t b) {
  const std::ptrdiff_t step = inwards(region, cell, b);
  const float change = moved(region, cell + step, a) - moved(region, cell, a);
  return step < 0 ? -change : change;
}

// Turning is no strain: the two growths of each pair cancel.
bool isStrained(const Region& region, std::size_t cell) {
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3;
    const Cells<float>& face = region.face[a];
    if (std::abs(face[cell] - face[cell - region.strides()[a]]) > kStrain) return true;
    if (std::abs(growth(region, cell, a, b) + growth(region, cell, b, a)) > 4 * kStrain)
      return true;
  }
  return false;
}

bool isDry(const Work& work, std::size_t cell) {
  const float offset = work.region.stiffened ? work.region.offset(cell) : 0.0f;
  return followingAt(static_cast<float>(work.settings.stiffness), offset) > kDry;
}

bool isGripped(const Work& work, std::size_t cell) {
  const std::uint8_t owner = work.region.owner[cell];
  return owner >= kMoving && owner != kRim && work.moving[owner - kMoving].role == Role::grip;
}

}  // namespace

void Drawing::run(Work& work) {
  if (!work.grips()) return;
  const Region& region = work.region;
  for (const Row& row : region.bandRows())
    for (std::size_t n = row.base; n < row.base + row.count; ++n)
      if (region.value[n] > kAir && region.value[n] < kFull && isStrained(region, n) &&
          !isDry(work, n) && !isGripped(work, n))
        strained_.note(n);
  fairing_.run(work, strained_, 1);
}

}  // namespace bozzetto::clay
