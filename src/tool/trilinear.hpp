// Trilinear reconstruction of a tool at the corners of a block (Ferley §4.1.2), row by row.
// Positions are integers in 2⁻¹⁶ of the tool's cells: sums of steps are exact, so that block sides,
// instruction sets and mirrored tools agree to the bit, and offsets that miss a corner by rounding
// only hit it.
#pragma once
#include <algorithm>

#include "bozzetto/tool/potential.hpp"
#include "tool/tool_box.hpp"
#include "tool/tool_tile.hpp"

namespace bozzetto {

inline constexpr int kFractionBits = 16;

BOZZETTO_KERNEL std::int32_t wrap(std::uint32_t x) { return static_cast<std::int32_t>(x); }

// ∑ n[a]·step[a] + first on one tool axis. Unsigned: partial sums may wrap, the sum does not.
BOZZETTO_KERNEL std::int32_t positionOn(const FixedFrame& frame, int axis, Key n) {
  const auto part = [&](int grid, std::int32_t count) {
    return static_cast<std::uint32_t>(frame.step[grid][axis]) * static_cast<std::uint32_t>(count);
  };
  return wrap(static_cast<std::uint32_t>(frame.first[axis]) + part(0, n.i) + part(1, n.j) +
              part(2, n.k));
}

struct TilePatch {
  const FixedFrame& frame;
  Key first;  // corner, counted from the frame's cell
  Key base;   // the tool's corner at position 0
  Key low;    // of the box of values
  std::array<int, 3> wide;
  const float* value;
  const ToolBox* box = nullptr;  // whose values they are
};

BOZZETTO_KERNEL float mixed(float a, float b, float t) { return a * (1.0f - t) + b * t; }

// Where a position lies on one axis: corner in the tile, and the way from there to the next.
struct Place {
  std::int32_t corner;
  float fraction;
};

BOZZETTO_KERNEL Place placeOn(std::int32_t position, std::int32_t tileLow) {
  constexpr std::int32_t mask = (1 << kFractionBits) - 1;
  return {(position >> kFractionBits) - tileLow,
          static_cast<float>(position & mask) * (1.0f / (1 << kFractionBits))};
}

// The same of places beyond the box: at its rim.
BOZZETTO_KERNEL Place placeWithin(std::int32_t position, std::int32_t tileLow, std::int32_t last) {
  const Place place = placeOn(position, tileLow);
  return {std::clamp(place.corner, 0, last), place.fraction};
}

BOZZETTO_KERNEL float cellAt(const float* at, std::int32_t strideI, std::int32_t strideJ,
                             const float (&t)[3]) {
  const float near0 = mixed(at[0], at[strideI], t[0]);
  const float near1 = mixed(at[1], at[strideI + 1], t[0]);
  const float far0 = mixed(at[strideJ], at[strideI + strideJ], t[0]);
  const float far1 = mixed(at[strideJ + 1], at[strideI + strideJ + 1], t[0]);
  return mixed(mixed(near0, far0, t[1]), mixed(near1, far1, t[1]), t[2]);
}

// Any rotation: eight corners of the tool's cube a corner of the clay.
template <int Side>
BOZZETTO_KERNEL void turnedBody(const TilePatch& patch, float* result) {
  const FixedFrame& frame = patch.frame;
  const std::int32_t strideJ = patch.wide[2], strideI = patch.wide[1] * strideJ;
  std::int32_t low[3];
  for (const Axis axis : kAxes) low[index(axis)] = patch.low[axis] - patch.base[axis];
  for (int i = 0; i < Side; ++i) {
    for (int j = 0; j < Side; ++j) {
      std::int32_t start[3];
      for (int axis = 0; axis < 3; ++axis)
        start[axis] = positionOn(frame, axis, patch.first + Key{i, j, 0});
      // Local arrays, which nothing else can point to: or the loops would not become vectors.
      std::int32_t at[Side];
      float t[3][Side], row[Side];
      for (int k = 0; k < Side; ++k) {
        Place place[3];
        for (int axis = 0; axis < 3; ++axis) {
          place[axis] =
              placeWithin(start[axis] + k * frame.step[2][axis], low[axis], patch.wide[axis] - 2);
          t[axis][k] = place[axis].fraction;
        }
        at[k] = place[0].corner * strideI + place[1].corner * strideJ + place[2].corner;
      }
      for (int k = 0; k < Side; ++k)
        row[k] = cellAt(patch.value + at[k], strideI, strideJ, {t[0][k], t[1][k], t[2][k]});
      for (int k = 0; k < Side; ++k) result[(i * Side + j) * Side + k] = row[k];
    }
  }
}

// Between two planes of the tile; its rows are whole rows of blocks.
BOZZETTO_KERNEL void mixPlanes(const float* at, int stride, int count, float t, float* out) {
  for (int row = 0; row < count; row += 8)
    for (int n = row; n < row + 8; ++n) out[n] = mixed(at[n], at[n + stride], t);
}

// Along j and k where tool and clay have cells of one size: rows lie as they are read, and nothing
// between goes to memory.
template <int Side>
BOZZETTO_KERNEL void mixRows(const float* near, int stride, const float (&t)[2], float* out) {
  const float* far = near + stride;
  for (int k = 0; k < Side; ++k)
    out[k] = mixed(mixed(near[k], far[k], t[0]), mixed(near[k + 1], far[k + 1], t[0]), t[1]);
}

// No rotation: one axis after the other, whole rows at a time. The same sums in the same order.
template <int Side>
BOZZETTO_KERNEL void alignedBody(const TilePatch& patch, float* result) {
  constexpr int most = ToolTile::kWidest, wideK = ToolTile::kWidestK;
  const std::int32_t strideJ = patch.wide[2], strideI = patch.wide[1] * strideJ;
  Place place[3][Side];
  for (const Axis axis : kAxes)
    for (int n = 0; n < Side; ++n) {
      Key corner = patch.first;
      corner[axis] += n;
      const int a = index(axis);
      place[a][n] = placeOn(positionOn(patch.frame, a, corner), patch.low[axis] - patch.base[axis]);
    }
  const bool oneByOne = patch.frame.step[2][2] == 1 << kFractionBits;
  const int planeRows = patch.wide[1];
  for (int i = 0; i < Side; ++i) {
    alignas(64) float alongI[most * wideK], alongJ[wideK];
    mixPlanes(patch.value + place[0][i].corner * strideI, strideI, planeRows * strideJ,
              place[0][i].fraction, alongI);
    for (int j = 0; j < Side; ++j) {
      const float* row = alongI + place[1][j].corner * strideJ;
      const float tj = place[1][j].fraction;
      float* out = result + (i * Side + j) * Side;
      if (oneByOne) {
        mixRows<Side>(row + place[2][0].corner, strideJ, {tj, place[2][0].fraction}, out);
        continue;
      }
      for (int n = 0; n < strideJ; ++n) alongJ[n] = mixed(row[n], row[n + strideJ], tj);
      for (int k = 0; k < Side; ++k) {
        const float* cell = alongJ + place[2][k].corner;
        out[k] = mixed(cell[0], cell[1], place[2][k].fraction);
      }
    }
  }
}

}  // namespace bozzetto
