#include "surface/mesher.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

#include "surface/case_tables.hpp"
#include "surface/inside_rows.hpp"

namespace bozzetto {
namespace {

template <class Callback>
BOZZETTO_KERNEL void forBits(std::uint32_t bits, Callback&& callback) {
  for (; bits != 0; bits &= bits - 1) callback(std::countr_zero(bits));
}

// Everything about a block's corners, edges and cases that can be looked up.
template <int Side>
struct Tables {
  using Edges = PatchEdges<Side>;
  static constexpr int kNodes = Side + 1;

  // Which of the eight blocks holds a corner, and where: block · Side³ + index.
  std::array<std::uint16_t, kNodes * kNodes * kNodes> place{};
  // The triangle table in edge ids, relative to the x edge of the cube's first corner; entries
  // beyond the count are 0 and may be read.
  std::array<std::array<std::uint16_t, 16>, 256> caseIds{};
  std::array<std::uint8_t, 256> caseCount{};
  // Of the bits of a row: axis and k.
  std::array<std::uint8_t, 3 * kNodes> axis{}, k{};

  constexpr Tables() {
    constexpr int count = Side * Side * Side;
    for (int n = 0; n < kNodes * kNodes * kNodes; ++n) {
      const Key corner{n / kNodes / kNodes, n / kNodes % kNodes, n % kNodes};
      const int block = corner.i / Side << 2 | corner.j / Side << 1 | corner.k / Side;
      place[n] = static_cast<std::uint16_t>(block * count + BlockGeometry<Side>::indexOf(corner));
    }
    for (int bit = 0; bit < 3 * kNodes; ++bit) {
      axis[bit] = static_cast<std::uint8_t>(bit / kNodes);
      k[bit] = static_cast<std::uint8_t>(bit % kNodes);
    }
  }

