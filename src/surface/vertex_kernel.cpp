#include "surface/vertex_kernel.hpp"

#include <bit>

#include "bozzetto/base/simd.hpp"

// Nobody reads floating-point exception flags; GCC vectorises selections only when told so.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("no-trapping-math")
#endif

namespace bozzetto {
namespace {

constexpr float kLeast = 0x1p-12f;  // two crossings on edges of one corner never coincide
constexpr float kRounder = 12.0f;   // numbers in [8, 16) are multiples of 2⁻²⁰

BOZZETTO_KERNEL float crossingAt(float a, float b, float iso) {
  float t = (iso - a) / (b - a);
  t = t < kLeast ? kLeast : t;
  t = t > 1 - kLeast ? 1 - kLeast : t;
  return (t + kRounder) - kRounder;
}

// What a neighbour would hold if density did not stop at 0 and 1: deposits and imports slope over
// two cells and are flat outside, where differences would turn normals by up to 5 degrees.
BOZZETTO_KERNEL float unclamped(float neighbour, float straightOn) {
  const float less = straightOn < neighbour ? straightOn : neighbour;
  const float more = straightOn > neighbour ? straightOn : neighbour;
  const float low = neighbour > 0 ? neighbour : less;
  return neighbour >= 1 ? more : low;
}

// Twice the derivative at a corner, from its neighbours along one axis.
BOZZETTO_KERNEL float slope(float below, float here, float above) {
  const float high = unclamped(above, 2 * here - below), low = unclamped(below, 2 * here - above);
  const float inside = here > 0 ? high - low : above - below;
  return here >= 1 ? above - below : inside;
}

BOZZETTO_KERNEL std::int32_t rounded(float x) {
  return static_cast<std::int32_t>(x + __builtin_copysignf(0.5f, x));
}

// A vector of any length onto the octahedron, 16 bits a coordinate.
BOZZETTO_KERNEL std::uint32_t octahedral(float x, float y, float z) {
  const float sum = __builtin_fabsf(x) + __builtin_fabsf(y) + __builtin_fabsf(z);
  const float scale = 32767.0f / (sum > 0 ? sum : 1.0f);
  const float u = x * scale, v = y * scale;
  const float foldedU = __builtin_copysignf(32767.0f - __builtin_fabsf(v), u);
  const float foldedV = __builtin_copysignf(32767.0f - __builtin_fabsf(u), v);
  const auto packedU = static_cast<std::uint32_t>(rounded(z < 0 ? foldedU : u));
  const auto packedV = static_cast<std::uint32_t>(rounded(z < 0 ? foldedV : v));
  return (packedU & 0xffff) | packedV << 16;
}

// Four 8-bit channels, `weight` of 256 parts b.
BOZZETTO_KERNEL std::uint32_t mixed(std::uint32_t a, std::uint32_t b, std::uint32_t weight) {
  constexpr std::uint32_t kEven = 0x00ff00ff, kHalf = 0x00800080;
  const std::uint32_t even = ((a & kEven) * (256 - weight) + (b & kEven) * weight + kHalf) >> 8;
  const std::uint32_t odd = (a >> 8 & kEven) * (256 - weight) + (b >> 8 & kEven) * weight + kHalf;
  return (even & kEven) | (odd & ~kEven);
}

BOZZETTO_KERNEL void finishKernel(CrossingEdges& e, int count, float iso) {
  for (int n = 0; n < count; ++n) {
    const float a = e.valueA[n], b = e.valueB[n], t = crossingAt(a, b, iso);
    const auto along = [t](float from, float to) { return from + (to - from) * t; };
    const auto place = static_cast<std::int32_t>(e.place[n]), axis = place >> 24;
    e.position[0][n] = static_cast<float>(place & 255) + (axis == 0 ? t : 0.0f);
    e.position[1][n] = static_cast<float>(place >> 8 & 255) + (axis == 1 ? t : 0.0f);
    e.position[2][n] = static_cast<float>(place >> 16 & 255) + (axis == 2 ? t : 0.0f);
    const auto falling = [&](int d) {
      return -along(slope(e.belowA[d][n], a, e.aboveA[d][n]),
                    slope(e.belowB[d][n], b, e.aboveB[d][n]));
    };
    e.normal[n] = octahedral(falling(0), falling(1), falling(2));
    // A corner without clay has no colour to give.
    float part = t * 256 + 0.5f;
    part = b > 0 ? part : 0.0f;
    part = a > 0 ? part : 256.0f;
    const auto weight = static_cast<std::uint32_t>(static_cast<std::int32_t>(part));
    e.colour[n] = mixed(e.coloursA[n], e.coloursB[n], weight);
  }
}

BOZZETTO_SIMD_DISPATCH(void, finishDispatched, finishKernel,
                       (CrossingEdges & edges, int count, float iso), (edges, count, iso))

}  // namespace

void finishVertices(CrossingEdges& edges, int count, float iso) {
  finishDispatched(edges, count, iso);
}

std::array<std::int16_t, 2> packedNormal(float x, float y, float z) {
  return std::bit_cast<std::array<std::int16_t, 2>>(octahedral(x, y, z));
}

}  // namespace bozzetto
