// Fields for tests, of any block side.
#pragma once
#include <cmath>
#include <functional>
#include <random>

#include "bozzetto/field/field.hpp"

namespace bozzetto::testing {

/// Writes value(corner) into every corner of the box, one colour.
template <int Side>
Delta<CornerBlock<Side>> fill(Field<Side>& field, const KeyBox& box,
                              const std::function<float(Key)>& value, Colour colour = {}) {
  Edit<CornerBlock<Side>> edit(field.tree);
  for (std::int32_t i = box.low.i; i <= box.high.i; ++i)
    for (std::int32_t j = box.low.j; j <= box.high.j; ++j)
      for (std::int32_t k = box.low.k; k <= box.high.k; ++k) {
        const Key corner{i, j, k};
        auto& block = edit.write(BlockGeometry<Side>::blockOf(corner));
        block.value[BlockGeometry<Side>::indexOf(corner)] = value(corner);
        block.attributes[BlockGeometry<Side>::indexOf(corner)] = packAttributes(colour);
      }
  return edit.commit();
}

/// A ball about `centre` (in cells) with a slope of two cells.
template <int Side>
Field<Side> ball(float radius, Key centre = {}, Colour colour = {}) {
  Field<Side> field;
  const auto rim = static_cast<std::int32_t>(std::ceil(radius)) + 2;
  fill<Side>(
      field, {centre - Key{rim, rim, rim}, centre + Key{rim, rim, rim}},
      [&](Key corner) {
        const Key p = corner - centre;
        const double distance =
            std::sqrt(double(p.i) * p.i + double(p.j) * p.j + double(p.k) * p.k);
        return static_cast<float>(std::clamp(0.5 + (radius - distance) / 2, 0.0, 1.0));
      },
      colour);
  return field;
}

/// Random values in a box; about half the corners inside.
template <int Side>
Field<Side> noise(unsigned seed, int side) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0, 1);
  Field<Side> field;
  fill<Side>(field, {{0, 0, 0}, {side - 1, side - 1, side - 1}},
             [&](Key) { return uniform(random); });
  return field;
}

}  // namespace bozzetto::testing
