#include "bozzetto/tool/sculpture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "bozzetto/base/error.hpp"
#include "bozzetto/field/resample.hpp"
#include "bozzetto/tool/relative.hpp"
#include "tool/freeform.hpp"
#include "tool/sculpted_solid.hpp"

namespace bozzetto {
namespace {

using Geometry = BlockGeometry<8>;
constexpr std::int32_t kWidest = 1 << 15;

void include(KeyBox& box, Key low, Key high) {
  if (box.empty()) {
    box = {low, high};
    return;
  }
  for (const Axis axis : kAxes) {
    box.low[axis] = std::min(box.low[axis], low[axis]);
    box.high[axis] = std::max(box.high[axis], high[axis]);
  }
}

KeyBox blockBounds(const Clay& clay) {
  KeyBox box;
  for (const auto& [key, run] : clay.tree) include(box, key, key + Key{0, 0, run.length - 1});
  return box;
}

// The corners with clay of one block.
KeyBox cornersWithClay(const CornerBlock<8>& block, Key blockKey) {
  KeyBox box;
  const Key first = Geometry::firstCornerOf(blockKey);
  for (int n = 0; n < Geometry::kCount; ++n) {
    if (!(block.value[static_cast<std::size_t>(n)] > 0)) continue;
    const Key corner = first + Key{n >> 6, n >> 3 & 7, n & 7};
    include(box, corner, corner);
  }
  return box;
}

bool atFace(const KeyBox& box, Key low, Key high) {
  return std::ranges::any_of(
      kAxes, [&](Axis axis) { return low[axis] == box.low[axis] || high[axis] == box.high[axis]; });
}

// A block with nothing outside the box.
Ref<CornerBlock<8>> clipped(const CornerBlock<8>& block, Key blockKey, const KeyBox& box) {
  Ref<CornerBlock<8>> copy(new CornerBlock<8>(block));
  const Key first = Geometry::firstCornerOf(blockKey);
  for (int n = 0; n < Geometry::kCount; ++n) {
    if (box.contains(first + Key{n >> 6, n >> 3 & 7, n & 7})) continue;
    copy->value[static_cast<std::size_t>(n)] = 0;
    copy->attributes[static_cast<std::size_t>(n)] = 0;
  }
  return CornerBlock<8>::canonical(std::move(copy));
}

bool contains(const KeyBox& box, const KeyBox& other) {
  return box.contains(other.low) && box.contains(other.high);
}

bool apart(const KeyBox& box, const KeyBox& other) {
  return std::ranges::any_of(kAxes, [&](Axis axis) {
    return other.high[axis] < box.low[axis] || other.low[axis] > box.high[axis];
  });
}

glm::dvec3 middleOf(const KeyBox& box) {
  glm::dvec3 middle;
  for (const Axis axis : kAxes)
    middle[index(axis)] = 0.5 * (double(box.low[axis]) + double(box.high[axis]));
  return middle;
}

// Sums of colour × density, and whether there are two colours.
struct ColourSums {
  std::array<double, 3> sum{};
  double weight = 0;
  std::optional<Attributes> first;
  bool many = false;

