#include "surface/case_tables.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <map>
#include <set>

namespace bozzetto {
namespace {

using Segment = std::pair<int, int>;  // from edge to edge

bool inside(int mask, int corner) { return (mask >> corner & 1) != 0; }

bool crosses(int mask, int edge) {
  const int a = kCubeEdges[edge].corner;
  return inside(mask, a) != inside(mask, a + cornerBit(kCubeEdges[edge].axis));
}

// Directed sides of triangles that no other triangle of the case walks back.
std::multiset<Segment> border(const CubeCase& cube) {
  std::multiset<Segment> sides;
  for (int t = 0; t < cube.indexCount; t += 3)
    for (int n = 0; n < 3; ++n) {
      const Segment side{cube.edges[t + n], cube.edges[t + (n + 1) % 3]};
      const auto back = sides.find({side.second, side.first});
      if (back != sides.end()) {
        sides.erase(back);
      } else {
        sides.insert(side);
      }
    }
  return sides;
}

TEST(CaseTables, edgesAndFacesAreWhole) {
  std::set<Segment> ends;
  for (const CubeEdge& e : kCubeEdges) ends.insert({e.corner, e.corner + cornerBit(e.axis)});
  EXPECT_EQ(ends.size(), 12u);
  for (int face = 0; face < 6; ++face) {
    int edges = 0;
    for (int e = 0; e < 12; ++e) edges += faceHasEdge(face, e) ? 1 : 0;
    EXPECT_EQ(edges, 4);
  }
}

TEST(CaseTables, everyCrossingEdgeLiesOnOneClosedLoop) {
  for (int mask = 0; mask < 256; ++mask) {
    const LoopSuccessors next = loopSuccessors(mask);
    std::set<int> entered;
    for (int e = 0; e < 12; ++e) {
      EXPECT_EQ(next[e] >= 0, crosses(mask, e)) << mask;
      if (next[e] >= 0) {
        EXPECT_TRUE(entered.insert(next[e]).second) << mask;
      }
    }
    for (const int e : entered) EXPECT_GE(next[e], 0) << mask;
  }
}

TEST(CaseTables, trianglesFillTheLoopsAndNothingElse) {
  for (int mask = 0; mask < 256; ++mask) {
    const LoopSuccessors next = loopSuccessors(mask);
    std::multiset<Segment> loops;
    for (int e = 0; e < 12; ++e)
      if (next[e] >= 0) loops.insert({e, next[e]});
    EXPECT_EQ(border(kCaseTable[mask]), loops) << mask;
    std::size_t loopCount = 0;
    std::set<int> seen;
    for (const auto& [from, to] : loops) {
      if (seen.contains(from)) continue;
      ++loopCount;
      for (int e = from; seen.insert(e).second;) e = next[e];
    }
    // A loop of n edges takes n - 2 triangles.
    EXPECT_EQ(kCaseTable[mask].indexCount / 3, loops.size() - 2 * loopCount) << mask;
  }
}

TEST(CaseTables, noDiagonalLiesInAFace) {
  for (int mask = 0; mask < 256; ++mask) {
    const LoopSuccessors next = loopSuccessors(mask);
    const CubeCase& cube = kCaseTable[mask];
    for (int n = 0; n < cube.indexCount; ++n) {
      const int a = cube.edges[n], b = cube.edges[n % 3 == 2 ? n - 2 : n + 1];
      const bool segment = next[a] == b || next[b] == a;
      EXPECT_TRUE(segment || !edgesShareFace(a, b)) << mask << ": " << a << " " << b;
    }
  }
}

// The segments of one mask on one face, edges named by their place in the neighbour's cube.
std::set<Segment> faceSegments(int mask, Axis axis, bool upper) {
  const LoopSuccessors next = loopSuccessors(mask);
  const int face = 2 * index(axis) + (upper ? 1 : 0);
  std::set<Segment> segments;
  const auto lowered = [&](int e) {
    const CubeEdge edge = kCubeEdges[e];
    const int corner = edge.corner & ~cornerBit(axis);
    return edgeBetween(corner, corner + cornerBit(edge.axis));
  };
  for (int e = 0; e < 12; ++e)
    if (next[e] >= 0 && faceHasEdge(face, e) && faceHasEdge(face, next[e])) {
      segments.insert({lowered(e), lowered(next[e])});
    }
  return segments;
}

TEST(CaseTables, neighboursAgreeOnTheirFace) {
  for (const Axis axis : kAxes)
    for (int below = 0; below < 256; ++below)
      for (int rest = 0; rest < 16; ++rest) {
        // The upper neighbour's lower corners are this cube's upper ones; its others are free.
        int above = 0, bit = 0;
        for (int corner = 0; corner < 8; ++corner) {
          const bool shared = (corner & cornerBit(axis)) == 0;
          const bool in =
              shared ? inside(below, corner | cornerBit(axis)) : (rest >> bit++ & 1) != 0;
          above |= (in ? 1 : 0) << corner;
        }
        std::set<Segment> reversed;
        for (const auto& [from, to] : faceSegments(above, axis, false)) reversed.insert({to, from});
        ASSERT_EQ(faceSegments(below, axis, true), reversed) << below << " " << above;
      }
}

TEST(CaseTables, complementHasAsManyCrossings) {
  for (int mask = 0; mask < 256; ++mask)
    for (int e = 0; e < 12; ++e) EXPECT_EQ(crosses(mask, e), crosses(255 - mask, e));
  EXPECT_EQ(kCaseTable[0].indexCount, 0);
  EXPECT_EQ(kCaseTable[255].indexCount, 0);
  for (int corner = 0; corner < 8; ++corner) EXPECT_EQ(kCaseTable[1 << corner].indexCount, 3);
}

}  // namespace
}  // namespace bozzetto
