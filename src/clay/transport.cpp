#include "clay/transport.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "clay/thinc.hpp"

namespace bozzetto::clay {
namespace {

constexpr float kPlainDensity = 0.98f;  // fuller cells among such have no surface
constexpr int kPiece = 256;             // cells of a row at a time: local arrays stay in the cache

struct RowSource {
  const float* v;
  std::ptrdiff_t along;     // to the next cell of the axis in question
  std::ptrdiff_t other[2];  // to the next cells of the other axes
};

constexpr float kMostMove = 0.9f;  // cells a step: a cell never gives what it has not

BOZZETTO_KERNEL float limited(float u) {
  const float low = u > -kMostMove ? u : -kMostMove;
  return low < kMostMove ? low : kMostMove;
}

BOZZETTO_KERNEL float sizeOf(float x) {
  return std::bit_cast<float>(std::bit_cast<std::int32_t>(x) & 0x7fffffff);
}

// Where less of the surface faces the axis, waves along it would grow into terraces if they were
// sharpened by as much.
constexpr float kGrazing = 0.25f;

// How squarely the surface faces the axis: ±|g_a| / (|g_x| + |g_y| + |g_z|), positive where density
// rises along it; below kGrazing its square, over kGrazing.
BOZZETTO_KERNEL void slopes(const RowSource& row, int count, float* slope) {
  const float* v = row.v;
  for (int n = 0; n < count; ++n) {
    const float a = v[n + row.along] - v[n - row.along];
    const float b = v[n + row.other[0]] - v[n - row.other[0]];
    const float c = v[n + row.other[1]] - v[n - row.other[1]];
    const float facing = a / (((sizeOf(a) + sizeOf(b)) + sizeOf(c)) + 1e-9f);
    const float part = sizeOf(facing) * (1 / kGrazing);
    slope[n] = facing * (part < 1 ? part : 1.0f);
  }
}

// Flux through a face out of a donor: THINC as far as the surface faces the axis, upwind for the
// rest (clay.md §3.4). `back` is what may leave the donor through its other side.
BOZZETTO_KERNEL float fluxOut(float density, float slope, float u, float back) {
  const float up = density * u;
  const float inside = density < 0.9999f ? density : 0.9999f;
  const float sharp = thincFlux(inside > 1e-4f ? inside : 1e-4f, u, slope > 0 ? 1.0f : -1.0f);
  const float weight = sizeOf(slope);
  const bool mixed = density > 1e-5f && density < 1.0f - 1e-5f;
  const float blend = mixed ? up + weight * (sharp - up) : up;
  const float most = back > 0 ? density * (u / (u + back)) - kQuantum : density;
  const float given = blend < most ? blend : most;
  return given > 0 ? given : 0.0f;
}

// What one of its two neighbours on an axis may give a cell.
BOZZETTO_KERNEL float shareOfRoom(float density) {
  const float room = 0.5f * (kMostDensity - density);
  return room > 0 ? room : 0.0f;
}

struct FluxRow {
  RowSource source;
  const float* face;
  float* flux;
  int count;
};

BOZZETTO_KERNEL void fluxKernel(const FluxRow& row) {
  float own[kPiece], next[kPiece];
  slopes(row.source, row.count, own);
  const std::ptrdiff_t along = row.source.along;
  slopes({row.source.v + along, along, {row.source.other[0], row.source.other[1]}}, row.count,
         next);
  const float* v = row.source.v;
  for (int n = 0; n < row.count; ++n) {
    const float u = limited(row.face[n]);
    const bool forward = u > 0;
    const float density = forward ? v[n] : v[n + along];
    const float slope = forward ? own[n] : -next[n];
    const float other = limited(forward ? -row.face[n - along] : row.face[n + along]);
    const float out = fluxOut(density, slope, sizeOf(u), other > 0 ? other : 0.0f);
    const float room = shareOfRoom(forward ? v[n + along] : v[n]);
    const float whole = quantised(out < room ? out : room);
    const float kept = whole < density ? whole : density;
    row.flux[n] = forward ? kept : -kept;
  }
}

BOZZETTO_SIMD_DISPATCH(void, fluxRow, fluxKernel, (const FluxRow& row), (row))

// Upwind: full clay among full clay has no edge to keep sharp.
BOZZETTO_KERNEL void plainFluxKernel(const FluxRow& row) {
  const float *v = row.source.v, *face = row.face;
  float* __restrict flux = row.flux;
  const std::ptrdiff_t along = row.source.along;
  // Products in place of branches, one comparison a loop: a compiler makes vectors of them.
  float ahead[kPiece], taken[kPiece], out[kPiece];
  for (int n = 0; n < row.count; ++n) ahead[n] = face[n] > 0 ? 1.0f : 0.0f;
  for (int n = 0; n < row.count; ++n) {
    const float other = (1 - ahead[n]) * face[n + along] - ahead[n] * face[n - along];
    const float back = 0.5f * (sizeOf(other) + other);
    taken[n] = back < kMostMove ? back : kMostMove;
  }
  for (int n = 0; n < row.count; ++n) {
    const float size = sizeOf(face[n]);
    out[n] = size < kMostMove ? size : kMostMove;
  }
  for (int n = 0; n < row.count; ++n) {
    const float left = 1 - taken[n];  // both sides together give at most all
    const float part = out[n] < left ? out[n] : left;
    const float density = ahead[n] * v[n] + (1 - ahead[n]) * v[n + along];
    const float room = shareOfRoom((1 - ahead[n]) * v[n] + ahead[n] * v[n + along]);
    const float given = density * part;
    const float whole = quantised((given < room ? given : room) - kQuantum);
    flux[n] = (2 * ahead[n] - 1) * (0.5f * (sizeOf(whole) + whole));
  }
}

BOZZETTO_SIMD_DISPATCH(void, plainFluxRow, plainFluxKernel, (const FluxRow& row), (row))

struct MoveRow {
  const float* flux;
  float* value;
  std::ptrdiff_t step;
  int count;
};

BOZZETTO_KERNEL void moveKernel(const MoveRow& row) {
  const float* flux = row.flux;
  float* __restrict value = row.value;
  for (int n = 0; n < row.count; ++n) value[n] += flux[n - row.step] - flux[n];
}

BOZZETTO_SIMD_DISPATCH(void, moveRow, moveKernel, (const MoveRow& row), (row))

// What eight faces of a row have to do: nothing, or upwind for full clay, or THINC.
enum Way : std::uint8_t { kStill, kPlain, kSharp };
constexpr int kGroup = 8;

BOZZETTO_KERNEL void waysKernel(const FluxRow& row, std::uint8_t* ways) {
  const float *v = row.source.v, *face = row.face;
  const std::ptrdiff_t along = row.source.along;
  std::uint8_t seen[kPiece];
  for (int n = 0; n < row.count; ++n) {
    const int moved = face[n] != 0 ? 1 : 0;
    const int mixed = (v[n] < kPlainDensity ? 1 : 0) | (v[n + along] < kPlainDensity ? 1 : 0);
    const int any = (v[n] > 0 ? 1 : 0) | (v[n + along] > 0 ? 1 : 0);
    seen[n] = static_cast<std::uint8_t>((moved & any) | mixed << 1);
  }
  for (int group = 0; group * kGroup < row.count; ++group) {
    std::uint64_t all;
    std::memcpy(&all, &seen[group * kGroup], sizeof all);
    const bool moves = (all & 0x0101010101010101u) != 0, mixed = (all & 0x0202020202020202u) != 0;
    ways[group] = !moves ? kStill : mixed ? kSharp : kPlain;
  }
}

BOZZETTO_SIMD_DISPATCH(void, waysOfRow, waysKernel, (const FluxRow& row, std::uint8_t* ways),
                       (row, ways))

void fluxOf(const FluxRow& row, Way way) {
  if (way == kStill)
    std::fill_n(row.flux, row.count, 0.0f);
  else if (way == kPlain)
    plainFluxRow(row);
  else
    fluxRow(row);
}

// Groups that have the same to do in one go.
void fluxPiece(const FluxRow& piece) {
  std::uint8_t ways[kPiece / kGroup];
  waysOfRow(piece, ways);
  for (int first = 0; first < piece.count;) {
    int end = first + kGroup;
    while (end < piece.count && ways[end / kGroup] == ways[first / kGroup]) end += kGroup;
    FluxRow part = piece;
    part.source.v += first;
    part.face += first;
    part.flux += first;
    part.count = end - first;
    fluxOf(part, static_cast<Way>(ways[first / kGroup]));
    first = end;
  }
}

void findFluxes(Region& region, std::size_t axis) {
  const auto& step = region.strides();
  forRows(region.rows(), [&](const Row& row) {
    for (std::int32_t at = 0; at < row.count; at += kPiece) {
      const std::size_t first = row.base + at;
      fluxPiece({{&region.value[first], step[axis], {step[(axis + 1) % 3], step[(axis + 2) % 3]}},
                 &region.face[axis][first],
                 &region.flux[first],
                 std::min(kPiece, row.count - at)});
    }
  });
}

// The colour or stiffness that crosses a face: the donor's, bent towards its neighbours by a
// limiter (superbee) so that borders stay sharp.
float carriedAcross(const Region& region, const Cells<float>& c, std::size_t donor,
                    std::ptrdiff_t ahead) {
  const float here = c[donor], u = 0.5f;
  if (region.value[donor + ahead] <= 0 || region.value[donor - ahead] <= 0) return here;
  const float forward = c[donor + ahead] - here, behind = here - c[donor - ahead];
  if (forward * behind <= 0) return here;
  const float r = behind / forward;
  const float limiter = std::max(std::min(2 * r, 1.0f), std::min(r, 2.0f));
  return here + 0.5f * (1 - u) * limiter * forward;
}

// What is carried = matter-weighted mean of what stays and what comes.
void moveCarried(Region& region, std::size_t axis) {
  const std::ptrdiff_t step = region.strides()[axis];
  for (auto& channel : region.carried) {
    forRows(region.rows(), [&](const Row& row) {
      for (std::size_t n = row.base; n < row.base + row.count; ++n) {
        const float in = region.flux[n - step], out = region.flux[n];
        region.scratch[n] = channel[n];
        if (in == 0 && out == 0) continue;
        const auto carried = [&](float flux, std::size_t from, std::size_t to) {
          const std::size_t donor = flux > 0 ? from : to;
          return flux * carriedAcross(region, channel, donor, flux > 0 ? step : -step);
        };
        const float before = region.value[n], after = before + in - out;
        const float sum =
            before * channel[n] + carried(in, n - step, n) - carried(out, n, n + step);
        if (after > 0) region.scratch[n] = std::clamp(sum / after, 0.0f, 255.0f);
      }
    });
    forRows(region.rows(), [&](const Row& row) {
      std::copy_n(&region.scratch[row.base], row.count, &channel[row.base]);
    });
  }
}

void moveMatter(Region& region, std::size_t axis) {
  const std::ptrdiff_t step = region.strides()[axis];
  forRows(region.rows(), [&](const Row& row) {
    moveRow({&region.flux[row.base], &region.value[row.base], step, row.count});
  });
}

}  // namespace

void transport(Work& work) {
  Region& region = work.region;
  for (std::size_t n = 0; n < 3; ++n) {
    const std::size_t axis = work.step % 2 == 0 ? n : 2 - n;
    findFluxes(region, axis);
    moveCarried(region, axis);
    moveMatter(region, axis);
  }
  region.touchRows();
}

}  // namespace bozzetto::clay
