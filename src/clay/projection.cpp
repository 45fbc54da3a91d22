#include "clay/projection.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace bozzetto::clay {
namespace {

constexpr float kOverRelaxation = 1.85f;
constexpr auto kAir = static_cast<std::uint8_t>(CellType::air);
constexpr auto kClay = static_cast<std::uint8_t>(CellType::clay);
constexpr auto kClosed = static_cast<std::uint8_t>(CellType::closed);
constexpr auto kGripped = static_cast<std::uint8_t>(CellType::gripped);

// Displacement at faces: mean of the two cells', by their matter.
void findFaces(Region& region, std::size_t axis) {
  const std::ptrdiff_t step = region.strides()[axis];
  forRows(region.rows(), [&](const Row& row) {
    float* face = &region.face[axis][row.base];
    if (!region.wished) {
      std::fill_n(face, row.count, 0.0f);
      return;
    }
    const float *v = &region.value[row.base], *d = &region.wish[axis][row.base];
    const std::uint8_t* type = &region.type[row.base];
    for (std::ptrdiff_t n = 0; n < row.count; ++n) {
      const float mean = (v[n] * d[n] + v[n + step] * d[n + step]) / (v[n] + v[n + step] + 1e-9f);
      face[n] = type[n] == kClosed || type[n + step] == kClosed ? 0.0f : mean;
    }
  });
}

// Right side and diagonal of the equation: Σ(Pₙ − P) = div u − e over open neighbours.
void findSources(Region& region) {
  const auto& step = region.strides();
  const auto& around = region.neighbours();
  forRows(region.denseRows(), [&](const Row& row) {
    for (std::size_t n = row.base; n < row.base + row.count; ++n) {
      region.inverse[n] = 0;
      region.rhs[n] = 0;
      if (region.type[n] != kClay) continue;
      int open = 0;
      bool surface = false;
      for (const std::ptrdiff_t next : around) {
        const std::uint8_t type = region.type[n + next];
        open += type < kClosed ? 1 : 0;
        surface = surface || type == kAir;
      }
      float divergence = 0;
      for (std::size_t axis = 0; axis < 3; ++axis)
        divergence += region.face[axis][n] - region.face[axis][n - step[axis]];
      // Surface cells may be partly full; elsewhere clay follows.
      const float excess = std::clamp(region.value[n] - (1 - region.cover[n]), -0.5f, 1.0f);
      region.rhs[n] = divergence - (surface ? std::max(excess, 0.0f) : excess);
      region.inverse[n] = open > 0 ? 1.0f / static_cast<float>(open) : 0.0f;
    }
  });
}

struct SweepRow {
  const float *pressure, *rhs, *inverse;
  float* next;
  std::ptrdiff_t di, dj;
  int count;
  float even, odd;  // relaxation of cells at even and odd places of the row
};

// Cells of the other colour have relaxation 0, those outside the clay pressure and inverse 0: no
// branch.
BOZZETTO_KERNEL void sweepKernel(const SweepRow& row) {
  const float *p = row.pressure, *rhs = row.rhs, *inverse = row.inverse;
  float* __restrict next = row.next;
  for (int n = 0; n < row.count; ++n) {
    const float relaxation = (n & 1) != 0 ? row.odd : row.even;
    const float sum =
        ((p[n + row.di] + p[n - row.di]) + (p[n + row.dj] + p[n - row.dj])) + (p[n + 1] + p[n - 1]);
    next[n] = p[n] + relaxation * ((sum - rhs[n]) * inverse[n] - p[n]);
  }
}

BOZZETTO_SIMD_DISPATCH(void, sweepRow, sweepKernel, (const SweepRow& row), (row))

// One colour of the checkerboard, which is fixed to keys. Reads one array and writes the other, so
// threads never meet.
void sweep(Region& region, int colour, float relaxation) {
  const auto& step = region.strides();
  const Key low = region.box().low;
  forRows(region.denseRows(), [&](const Row& row) {
    const bool even = ((low.i + row.i + low.j + row.j + low.k + row.k + colour) & 1) == 0;
    sweepRow({&region.pressure[row.base], &region.rhs[row.base], &region.inverse[row.base],
              &region.pressureNext[row.base], step[0], step[1], row.count, even ? relaxation : 0.0f,
              even ? 0.0f : relaxation});
  });
  swap(region.pressure, region.pressureNext);
}

struct GradientRow {
  const std::uint8_t* type;
  const float* pressure;
  float* face;
  std::uint8_t* known;
  std::ptrdiff_t step;
  int count;
  std::uint8_t bit;
};

// Branches are masks: clay = 1, closed and gripped have bit 1.
BOZZETTO_KERNEL void gradientKernel(const GradientRow& row) {
  const std::uint8_t *own = row.type, *next = row.type + row.step;
  const float *p = row.pressure, *q = row.pressure + row.step;
  for (int n = 0; n < row.count; ++n) {
    const int open = 1 - ((own[n] | next[n]) >> 1 & 1);
    const int clay = (own[n] | next[n]) & open;
    row.face[n] -= static_cast<float>(clay) * (q[n] - p[n]);
  }
  for (int n = 0; n < row.count; ++n) {
    const int both = own[n] | next[n], open = 1 - (both >> 1 & 1);
    const int gripped = (own[n] == kGripped ? 1 : 0) | (next[n] == kGripped ? 1 : 0);
    row.known[n] |= static_cast<std::uint8_t>(((both & open) | gripped) * row.bit);
  }
}

BOZZETTO_SIMD_DISPATCH(void, gradientRow, gradientKernel, (const GradientRow& row), (row))

// u ← u − ∇P at faces of clay; mark tells which faces are known (bit a for axis a).
void subtractGradient(Region& region) {
  forRows(region.rows(), [&](const Row& row) {
    std::fill_n(&region.mark[row.base], row.count, std::uint8_t{0});
    std::fill_n(&region.mark2[row.base], row.count, std::uint8_t{0});
    for (std::size_t axis = 0; axis < 3; ++axis)
      gradientRow({&region.type[row.base], &region.pressure[row.base], &region.face[axis][row.base],
                   &region.mark[row.base], region.strides()[axis], row.count,
                   static_cast<std::uint8_t>(1 << axis)});
  });
}

// Eight faces at a time: most are known, or in air.
bool nothingToLearn(const Region& region, const Cells<std::uint8_t>& known, std::size_t n,
                    std::size_t axis) {
  std::uint64_t marks;
  std::memcpy(&marks, &known[n], 8);
  const std::uint64_t wanted = 0x0101010101010101u << axis;
  if ((marks & wanted) == wanted) return true;
  float sum = 0;
  for (std::size_t k = n; k < n + 8; ++k)
    sum += region.value[k] + region.value[k + region.strides()[axis]];
  return sum <= 0;
}

// Thin matter outside the clay moves with the faces next to it.
void extrapolate(Region& region, std::size_t axis, const Cells<std::uint8_t>& known,
                 Cells<std::uint8_t>& learnt) {
  const std::ptrdiff_t step = region.strides()[axis];
  const auto bit = static_cast<std::uint8_t>(1 << axis);
  forRows(region.rows(), [&](const Row& row) {
    for (std::size_t n = row.base; n < row.base + row.count; ++n) {
      if ((n - row.base) % 8 == 0 && nothingToLearn(region, known, n, axis)) {
        n += 7;
        continue;
      }
      if (((known[n] | learnt[n]) & bit) != 0) continue;
      if (region.value[n] + region.value[n + step] <= 0) continue;
      if (region.type[n] == kClosed || region.type[n + step] == kClosed) continue;
      float sum = 0;
      int count = 0;
      for (const std::ptrdiff_t next : region.neighbours())
        if ((known[n + next] & bit) != 0) sum += region.face[axis][n + next], ++count;
      if (count == 0) continue;
      region.face[axis][n] = sum / static_cast<float>(count);
      learnt[n] |= bit;
    }
  });
}

struct TypeRow {
  const float *value, *cover;
  const std::uint8_t* hold;
  std::uint8_t* type;
  float *pressure, *pressureNext;
  int count;
};

BOZZETTO_KERNEL void typeKernel(const TypeRow& row) {
  for (int n = 0; n < row.count; ++n) {
    const int clay = row.value[n] >= 0.5f ? 1 : 0;
    const int closed = (row.hold[n] == kFixed ? 1 : 0) | (row.cover[n] > 0.5f ? 1 : 0);
    row.type[n] = static_cast<std::uint8_t>(closed * kClosed | clay * (1 - closed));
  }
  for (int n = 0; n < row.count; ++n) {
    row.pressure[n] *= row.type[n] == kClay ? 1.0f : 0.0f;
    row.pressureNext[n] = 0;
  }
}

BOZZETTO_SIMD_DISPATCH(void, typeRow, typeKernel, (const TypeRow& row), (row))

}  // namespace

