// What a cube's surface looks like for each of the 256 masks of inside corners, derived at compile
// time from one rule for faces (Lorensen & Cline 1987; ambiguities after Dürst 1988).
//
// On every face the crossing edges are joined so that inside corners are cut off one by one: where
// two diagonal corners are inside they stay apart. The rule looks at the face only, so both cubes
// that share it agree, and the mesh is closed. The segments of the six faces form loops; a loop is
// cut into triangles along diagonals that lie in no face, since the neighbour could use the same
// diagonal and four triangles would meet there. Corners are numbered as in grid/key.hpp.
#pragma once
#include <array>
#include <cstdint>

#include "bozzetto/base/axis.hpp"

namespace bozzetto {

struct CubeEdge {
  std::uint8_t corner;  ///< the smaller one
  Axis axis;
};

/// How far a corner's number grows along an axis.
constexpr int cornerBit(Axis axis) { return 4 >> index(axis); }

/// Edges ordered by (corner, axis).
inline constexpr std::array<CubeEdge, 12> kCubeEdges = [] {
  std::array<CubeEdge, 12> edges{};
  int count = 0;
  for (std::uint8_t corner = 0; corner < 8; ++corner)
    for (const Axis axis : kAxes)
      if ((corner & cornerBit(axis)) == 0) edges[count++] = {corner, axis};
  return edges;
}();

constexpr int edgeBetween(int cornerA, int cornerB) {
  const int smaller = cornerA < cornerB ? cornerA : cornerB;
  const int bit = cornerA ^ cornerB;
  for (int e = 0; e < 12; ++e)
    if (kCubeEdges[e].corner == smaller && cornerBit(kCubeEdges[e].axis) == bit) return e;
  return -1;
}

/// The corners of the six faces, counter-clockwise seen from outside.
inline constexpr std::array<std::array<std::uint8_t, 4>, 6> kCubeFaces = [] {
  std::array<std::array<std::uint8_t, 4>, 6> faces{};
  for (const Axis axis : kAxes) {
    const int u = cornerBit(next(axis)), v = cornerBit(next(next(axis)));
    for (int side = 0; side < 2; ++side) {
      const int first = side * cornerBit(axis);
      const int second = first + (side == 1 ? u : v), fourth = first + (side == 1 ? v : u);
      faces[2 * index(axis) + side] = {
          static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(second),
          static_cast<std::uint8_t>(first + u + v), static_cast<std::uint8_t>(fourth)};
    }
  }
  return faces;
}();

constexpr bool faceHasEdge(int face, int edge) {
  const int a = kCubeEdges[edge].corner, b = a + cornerBit(kCubeEdges[edge].axis);
  int found = 0;
  for (const int corner : kCubeFaces[face]) found += corner == a || corner == b ? 1 : 0;
  return found == 2;
}

constexpr bool edgesShareFace(int a, int b) {
  for (int face = 0; face < 6; ++face)
    if (faceHasEdge(face, a) && faceHasEdge(face, b)) return true;
  return false;
}

/// For each crossing edge of a mask the edge that follows it on its loop, -1 for the others.
/// Loops run counter-clockwise seen from outside the clay.
using LoopSuccessors = std::array<int, 12>;
LoopSuccessors loopSuccessors(int mask);

struct CubeCase {
  std::uint8_t indexCount = 0;           ///< 3 × triangles, at most 15
  std::array<std::uint8_t, 15> edges{};  ///< of the triangles' vertices
};

using CaseTable = std::array<CubeCase, 256>;
extern const CaseTable kCaseTable;

}  // namespace bozzetto