  void add(float value, Attributes attributes, double times) {
    if (!(value > 0)) return;
    const Attributes colour = attributes & 0xffffff;
    if (!first) first = colour;
    many = many || colour != *first;
    const double mass = times * double(value);
    for (std::size_t c = 0; c < 3; ++c) sum[c] += mass * double(colour >> 8 * c & 255);
    weight += mass;
  }
  std::uint8_t mean(std::size_t channel) const {
    return static_cast<std::uint8_t>(std::lround(sum[channel] / weight));
  }
};

Sculpture::Colours coloursOf(const Clay& clay) {
  ColourSums sums;
  for (const auto& [key, run] : clay.tree) {
    const CornerBlock<8>& block = *run.block;
    const double times = block.interned ? double(run.length) * Geometry::kCount : 1;
    const std::size_t count = block.interned ? 1 : Geometry::kCount;
    for (std::size_t n = 0; n < count; ++n) sums.add(block.value[n], block.attributes[n], times);
  }
  return {sums.many, {sums.mean(0), sums.mean(1), sums.mean(2)}};
}

bool finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

KeyBox boundsOf(const Clay& clay) {
  const KeyBox blocks = blockBounds(clay);
  KeyBox box;
  for (const auto& [key, run] : clay.tree) {
    const Key last = key + Key{0, 0, run.length - 1};
    if (!atFace(blocks, key, last)) continue;
    for (const Key end : {key, last}) {
      if (!box.empty() && contains(box, Geometry::cornersOf(end))) continue;
      const KeyBox corners = cornersWithClay(*run.block, end);
      if (!corners.empty()) include(box, corners.low, corners.high);
    }
  }
  return box;
}

Clay partOf(const Clay& clay, const KeyBox& box) {
  Clay part;
  part.scale = clay.scale;
  if (box.empty()) return part;
  for (const auto& [key, run] : clay.tree) {
    const Key last = key + Key{0, 0, run.length - 1};
    if (apart(box, {Geometry::firstCornerOf(key), Geometry::cornersOf(last).high})) continue;
    if (contains(box, {Geometry::firstCornerOf(key), Geometry::cornersOf(last).high})) {
      part.tree.put(key, run.length, run.block);
      continue;
    }
    const std::int32_t from = std::max(key.k, Geometry::blockOf(box.low).k);
    const std::int32_t until = std::min(last.k, Geometry::blockOf(box.high).k);
    for (std::int32_t k = from; k <= until; ++k) {
      const Key at{key.i, key.j, k};
      const bool whole = contains(box, Geometry::cornersOf(at));
      auto block = whole ? run.block : clipped(*run.block, at, box);
      if (block) part.tree.put(at, std::move(block));
    }
  }
  return part;
}

Sculpture::Sculpture(Clay clay, const SculptureOptions& options)
    : clay_(std::move(clay)), bounds_(boundsOf(clay_)), levels_(kLevels + 1) {
  if (bounds_.empty()) throw Error("freeform tool: no clay found, some expected");
  for (const Axis axis : kAxes) {
    if (std::int64_t{bounds_.high[axis]} - bounds_.low[axis] < kWidest) continue;
    throw Error("freeform tool: wider than 2^15 cells; a coarser one expected (resample)");
  }
  const glm::dvec3 contact = options.contact;
  if (!finite(contact) || !(glm::length(contact) > 1e-9)) {
    throw Error("freeform tool: contact " + toText(contact) + " found, a direction expected");
  }
  contact_ = glm::normalize(contact);
  if (options.pivot) pivot_ = *options.pivot / clay_.scale.spacing - centre();
  if (!finite(pivot_) || glm::length(pivot_) > 2.0 * kWorkspaceRim) {
    throw Error("freeform tool: pivot " + toText(*options.pivot) +
                " found, a place in the workspace of ±2^30 cells expected");
  }
}

Sculpture::~Sculpture() = default;

glm::dvec3 Sculpture::centre() const { return middleOf(bounds_); }

glm::dvec3 Sculpture::halfExtents() const {
  glm::dvec3 half;
  for (const Axis axis : kAxes)
    half[index(axis)] = 0.5 * (double(bounds_.high[axis]) - double(bounds_.low[axis])) + 1;
  return half;
}

double Sculpture::referenceRadius() const {
  const double cells = static_cast<double>(massUnits(clay_)) * kMassUnit;
  return std::cbrt(cells * 3 / (4 * 3.14159265358979323846));
}

// One colour in every corner with clay is common, and spares dabs the look at colours.
const Sculpture::Colours& Sculpture::colours() const {
  const std::lock_guard lock(making_);
  if (!colours_) colours_ = coloursOf(clay_);
  return *colours_;
}

const SculptedDistance& Sculpture::distance() const {
  const std::lock_guard lock(making_);
  if (!distance_) distance_ = std::make_unique<const SculptedDistance>(*this);
  return *distance_;
}

const SculptureLevel& Sculpture::level(int n) const {
  const std::lock_guard lock(making_);
  for (int each = 0; each <= n; ++each) {
    auto& made = levels_[static_cast<std::size_t>(each)];
    if (made) continue;
    if (each == 0) {
      made = std::make_unique<SculptureLevel>(clay_);
      continue;
    }
    const Clay& finer = levels_[static_cast<std::size_t>(each - 1)]->clay;
    made = std::make_unique<SculptureLevel>(resample(finer, 2 * finer.scale.spacing));
  }
  return *levels_[static_cast<std::size_t>(n)];
}

}  // namespace bozzetto
