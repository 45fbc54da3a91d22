#include "surface/case_tables.hpp"

namespace bozzetto {
namespace {

struct Crossing {
  int edge;
  bool entersClay;
};

// Joins, on one face, the edge where the walk round it enters the clay with the next one where it
// leaves: each inside corner, or pair of neighbours, is cut off by a segment of its own.
constexpr void joinOnFace(int mask, const std::array<std::uint8_t, 4>& face, LoopSuccessors& next) {
  std::array<Crossing, 4> crossings{};
  int count = 0;
  for (int n = 0; n < 4; ++n) {
    const int a = face[n], b = face[(n + 1) % 4];
    const bool insideA = (mask >> a & 1) != 0, insideB = (mask >> b & 1) != 0;
    if (insideA != insideB) crossings[count++] = {edgeBetween(a, b), insideB};
  }
  for (int n = 0; n < count; ++n) {
    if (!crossings[n].entersClay) continue;
    const int leaves = crossings[(n + 1) % count].edge;
    next[crossings[n].edge] = static_cast<std::int8_t>(leaves);
  }
}

constexpr LoopSuccessors successorsOf(int mask) {
  LoopSuccessors next{};
  for (auto& edge : next) edge = -1;
  for (const auto& face : kCubeFaces) joinOnFace(mask, face, next);
  return next;
}

struct Loop {
  std::array<int, 12> edges{};
  int size = 0;
};

// Squared distance of two edges' midpoints, in quarter cells.
constexpr int distance2(int a, int b) {
  int sum = 0;
  for (const Axis axis : kAxes) {
    const auto doubled = [axis](int e) {
      const CubeEdge edge = kCubeEdges[e];
      return edge.axis == axis ? 1 : 2 * ((edge.corner & cornerBit(axis)) != 0 ? 1 : 0);
    };
    const int d = doubled(a) - doubled(b);
    sum += d * d;
  }
  return sum;
}

// Cuts loops by dynamic programming: least sum of squared diagonals, none in a face.
class LoopCutter {
 public:
  constexpr explicit LoopCutter(const Loop& loop) : loop_(loop) {
    for (int width = 2; width < loop.size; ++width)
      for (int i = 0; i + width < loop.size; ++i) choose(i, i + width);
  }

  constexpr void emit(CubeCase& out, int i, int j) const {
    if (j - i < 2) return;
    const int k = apex_[i][j];
    for (const int n : {i, k, j}) {
      out.edges[out.indexCount++] = static_cast<std::uint8_t>(loop_.edges[n]);
    }
    emit(out, i, k);
    emit(out, k, j);
  }

 private:
  static constexpr int kForbidden = 1 << 20;

  constexpr int diagonalCost(int i, int j) const {
    const bool side = j - i == 1 || (i == 0 && j == loop_.size - 1);
    if (side) return 0;
    const int a = loop_.edges[i], b = loop_.edges[j];
    return edgesShareFace(a, b) ? kForbidden : distance2(a, b);
  }

  constexpr void choose(int i, int j) {
    int best = -1;
    for (int k = i + 1; k < j; ++k) {
      const int cost = cost_[i][k] + cost_[k][j];
      if (best >= 0 && cost >= best) continue;
      best = cost;
      apex_[i][j] = k;
    }
    cost_[i][j] = best + diagonalCost(i, j);
  }

  const Loop loop_;
  std::array<std::array<int, 12>, 12> cost_{}, apex_{};
};

constexpr CubeCase caseOf(int mask) {
  CubeCase result;
  LoopSuccessors next = successorsOf(mask);
  for (int start = 0; start < 12; ++start) {
    Loop loop;
    for (int edge = start; next[edge] >= 0;) {
      loop.edges[loop.size++] = edge;
      const int following = next[edge];
      next[edge] = -1;
      edge = following;
    }
    if (loop.size >= 3) LoopCutter(loop).emit(result, 0, loop.size - 1);
  }
  return result;
}

constexpr CaseTable allCases() {
  CaseTable table{};
  for (int mask = 0; mask < 256; ++mask) table[mask] = caseOf(mask);
  return table;
}

}  // namespace

LoopSuccessors loopSuccessors(int mask) { return successorsOf(mask); }

constexpr CaseTable kDerived = allCases();
const CaseTable kCaseTable = kDerived;

}  // namespace bozzetto