  void addCases() {
    for (int mask = 0; mask < 256; ++mask) {
      caseCount[mask] = kCaseTable[mask].indexCount;
      for (int n = 0; n < kCaseTable[mask].indexCount; ++n) {
        const CubeEdge edge = kCubeEdges[kCaseTable[mask].edges[n]];
        const Key corner{edge.corner >> 2, edge.corner >> 1 & 1, edge.corner & 1};
        caseIds[mask][n] = static_cast<std::uint16_t>(Edges::idOf(corner, edge.axis));
      }
    }
  }
};

template <int Side>
const Tables<Side> kTables = [] {
  Tables<Side> tables;
  tables.addCases();
  return tables;
}();

}  // namespace

template <int Side>
bool Mesher<Side>::mesh(const Window& window, float iso) {
  if (!findInside(window, iso)) return false;
  findCrossings();
  noteWantedRows();
  gatherDensity(window);
  gatherEdges(window);
  finishVertices(edges_, edgeCount_, iso);
  emitVertices();
  emitCubes();
  const auto vertices = static_cast<std::size_t>(edgeCount_);
  content_.vertices = {vertices_.data(), vertices};
  content_.edges = {ids_.data(), vertices};
  content_.cubes = {cubes_.data(), static_cast<std::size_t>(cubeCount_)};
  content_.indices = {indices_.data(), static_cast<std::size_t>(indexCount_)};
  return true;
}

// Returns whether corners differ. Blocks that lie on one side as a whole are not read.
template <int Side>
bool Mesher<Side>::findInside(const Window& window, float iso) {
  RowBits any = 0, all = kAllK;
  for (int column = 0; column < 4; ++column) {
    const int bi = column >> 1, bj = column & 1;
    const auto& own = window.at(bi, bj, 0);
    const auto& after = window.at(bi, bj, 1);
    const BlockSide ownSide = sideOf(own, iso), afterSide = sideOf(after, iso);
    const RowBits whole = (ownSide == BlockSide::inside ? kOwnedK : 0) |
                          (afterSide == BlockSide::inside ? 1u << Side : 0);
    for (int li = 0; li < (bi == 0 ? Side : 1); ++li)
      for (int lj = 0; lj < (bj == 0 ? Side : 1); ++lj) {
        const int at = BlockGeometry<Side>::indexOf(li, lj, 0);
        RowBits bits = whole;
        if (ownSide == BlockSide::mixed) bits |= insideBits<Side>(&own.value[at], iso);
        if (afterSide == BlockSide::mixed) bits |= (after.value[at] >= iso ? 1u : 0u) << Side;
        inside_[(bi * Side + li) * kNodes + bj * Side + lj] = bits;
        any |= bits;
        all &= bits;
      }
  }
  return any != 0 && all != kAllK;
}

// Compares neighbouring rows. Rows past the last one on an axis hold what is masked out.
template <int Side>
void Mesher<Side>::findCrossings() {
  for (int row = 0; row < kRows; ++row) {
    const RowBits own = inside_[row];
    const RowBits x = own ^ inside_[row + kNodes], y = own ^ inside_[row + 1];
    const RowBits z = (own ^ own >> 1) & kOwnedK;
    crossings_[row] = x | y << kNodes | z << 2 * kNodes;
  }
  for (int row = kRows - kNodes; row < kRows; ++row) crossings_[row] &= ~kAllK;
  for (int row = Side; row < kRows; row += kNodes) crossings_[row] &= ~(kAllK << kNodes);
}

// Both ends of a crossing edge need their neighbours.
template <int Side>
void Mesher<Side>::noteWantedRows() {
  constexpr RowBits kX = kAllK, kY = kAllK << kNodes;
  std::array<std::uint32_t, kNodes + 1> ends{};
  for (int i = 0, row = 0; i < kNodes; ++i) {
    std::uint32_t some = 0, x = 0, y = 0;
    for (int j = 0; j < kNodes; ++j, ++row) {
      const RowBits bits = crossings_[row];
      some |= (bits != 0 ? 1u : 0u) << j;
      x |= ((bits & kX) != 0 ? 1u : 0u) << j;
      y |= ((bits & kY) != 0 ? 1u : 0u) << j;
    }
    crossingRows_[i] = some;
    ends[i] |= some | y << 1;
    ends[i + 1] |= x;
  }
  wantedRows_.fill(0);
  for (int i = 0; i < kNodes; ++i) {
    wantedRows_[i] |= ends[i] << 1;
    wantedRows_[i + 1] |= ends[i] | ends[i] << 1 | ends[i] << 2;
    wantedRows_[i + 2] |= ends[i] << 1;
  }
}

template <int Side>
void Mesher<Side>::gatherDensity(const Window& window) {
  constexpr int shift = BlockGeometry<Side>::shift(), span = Window::kSpan;
  for (int i = -1; i <= kNodes; ++i) {
    forBits(wantedRows_[i + 1], [&](int bit) {
      const int j = bit - 1;
      float* const to = &density_[((i + 1) * kReach + bit) * kRow];
      const auto* const blocks =
          &window.blocks[((i >> shift) + 1) * span * span + ((j >> shift) + 1) * span];
      const int at = BlockGeometry<Side>::indexOf(i & (Side - 1), j & (Side - 1), 0);
      to[0] = blocks[0]->value[at + Side - 1];
      std::memcpy(to + 1, &blocks[1]->value[at], Side * sizeof(float));
      to[Side + 1] = blocks[2]->value[at];
      to[Side + 2] = blocks[span - 1]->value[at + (Side > 1 ? 1 : 0)];
    });
  }
}

// Owned edges first, then those on the + faces, each group ascending by id.
template <int Side>
void Mesher<Side>::gatherEdges(const Window& window) {
  for (int n = 0; n < 8; ++n)
    attributes_[n] = window.at(n >> 2, n >> 1 & 1, n & 1).attributes.data();
  edgeCount_ = 0;
  constexpr RowBits kOwnedRow = allAxes(kOwnedK);
  for (int i = 0; i < Side; ++i)
    forBits(crossingRows_[i] & kOwnedK,
            [&](int j) { gatherRow(i, j, crossings_[i * kNodes + j] & kOwnedRow); });
  content_.owned = static_cast<std::size_t>(edgeCount_);
  for (int i = 0; i < kNodes; ++i)
    forBits(crossingRows_[i], [&](int j) {
      const bool owned = i < Side && j < Side;
      gatherRow(i, j, crossings_[i * kNodes + j] & (owned ? ~kOwnedRow : ~RowBits{0}));
    });
}

template <int Side>
BOZZETTO_KERNEL void Mesher<Side>::gatherRow(int i, int j, RowBits bits) {
  constexpr std::array<int, 3> kStride = {kReach * kRow, kRow, 1};
  constexpr std::array<int, 3> kCorner = {kNodes * kNodes, kNodes, 1};
  constexpr int count = Side * Side * Side;
  const Tables<Side>& tables = kTables<Side>;
  const int row = i * kNodes + j;
  const float* const density = &density_[((i + 1) * kReach + j + 1) * kRow + 1];
  const auto colourAt = [&](int corner) {
    const int place = tables.place[corner];
    return attributes_[place / count][place % count];
  };
  int n = edgeCount_;
  forBits(bits, [&](int bit) {
    const int axis = tables.axis[bit], k = tables.k[bit], id = row * 3 * kNodes + bit;
    ids_[n] = static_cast<std::uint16_t>(id);
    vertexOfEdge_[id] = static_cast<std::uint16_t>(n);
    const float* const a = density + k;
    const float* const b = a + kStride[axis];
    edges_.valueA[n] = *a;
    edges_.valueB[n] = *b;
    for (int d = 0; d < 3; ++d) {
      edges_.belowA[d][n] = a[-kStride[d]];
      edges_.aboveA[d][n] = a[kStride[d]];
      edges_.belowB[d][n] = b[-kStride[d]];
      edges_.aboveB[d][n] = b[kStride[d]];
    }
    edges_.place[n] = CrossingEdges::placeOf(i, j, k, axis);
    edges_.coloursA[n] = colourAt(row * kNodes + k);
    edges_.coloursB[n] = colourAt(row * kNodes + k + kCorner[axis]);
    ++n;
  });
  edgeCount_ = n;
}

template <int Side>
void Mesher<Side>::emitVertices() {
  for (int n = 0; n < edgeCount_; ++n) {
    PatchVertex& vertex = vertices_[n];
    vertex.position = {edges_.position[0][n], edges_.position[1][n], edges_.position[2][n]};
    vertex.normal = std::bit_cast<std::array<std::int16_t, 2>>(edges_.normal[n]);
    vertex.colour = std::bit_cast<std::array<std::uint8_t, 4>>(edges_.colour[n]);
  }
}

template <int Side>
void Mesher<Side>::emitCubes() {
  cubeCount_ = indexCount_ = 0;
  for (int i = 0; i < Side; ++i) {
    for (int j = 0; j < Side; ++j) {
      const int row = i * kNodes + j;
      const RowBits m0 = inside_[row], m1 = inside_[row + 1];
      const RowBits m2 = inside_[row + kNodes], m3 = inside_[row + kNodes + 1];
      const RowBits some = m0 | m1 | m2 | m3, every = m0 & m1 & m2 & m3;
      const RowBits crossing = (some | some >> 1) & ~(every & every >> 1) & kOwnedK;
      forBits(crossing, [&](int k) {
        emitCube(i, j, k,
                 (m0 >> k & 3) | (m1 >> k & 3) << 2 | (m2 >> k & 3) << 4 | (m3 >> k & 3) << 6);
      });
    }
  }
}

template <int Side>
BOZZETTO_KERNEL void Mesher<Side>::emitCube(int i, int j, int k, std::uint32_t mask) {
  const Tables<Side>& tables = kTables<Side>;
  cubes_[cubeCount_++] = {static_cast<std::uint16_t>((i * Side + j) * Side + k),
                          static_cast<std::uint16_t>(mask)};
  const std::uint16_t* const vertexOfEdge = &vertexOfEdge_[Edges::idOf({i, j, k}, Axis::x)];
  const auto& ids = tables.caseIds[mask];
  std::uint16_t* const out = &indices_[indexCount_];
  const int count = tables.caseCount[mask];
  // Most cubes have one or two triangles: two are written without asking.
  for (int n = 0; n < 6; ++n) out[n] = vertexOfEdge[ids[n]];
  for (int n = 6; n < count; ++n) out[n] = vertexOfEdge[ids[n]];
  indexCount_ += count;
}

template class Mesher<1>;
template class Mesher<8>;

}  // namespace bozzetto
