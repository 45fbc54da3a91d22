// From the two ends of crossing edges to finished vertices, many at a time.
#pragma once
#include <array>
#include <cstdint>

#include "bozzetto/surface/patch.hpp"

namespace bozzetto {

/// Crossing edges of one block, one array a quantity so that eight are worked on at once.
struct CrossingEdges {
  static constexpr int kMost = 1952;  // 3·9·9·8 edges of a block of side 8, and up to a full row

  using Floats = std::array<float, kMost>;
  alignas(64) Floats valueA, valueB;                                 ///< smaller corner first
  alignas(64) std::array<Floats, 3> belowA, aboveA, belowB, aboveB;  ///< neighbours by axis
  alignas(64) std::array<std::uint32_t, kMost> coloursA, coloursB;   ///< Attributes
  alignas(64) std::array<std::uint32_t, kMost> place;                ///< of the smaller corner
  alignas(64) std::array<Floats, 3> position;                        ///< out
  alignas(64) std::array<std::uint32_t, kMost> normal, colour;       ///< out

  static constexpr std::uint32_t placeOf(int i, int j, int k, int axis) {
    return static_cast<std::uint32_t>(i | j << 8 | k << 16 | axis << 24);
  }
};

/// Interpolates `count` crossings of `iso`.
/// t = (iso - a) / (b - a), kept off the ends and rounded to 2⁻²⁰ cells: positions are exact in
/// float wherever the edge lies in its block, so a shape moved by whole cells keeps its vertices.
void finishVertices(CrossingEdges& edges, int count, float iso);

/// A direction of any length as vertices have it.
std::array<std::int16_t, 2> packedNormal(float x, float y, float z);

}  // namespace bozzetto