void findTypes(Work& work) {
  Region& region = work.region;
  bool grips = false;
  for (const PlacedTool& tool : work.moving) grips = grips || tool.role == Role::grip;
  forRows(region.rows(), [&](const Row& row) {
    typeRow({&region.value[row.base], &region.cover[row.base], &region.hold[row.base],
             &region.type[row.base], &region.pressure[row.base], &region.pressureNext[row.base],
             row.count});
    if (!grips) return;
    for (std::size_t n = row.base; n < row.base + row.count; ++n)
      if (region.owner[n] >= kMoving && region.value[n] >= kThin && region.type[n] != kClosed &&
          work.moving[region.owner[n] - kMoving].role == Role::grip) {
        region.type[n] = kGripped;
        region.pressure[n] = 0;
      }
  });
}

void followWish(Work& work) {
  findTypes(work);
  for (std::size_t axis = 0; axis < 3; ++axis) findFaces(work.region, axis);
  work.region.wished = false;
}

void project(Work& work, const SolverOptions& options) {
  Region& region = work.region;
  findTypes(work);
  for (std::size_t axis = 0; axis < 3; ++axis) findFaces(region, axis);
  findSources(region);
  for (int n = 0; n < 2 * (options.sweeps + options.settlingSweeps); ++n)
    sweep(region, n % 2, n < 2 * options.sweeps ? kOverRelaxation : 1.0f);
  subtractGradient(region);
  // Two rings of faces, the second from both.
  for (std::size_t axis = 0; axis < 3; ++axis) extrapolate(region, axis, region.mark, region.mark2);
  forRows(region.rows(), [&](const Row& row) {
    for (std::size_t n = row.base; n < row.base + row.count; ++n) {
      region.mark[n] |= region.mark2[n];
      region.mark2[n] = 0;
    }
  });
  for (std::size_t axis = 0; axis < 3; ++axis) extrapolate(region, axis, region.mark, region.mark2);
  forRows(region.rows(), [&](const Row& row) {
    std::fill_n(&region.mark[row.base], row.count, std::uint8_t{0});
    std::fill_n(&region.mark2[row.base], row.count, std::uint8_t{0});
  });
  region.wished = false;
}

}  // namespace bozzetto::clay
