#include "clay/projection.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace bozzetto::clay {
namespace {

constexpr float kOverRelaxation = 1.15f;
// How open the surface is while a grip pulls. Air that follows clay grows fingers into it, the
// narrower the faster (Saffman & Taylor 1958), and digs in along the border of what is gripped,
// where the pressure's gradient has no bound. Behind a skin clay gives way over 1/kSkin cells.
// What is pushed stretches too where it is stiff, and its edges would stay behind as rails.
constexpr float kSkin = 0.1f;
constexpr float kSupple = 0.35f;  // stiffness up to which pushed clay has no skin
constexpr auto kAir = static_cast<std::uint8_t>(CellType::air);
constexpr auto kClay = static_cast<std::uint8_t>(CellType::clay);
constexpr auto kClosed = static_cast<std::uint8_t>(CellType::closed);
constexpr auto kGripped = static_cast<std::uint8_t>(CellType::gripped);

struct FaceRow {
  const float *value, *wish;
  const std::uint8_t* type;
  float* face;
  std::ptrdiff_t step;
  int count;
};

BOZZETTO_KERNEL void faceKernel(const FaceRow& row) {
  const float *v = row.value, *d = row.wish, *w = row.value + row.step, *e = row.wish + row.step;
  const std::uint8_t *own = row.type, *next = row.type + row.step;
  float* __restrict face = row.face;
  for (int n = 0; n < row.count; ++n) {
    const float mean = (v[n] * d[n] + w[n] * e[n]) / (v[n] + w[n] + 1e-9f);
    const bool closed = own[n] == kClosed || next[n] == kClosed;
    face[n] = closed ? 0.0f : mean;
  }
}

BOZZETTO_SIMD_DISPATCH(void, faceRow, faceKernel, (const FaceRow& row), (row))

// Displacement at faces: mean of the two cells', by their matter.
void findFaces(Region& region, std::size_t axis) {
  forRows(region.rows(), [&](const Row& row) {
    float* face = &region.face[axis][row.base];
    if (region.wished)
      faceRow({&region.value[row.base], &region.wish[axis][row.base], &region.type[row.base], face,
               region.strides()[axis], row.count});
    else
      std::fill_n(face, row.count, 0.0f);
  });
}

struct SourceRow {
  const float *value, *cover;
  const float* face[3];
  const std::uint8_t* type;
  std::ptrdiff_t step[3];
  float *rhs, *inverse;
  std::uint8_t* air;
  int count;
};

constexpr int kPiece = 256;  // cells of a row at a time: local arrays stay in the cache

// Neighbours that are air, and those that are closed or gripped.
BOZZETTO_KERNEL void neighbourKernel(const SourceRow& row, int first, int count,
                                     std::uint8_t* __restrict air, std::uint8_t* __restrict shut) {
  const std::uint8_t* type = row.type + first;
  for (int n = 0; n < count; ++n) {
    air[n] = 0;
    shut[n] = 0;
  }
  for (const std::ptrdiff_t step : row.step)
    for (const std::ptrdiff_t way : {step, -step})
      for (int n = 0; n < count; ++n) {
        const std::uint8_t next = type[n + way];
        air[n] = static_cast<std::uint8_t>(air[n] + (next == kAir ? 1 : 0));
        shut[n] = static_cast<std::uint8_t>(shut[n] + (next >> 1));
      }
}

// Right side and diagonal of the equation: Σ(Pₙ − P) = div u − e over open neighbours.
BOZZETTO_KERNEL void sourceKernel(const SourceRow& row) {
  std::uint8_t air[kPiece], shut[kPiece];
  for (int first = 0; first < row.count; first += kPiece) {
    const int count = row.count - first < kPiece ? row.count - first : kPiece;
    neighbourKernel(row, first, count, air, shut);
    const float *v = row.value + first, *cover = row.cover + first;
    float* __restrict rhs = row.rhs + first, * __restrict inverse = row.inverse + first;
    for (int n = 0; n < count; ++n) rhs[n] = 0;
    for (int axis = 0; row.face[0] != nullptr && axis < 3; ++axis) {
      const float* face = row.face[axis] + first;
      for (int n = 0; n < count; ++n) rhs[n] += face[n] - face[n - row.step[axis]];
    }
    for (int n = 0; n < count; ++n) {
      const float clay = row.type[first + n] == kClay ? 1.0f : 0.0f;
      float excess = v[n] - (1 - cover[n]);
      excess = excess < -0.5f ? -0.5f : excess > 1.0f ? 1.0f : excess;
      // Surface cells may be partly full; elsewhere clay follows.
      excess = air[n] != 0 && excess < 0 ? 0.0f : excess;
      rhs[n] = clay * (rhs[n] - excess);
      const auto open = static_cast<float>(6 - shut[n]);
      inverse[n] = open > 0 ? clay / open : 0.0f;
    }
    std::uint8_t* __restrict kept = row.air + first;
    for (int n = 0; n < count; ++n)
      kept[n] = static_cast<std::uint8_t>(row.type[first + n] == kClay ? air[n] : 0);
  }
}

BOZZETTO_SIMD_DISPATCH(void, sourceRow, sourceKernel, (const SourceRow& row), (row))

struct FadeRow {
  const float* fade;
  const std::uint8_t* type;
  std::ptrdiff_t step[3];
  float *rhs, *inverse;
  int count;
};

// Where clay moves less freely: with a conductance of m·mₙ a face, and P = Q/m, the equation is
// Σ(Qₙ − (mₙ/m)Q) = rhs/m. Sweeps and coarse grids are as they were; Q is in `pressure`.
BOZZETTO_KERNEL void fadeKernel(const FadeRow& row) {
  float weight[kPiece];
  for (int first = 0; first < row.count; first += kPiece) {
    const int count = row.count - first < kPiece ? row.count - first : kPiece;
    const float* m = row.fade + first;
    const std::uint8_t* type = row.type + first;
    for (int n = 0; n < count; ++n) weight[n] = 0;
    for (const std::ptrdiff_t step : row.step)
      for (const std::ptrdiff_t way : {step, -step})
        for (int n = 0; n < count; ++n)
          weight[n] += static_cast<float>(1 - (type[n + way] >> 1)) * m[n + way];
    float* __restrict rhs = row.rhs + first, * __restrict inverse = row.inverse + first;
    for (int n = 0; n < count; ++n) {
      const float clay = type[n] == kClay ? 1.0f : 0.0f;
      inverse[n] = weight[n] > 0 ? clay * m[n] / weight[n] : 0.0f;
      rhs[n] = clay > 0 ? rhs[n] / m[n] : 0.0f;
    }
  }
}

BOZZETTO_SIMD_DISPATCH(void, fadeRow, fadeKernel, (const FadeRow& row), (row))

void fadeSources(Region& region) {
  if (!region.fade) return;
  const auto& step = region.strides();
  forRows(region.denseRows(), [&](const Row& row) {
    fadeRow({&region.fade[row.base],
             &region.type[row.base],
             {step[0], step[1], step[2]},
             &region.rhs[row.base],
             &region.inverse[row.base],
             row.count});
  });
}

void findSources(Region& region) {
  const auto& step = region.strides();
  forRows(region.denseRows(), [&](const Row& row) {
    const auto face = [&](std::size_t axis) {
      return region.wished ? &region.face[axis][row.base] : nullptr;
    };
    sourceRow({&region.value[row.base],
               &region.cover[row.base],
               {face(0), face(1), face(2)},
               &region.type[row.base],
               {step[0], step[1], step[2]},
               &region.rhs[row.base],
               &region.inverse[row.base],
               &region.mark2[row.base],
               row.count});
  });
}

// Faces to air let through only a part of what others do.
void closeSkin(Region& region, float skin) {
  const auto openness = [&](std::size_t n) { return region.fade ? region.fade[n] : 1.0f; };
  forRows(region.bandRows(), [&](const Row& row) {
    for (std::size_t n = row.base; n < row.base + row.count; ++n) {
      if (region.mark2[n] == 0 || region.inverse[n] <= 0) continue;
      float air = 0;
      for (const std::ptrdiff_t step : region.neighbours())
        if (region.type[n + step] == kAir) air += openness(n + step) / openness(n);
      region.inverse[n] = 1 / (1 / region.inverse[n] - (1 - skin) * air);
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
  std::ptrdiff_t step;
  int count;
  float kept;  // of what the face had: 1, or 0 where nothing was wished
  float skin;  // how open faces to air are
};

// How far a face is open. Branches are masks: clay = 1, closed and gripped have bit 1.
BOZZETTO_KERNEL float wayThrough(const GradientRow& row, std::uint8_t own, std::uint8_t next) {
  const int open = 1 - ((own | next) >> 1 & 1);
  const auto clay = static_cast<float>((own | next) & open);
  const auto both = static_cast<float>(own & next & 1);
  return clay * (row.skin + (1 - row.skin) * both);
}

BOZZETTO_KERNEL void gradientKernel(const GradientRow& row) {
  const std::uint8_t *own = row.type, *next = row.type + row.step;
  const float *p = row.pressure, *q = row.pressure + row.step;
  float* __restrict face = row.face;
  for (int n = 0; n < row.count; ++n) {
    const float way = wayThrough(row, own[n], next[n]);
    face[n] = row.kept * face[n] - way * (q[n] - p[n]);
  }
}

BOZZETTO_SIMD_DISPATCH(void, gradientRow, gradientKernel, (const GradientRow& row), (row))

// The flux is m·mₙ·(Pₙ − P) = m·Qₙ − mₙ·Q.
BOZZETTO_KERNEL void fadedGradientKernel(const GradientRow& row, const float* m) {
  const std::uint8_t *own = row.type, *next = row.type + row.step;
  const float *p = row.pressure, *q = row.pressure + row.step, *mn = m + row.step;
  float* __restrict face = row.face;
  for (int n = 0; n < row.count; ++n) {
    const float way = wayThrough(row, own[n], next[n]);
    face[n] = row.kept * face[n] - way * (m[n] * q[n] - mn[n] * p[n]);
  }
}

BOZZETTO_SIMD_DISPATCH(void, fadedGradientRow, fadedGradientKernel,
                       (const GradientRow& row, const float* m), (row, m))

struct KnownRow {
  const std::uint8_t* type;
  std::uint8_t* known;
  std::ptrdiff_t step[3];
  int count;
};

// Bit a: the face along axis a is one of clay, or of what is gripped.
BOZZETTO_KERNEL void knownKernel(const KnownRow& row) {
  std::uint8_t* __restrict known = row.known;
  const std::uint8_t *own = row.type, *i = own + row.step[0], *j = own + row.step[1],
                     *k = own + row.step[2];
  const int count = row.count;  // bytes may be anybody's: `known` might be it
  for (int n = 0; n < count; ++n) {
    const auto face = [&](std::uint8_t next) {
      const auto both = static_cast<std::uint8_t>(own[n] | next);
      const auto open = static_cast<std::uint8_t>(both & ~(both >> 1));  // clay is 1, closed 2
      const auto gripped = static_cast<std::uint8_t>((own[n] & own[n] >> 1) | (next & next >> 1));
      return static_cast<std::uint8_t>((open | gripped) & 1);
    };
    known[n] = static_cast<std::uint8_t>(face(i[n]) | face(j[n]) << 1 | face(k[n]) << 2);
  }
}

BOZZETTO_SIMD_DISPATCH(void, knownRow, knownKernel, (const KnownRow& row), (row))

// u ← u − ∇P at faces of clay; mark tells which faces are known.
void subtractGradient(Region& region, float skin) {
  const auto& step = region.strides();
  forRows(region.rows(), [&](const Row& row) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const GradientRow faces{&region.type[row.base],
                              &region.pressure[row.base],
                              &region.face[axis][row.base],
                              step[axis],
                              row.count,
                              region.wished ? 1.0f : 0.0f,
                              skin};
      if (region.fade)
        fadedGradientRow(faces, &region.fade[row.base]);
      else
        gradientRow(faces);
    }
  });
  forRows(region.bandRows(), [&](const Row& row) {
    knownRow(
        {&region.type[row.base], &region.mark[row.base], {step[0], step[1], step[2]}, row.count});
    std::fill_n(&region.mark2[row.base], row.count, std::uint8_t{0});
  });
}

struct UnknownRow {
  const float *value, *next;
  const std::uint8_t *type, *nextType, *known, *learnt;
  int count;
  std::uint8_t bit;
};

// Faces of matter that nobody knows the motion of yet.
BOZZETTO_KERNEL void unknownKernel(const UnknownRow& row, std::uint8_t* __restrict unknown) {
  for (int n = 0; n < row.count; ++n) {
    const int matter = row.value[n] + row.next[n] > 0 ? 1 : 0;
    const int known = ((row.known[n] | row.learnt[n]) & row.bit) != 0 ? 1 : 0;
    const int closed = (row.type[n] == kClosed ? 1 : 0) | (row.nextType[n] == kClosed ? 1 : 0);
    unknown[n] = static_cast<std::uint8_t>(matter & (1 - known) & (1 - closed));
  }
}

BOZZETTO_SIMD_DISPATCH(void, unknownRow, unknownKernel,
                       (const UnknownRow& row, std::uint8_t* unknown), (row, unknown))

// The mean of the known faces round this one.
void learnFace(Region& region, std::size_t axis, std::size_t n, const Cells<std::uint8_t>& known,
               Cells<std::uint8_t>& learnt) {
  const auto bit = static_cast<std::uint8_t>(1 << axis);
  float sum = 0;
  int count = 0;
  for (const std::ptrdiff_t next : region.neighbours())
    if ((known[n + next] & bit) != 0) sum += region.face[axis][n + next], ++count;
  if (count == 0) return;
  region.face[axis][n] = sum / static_cast<float>(count);
  learnt[n] |= bit;
}

// Thin matter outside the clay moves with the faces next to it.
void extrapolate(Region& region, std::size_t axis, const Cells<std::uint8_t>& known,
                 Cells<std::uint8_t>& learnt) {
  const std::ptrdiff_t step = region.strides()[axis];
  const auto bit = static_cast<std::uint8_t>(1 << axis);
  forRows(region.bandRows(), [&](const Row& row) {
    std::uint8_t unknown[kPiece];
    for (std::int32_t at = 0; at < row.count; at += kPiece) {
      const std::size_t n = row.base + at;
      const int count = std::min(kPiece, row.count - at);
      unknownRow({&region.value[n], &region.value[n + step], &region.type[n],
                  &region.type[n + step], &known[n], &learnt[n], count, bit},
                 unknown);
      for (int group = 0; group < count; group += Region::kTile) {
        std::uint64_t any;
        std::memcpy(&any, &unknown[group], sizeof any);
        for (int k = group; any != 0 && k < group + Region::kTile; ++k)
          if (unknown[k] != 0) learnFace(region, axis, n + k, known, learnt);
      }
    }
  });
}

// Two rings of faces, the second from both.
void learnFaces(Region& region) {
  for (std::size_t axis = 0; axis < 3; ++axis) extrapolate(region, axis, region.mark, region.mark2);
  forRows(region.bandRows(), [&](const Row& row) {
    for (std::size_t n = row.base; n < row.base + row.count; ++n) {
      region.mark[n] |= region.mark2[n];
      region.mark2[n] = 0;
    }
  });
  for (std::size_t axis = 0; axis < 3; ++axis) extrapolate(region, axis, region.mark, region.mark2);
  forRows(region.bandRows(), [&](const Row& row) {
    std::fill_n(&region.mark[row.base], row.count, std::uint8_t{0});
    std::fill_n(&region.mark2[row.base], row.count, std::uint8_t{0});
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
  const int count = row.count;
  const float *value = row.value, *cover = row.cover;
  const std::uint8_t* hold = row.hold;
  std::uint8_t* __restrict type = row.type;
  for (int n = 0; n < count; ++n) {
    const int clay = value[n] >= 0.5f ? 1 : 0;
    const int closed = (hold[n] == kFixed ? 1 : 0) | (cover[n] > 0.5f ? 1 : 0);
    type[n] = static_cast<std::uint8_t>(closed * kClosed | clay * (1 - closed));
  }
  float* __restrict pressure = row.pressure, * __restrict next = row.pressureNext;
  for (int n = 0; n < count; ++n) {
    pressure[n] *= static_cast<float>(type[n] & kClay);
    next[n] = 0;
  }
}

BOZZETTO_SIMD_DISPATCH(void, typeRow, typeKernel, (const TypeRow& row), (row))

float skinOf(const Work& work) {
  if (work.grips()) return kSkin;
  if (!work.region.wished) return 1;
  const auto stiffness = static_cast<float>(work.settings.stiffness);
  return 1 - (1 - kSkin) * std::max(0.0f, stiffness - kSupple) / (1 - kSupple);
}

}  // namespace

void findTypes(Work& work) {
  Region& region = work.region;
  const bool grips = work.grips();
  // No tool and no air in deep rows.
  forRows(region.deepRows(), [&](const Row& row) {
    for (std::size_t n = row.base; n < row.base + row.count; ++n)
      region.type[n] = region.hold[n] == kFixed ? kClosed : kClay;
  });
  forRows(region.bandRows(), [&](const Row& row) {
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

void beginWish(Region& region) {
  for (auto& axis : region.wish)
    if (!region.wished)
      forRows(region.rows(),
              [&](const Row& row) { std::fill_n(&axis[row.base], row.count, 0.0f); });
  region.wished = true;
}

void followWish(Work& work) {
  findTypes(work);
  for (std::size_t axis = 0; axis < 3; ++axis) findFaces(work.region, axis);
  work.region.wished = false;
}

void Projection::run(Work& work, const SolverOptions& options) {
  Region& region = work.region;
  findTypes(work);
  if (region.wished)
    for (std::size_t axis = 0; axis < 3; ++axis) findFaces(region, axis);
  findSources(region);
  fadeSources(region);
  const float skin = skinOf(work);
  if (skin < 1) closeSkin(region, skin);
  grid_.prepare(region, skin);
  for (int cycle = 0; cycle < options.cycles; ++cycle) {
    for (int n = 0; n < 2 * options.before; ++n) sweep(region, n % 2, kOverRelaxation);
    grid_.correct(region);
    for (int n = 0; n < 2 * options.after; ++n)
      sweep(region, n % 2, n < 2 * options.after - 2 ? kOverRelaxation : 1.0f);
  }
  subtractGradient(region, skin);
  learnFaces(region);
  region.wished = false;
}

}  // namespace bozzetto::clay
