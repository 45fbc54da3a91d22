// The ball of workload.hpp as our fields keep it, and scenes to put strokes in.
#pragma once
#include <algorithm>
#include <cmath>

#include "bozzetto/base/hash.hpp"
#include "bozzetto/base/parallel.hpp"
#include "bozzetto/field/field.hpp"
#include "workload.hpp"

namespace bozzetto::scenes {

inline constexpr Attributes kClay = packAttributes({176, 128, 96});

// Distances from the origin to the nearest and to the farthest point of a block's corners.
struct Span {
  double nearest = 0, farthest = 0;
};

template <int Side>
Span spanOf(Key block) {
  const KeyBox box = BlockGeometry<Side>::cornersOf(block);
  double nearest2 = 0, farthest2 = 0;
  for (const Axis axis : kAxes) {
    const double low = box.low[axis], high = box.high[axis];
    const double nearest = std::max({0.0, low, -high});
    const double farthest = std::max(std::abs(low), std::abs(high));
    nearest2 += nearest * nearest;
    farthest2 += farthest * farthest;
  }
  return {std::sqrt(nearest2), std::sqrt(farthest2)};
}

template <int Side>
void fillFromBall(CornerBlock<Side>& block, Key key, double radius) {
  const KeyBox box = BlockGeometry<Side>::cornersOf(key);
  int n = 0;
  for (int i = box.low.i; i <= box.high.i; ++i) {
    for (int j = box.low.j; j <= box.high.j; ++j) {
      for (int k = box.low.k; k <= box.high.k; ++k, ++n) {
        block.value[n] = workload::ballDensity(i, j, k, radius);
        block.attributes[n] = block.value[n] > 0 ? kClay : 0;
      }
    }
  }
  block.updateRange();
}

/// A solid ball round the origin, value ½ at `radius` cells, slope workload::kSlope.
template <int Side>
Field<Side> ball(double radius = workload::kBallRadius) {
  Field<Side> field;
  Edit<CornerBlock<Side>> edit(field.tree);
  const double reach = workload::kSlope / 2;
  const int blocks = static_cast<int>(radius + reach) / Side + 1;
  const auto full = CornerBlock<Side>::uniform(1, kClay);
  for (Key key{-blocks, 0, 0}; key.i < blocks; ++key.i) {
    for (key.j = -blocks; key.j < blocks; ++key.j) {
      for (key.k = -blocks; key.k < blocks; ++key.k) {
        const Span span = spanOf<Side>(key);
        if (span.nearest >= radius + reach) continue;
        if (span.farthest <= radius - reach) {
          edit.replace({key, 1}, full);
        } else {
          fillFromBall(edit.write(key), key, radius);
        }
      }
    }
  }
  edit.commit();
  return field;
}

/// A hundred times a hundred rows of a hundred blocks, far from strokes on the ball but in the
/// same rows of keys. All share one thin block: the tree is what grows.
template <int Side>
void crowd(Field<Side>& field) {
  const auto thin = CornerBlock<Side>::uniform(0.25f, kClay);
  for (Key key{-50, 0, 0}; key.i < 50; ++key.i) {
    for (key.j = -50; key.j < 50; ++key.j) {
      for (key.k = 100; key.k < 300; key.k += 2) field.tree.put(key, thin);
    }
  }
}

template <int Side>
std::string hashOf(const Field<Side>& field) {
  return hexDigits(fieldHash(field));
}

}  // namespace bozzetto::scenes
