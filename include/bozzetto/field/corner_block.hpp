// Corners: samples of the density field with colour and hold (Ferley §3.1; algorithms §0), in
// blocks of Side³. Side 1 is the paper's Corner; 8 is what the program uses.
#pragma once
#include <array>
#include <cstdint>

#include "bozzetto/base/colour.hpp"
#include "bozzetto/grid/key.hpp"
#include "bozzetto/grid/ref.hpp"

namespace bozzetto {

/// Colour and hold of a corner in 4 bytes: r | g << 8 | b << 16 | hold << 24. A corner without
/// clay (value 0) has none: 0.
using Attributes = std::uint32_t;

constexpr Attributes packAttributes(Colour colour, std::uint8_t hold = 0) {
  return Attributes{colour.r} | Attributes{colour.g} << 8 | Attributes{colour.b} << 16 |
         Attributes{hold} << 24;
}
constexpr Colour colourOf(Attributes a) {
  return {static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(a >> 8),
          static_cast<std::uint8_t>(a >> 16)};
}
constexpr std::uint8_t holdOf(Attributes a) { return static_cast<std::uint8_t>(a >> 24); }

/// Mass in units of 2⁻⁴⁰ full cells. Integers, so that sums do not depend on their order: the
/// ledger balances exactly.
using MassUnits = std::int64_t;
inline constexpr double kMassUnit = 0x1p-40;
__extension__ typedef __int128 MassSum;  ///< of whole fields

struct ForOverwrite {};

template <int Side>
struct CornerBlock : RefCounted {
  using Geometry = BlockGeometry<Side>;
  static constexpr int kSide = Side;
  static constexpr int kCount = Geometry::kCount;

  // What others ask first shares a cache line with the count of holders.
  float low = 0, high = 0;  ///< least and greatest value: what the surface asks first
  bool interned = false;    ///< the one shared block of its uniform content; never written
  bool oneColour = false;   ///< settled blocks: all corners with clay have the attributes `only`
  Attributes only = 0;
  MassUnits mass = 0;  ///< of all corners; true in committed blocks
  alignas(Side >= 8 ? 64 : 4) std::array<float, kCount> value;
  std::array<Attributes, kCount> attributes;

  CornerBlock() : value{}, attributes{} {}
  explicit CornerBlock(ForOverwrite) {}  ///< for who writes every corner: content undefined
  CornerBlock(const CornerBlock& other);

  /// Brings low and high up to date. Whoever writes values calls it before anybody reads the
  /// surface. ~40 ns at side 8.
  void updateRange();

  /// Null when no corner holds clay; the interned block when all corners are equal (side 8);
  /// otherwise the same block with attributes of empty corners cleared, range, colour and mass
  /// right, settled. Only the mass is made where the block is settled already.
  static Ref<CornerBlock> canonical(Ref<CornerBlock> block);

  /// The one block whose corners all have this value and these attributes. Thread-safe.
  static Ref<CornerBlock> uniform(float value, Attributes attributes);

  bool sameAs(const CornerBlock& other) const;

  static void* operator new(std::size_t size);
  static void operator delete(void* block, std::size_t size);
};

extern template struct CornerBlock<1>;
extern template struct CornerBlock<8>;

}  // namespace bozzetto
