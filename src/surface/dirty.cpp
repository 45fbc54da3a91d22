#include "surface/dirty.hpp"

#include <algorithm>
#include <bit>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "bozzetto/base/parallel.hpp"
#include "bozzetto/base/simd.hpp"
#include "bozzetto/surface/surface.hpp"
#include "surface/block_window.hpp"

namespace bozzetto {
namespace {

// Bit n: value n or attributes n differ. -0 does not occur, so equal bits are equal values.
template <int Side>
BOZZETTO_KERNEL std::uint8_t differingBits(const CornerBlock<Side>& a, const CornerBlock<Side>& b,
                                           int at) {
#if defined(__SSE2__)
  if constexpr (Side == 8) {
    const auto equal = [&](int n) {
      const auto load = [](const void* p) {
        return _mm_loadu_si128(static_cast<const __m128i*>(p));
      };
      const __m128i values = _mm_cmpeq_epi32(load(&a.value[n]), load(&b.value[n]));
      const __m128i colours = _mm_cmpeq_epi32(load(&a.attributes[n]), load(&b.attributes[n]));
      return _mm_movemask_ps(_mm_castsi128_ps(_mm_and_si128(values, colours)));
    };
    return static_cast<std::uint8_t>(~(equal(at) | equal(at + 4) << 4));
  }
#endif
  std::uint8_t bits = 0;
  for (int n = 0; n < Side; ++n) {
    const bool same =
        a.value[at + n] == b.value[at + n] && a.attributes[at + n] == b.attributes[at + n];
    bits |= static_cast<std::uint8_t>((same ? 0 : 1) << n);
  }
  return bits;
}

// The first two corners of a block are felt in the patches below, the last one in those above.
Reach reachOf(std::uint32_t touchedPlaces, int side) {
  const bool below = (touchedPlaces & 3) != 0, above = (touchedPlaces >> (side - 1) & 1) != 0;
  return static_cast<Reach>((below ? 1 : 0) | (above ? 2 : 0));
}

template <int Side>
bool surelyAllDirty(const CornerBlock<Side>* before, const CornerBlock<Side>* after) {
  const float lowA = before != nullptr ? before->low : 0, highA = before ? before->high : 0;
  const float lowB = after != nullptr ? after->low : 0, highB = after ? after->high : 0;
  return highA < lowB || highB < lowA;
}

// The places along each axis that hold a dirty corner, as bits.
struct TouchedPlaces {
  std::array<std::uint32_t, 3> bits{};

  void add(int i, int j, std::uint32_t k) {
    bits[0] |= 1u << i;
    bits[1] |= 1u << j;
    bits[2] |= k;
  }
  std::array<Reach, 3> reach(int side) const {
    return {reachOf(bits[0], side), reachOf(bits[1], side), reachOf(bits[2], side)};
  }
};

constexpr std::array<Reach, 3> kFelt{Reach::both, Reach::both, Reach::both};

// Corners of the block first: when they changed, nothing more need be read. Inside a large dab
// most blocks end here.
template <int Side>
std::array<Reach, 3> reachOf(const CornerBlock<Side>* before, const CornerBlock<Side>* after) {
  if (surelyAllDirty(before, after)) return kFelt;
  TouchedPlaces places;
  if (before != nullptr && after != nullptr) {
    for (int corner = 0; corner < 8; ++corner) {
      const int i = (corner >> 2) * (Side - 1), j = (corner >> 1 & 1) * (Side - 1),
                k = (corner & 1) * (Side - 1), at = BlockGeometry<Side>::indexOf(i, j, k);
      if (before->value[at] != after->value[at]) places.add(i, j, 1u << k);
    }
    if (places.reach(Side) == kFelt) return kFelt;
  }
  const CornerBlock<Side>* const none = BlockWindow<Side>::empty();
  const CornerBlock<Side>& a = before != nullptr ? *before : *none;
  const CornerBlock<Side>& b = after != nullptr ? *after : *none;
  for (int n = 0; n < Side && places.reach(Side) != kFelt; ++n) {
    const int i = (n + Side - 1) % Side;  // last, first, and the others
    for (int j = 0; j < Side; ++j) {
      const std::uint8_t bits = differingBits<Side>(a, b, BlockGeometry<Side>::indexOf(i, j, 0));
      if (bits != 0) places.add(i, j, bits);
    }
  }
  return places.reach(Side);
}

}  // namespace

namespace {

// Bits of the corners that differ.
template <int Side>
CornerBits changedCorners(const CornerBlock<Side>* before, const CornerBlock<Side>* after) {
  CornerBits corners{};
  if (surelyAllDirty(before, after)) {
    corners.fill(kAllCorners);
    return corners;
  }
  const CornerBlock<Side>* const none = BlockWindow<Side>::empty();
  const CornerBlock<Side>& a = before != nullptr ? *before : *none;
  const CornerBlock<Side>& b = after != nullptr ? *after : *none;
  for (int row = 0; row < Side * Side; ++row) {
    const std::uint64_t bits = differingBits<Side>(a, b, row * Side);
    corners[row / Side] |= bits << (row % Side * Side);
  }
  return corners;
}

}  // namespace

template <int Side>
std::array<Reach, 3> reachOf(const CornerBits& corners) {
  std::uint64_t all = 0;
  TouchedPlaces places;
  for (int i = 0; i < Side; ++i) {
    all |= corners[i];
    places.bits[0] |= (corners[i] != 0 ? 1u : 0u) << i;
  }
  for (int j = 0; j < Side; ++j) {
    const auto row = static_cast<std::uint32_t>(all >> (j * Side)) & ((1u << Side) - 1);
    places.bits[1] |= (row != 0 ? 1u : 0u) << j;
    places.bits[2] |= row;
  }
  return places.reach(Side);
}

template <int Side>
std::vector<TouchedRun> touchedRuns(const Delta<CornerBlock<Side>>& delta) {
  std::vector<TouchedRun> touched(delta.changes.size());
  parallelFor(touched.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const auto& change = delta.changes[n];
      touched[n].run = {change.key, change.length};
      if (change.length > 1) continue;
      touched[n].reach = reachOf<Side>(change.before.get(), change.after.get());
    }
  });
  return touched;
}

template <int Side>
std::vector<ChangedRun> changedRuns(const Delta<CornerBlock<Side>>& delta) {
  std::vector<ChangedRun> changed(delta.changes.size());
  parallelFor(changed.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const auto& change = delta.changes[n];
      changed[n] = KeyRun{change.key, change.length};
      changed[n].corners = changedCorners<Side>(change.before.get(), change.after.get());
    }
  });
  return changed;
}

template std::array<Reach, 3> reachOf<1>(const CornerBits&);
template std::array<Reach, 3> reachOf<8>(const CornerBits&);
template std::vector<TouchedRun> touchedRuns<1>(const Delta<CornerBlock<1>>&);
template std::vector<TouchedRun> touchedRuns<8>(const Delta<CornerBlock<8>>&);
template std::vector<ChangedRun> changedRuns<1>(const Delta<CornerBlock<1>>&);
template std::vector<ChangedRun> changedRuns<8>(const Delta<CornerBlock<8>>&);

}  // namespace bozzetto
