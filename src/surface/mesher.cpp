#include "surface/mesher.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "bozzetto/base/simd.hpp"
#include "surface/case_tables.hpp"

namespace bozzetto {
namespace {

// Bit n: value n is inside.
template <int Side>
BOZZETTO_KERNEL std::uint32_t insideBits(const float* value, float iso) {
#if defined(__SSE2__)
  if constexpr (Side == 8) {
    const __m128 threshold = _mm_set1_ps(iso);
    const int low = _mm_movemask_ps(_mm_cmpge_ps(_mm_load_ps(value), threshold));
    const int high = _mm_movemask_ps(_mm_cmpge_ps(_mm_load_ps(value + 4), threshold));
    return static_cast<std::uint32_t>(low | high << 4);
  }
#endif
  std::uint32_t bits = 0;
  for (int n = 0; n < Side; ++n) bits |= (value[n] >= iso ? 1u : 0u) << n;
  return bits;
}

template <class Callback>
BOZZETTO_KERNEL void forBits(std::uint32_t bits, Callback&& callback) {
  for (; bits != 0; bits &= bits - 1) callback(std::countr_zero(bits));
}

// The triangle table with edge ids, relative to the id of the cube's first corner along x.
template <int Side>
struct CaseIds {
  std::array<std::array<std::uint16_t, 15>, 256> id{};

  CaseIds() {
    for (int mask = 0; mask < 256; ++mask)
      for (int n = 0; n < kCaseTable[mask].indexCount; ++n) {
        const CubeEdge edge = kCubeEdges[kCaseTable[mask].edges[n]];
        const Key corner{edge.corner >> 2, edge.corner >> 1 & 1, edge.corner & 1};
        id[mask][n] = static_cast<std::uint16_t>(PatchEdges<Side>::idOf(corner, edge.axis));
      }
  }

  static const CaseIds& get() {
    static const CaseIds ids;
    return ids;
  }
};

}  // namespace

template <int Side>
bool Mesher<Side>::mesh(const Window& window, float iso) {
  if (!findInside(window, iso)) return false;
  findCrossings();
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

template <int Side>
std::uint32_t Mesher<Side>::insideRow(const Window& window, int i, int j, float iso) const {
  const auto [block, at] = window.place(i, j, 0);
  const auto [after, first] = window.place(i, j, Side);
  return insideBits<Side>(&block->value[at], iso) | (after->value[first] >= iso ? 1u << Side : 0u);
}

// Returns whether corners differ.
template <int Side>
bool Mesher<Side>::findInside(const Window& window, float iso) {
  std::uint32_t any = 0, all = kAll;
  for (int i = 0, row = 0; i < kNodes; ++i)
    for (int j = 0; j < kNodes; ++j, ++row) {
      const std::uint32_t bits = insideRow(window, i, j, iso);
      inside_[row] = static_cast<std::uint16_t>(bits);
      any |= bits;
      all &= bits;
    }
  return any != 0 && all != kAll;
}

// Marks crossing edges by comparing neighbouring rows, and the rows their gradients need.
template <int Side>
void Mesher<Side>::findCrossings() {
  std::array<std::uint32_t, kNodes + 1> ends{};  // bit j of entry i: row has ends of crossings
  for (int i = 0, row = 0; i < kNodes; ++i)
    for (int j = 0; j < kNodes; ++j, ++row) {
      const std::uint32_t own = inside_[row];
      const std::uint32_t x = i < Side ? own ^ inside_[row + kNodes] : 0;
      const std::uint32_t y = j < Side ? own ^ inside_[row + 1] : 0;
      const std::uint32_t z = (own ^ own >> 1) & kOwned;
      crossings_[row] = {x, y, z};
      ends[i] |= ((x | y | z) != 0 ? 1u : 0u) << j | (y != 0 ? 2u : 0u) << j;
      ends[i + 1] |= (x != 0 ? 1u : 0u) << j;
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
  for (int i = -1; i <= kNodes; ++i) {
    forBits(wantedRows_[i + 1], [&](int bit) {
      const int j = bit - 1;
      float* const to = &density_[((i + 1) * kReach + bit) * kRow];
      const auto [block, at] = window.place(i, j, 0);
      std::memcpy(to + 1, &block->value[at], Side * sizeof(float));
      for (const int k : {-1, Side, Side + 1}) {
        const auto [other, index] = window.place(i, j, k);
        to[k + 1] = other->value[index];
      }
    });
  }
}

// Owned edges first, then those on the + faces, each group ascending by id.
template <int Side>
void Mesher<Side>::gatherEdges(const Window& window) {
  edgeCount_ = 0;
  for (int i = 0; i < Side; ++i)
    for (int j = 0; j < Side; ++j) gatherRow(window, i, j, kOwned);
  content_.owned = static_cast<std::size_t>(edgeCount_);
  for (int i = 0; i < kNodes; ++i)
    for (int j = 0; j < kNodes; ++j) {
      gatherRow(window, i, j, i < Side && j < Side ? kAll & ~kOwned : kAll);
    }
}

template <int Side>
struct Mesher<Side>::RowSource {
  const Window& window;
  int i, j;
};

template <int Side>
void Mesher<Side>::gatherRow(const Window& window, int i, int j, std::uint32_t allowed) {
  const RowCrossings& row = crossings_[i * kNodes + j];
  const RowSource source{window, i, j};
  for (const Axis axis : kAxes) {
    forBits(row[index(axis)] & allowed, [&](int k) { gatherEdge(source, k, axis); });
  }
}

template <int Side>
BOZZETTO_KERNEL void Mesher<Side>::gatherEdge(const RowSource& row, int k, Axis axis) {
  const int n = edgeCount_++, along = index(axis);
  const int id = Edges::idOf({row.i, row.j, k}, axis);
  ids_[n] = static_cast<std::uint16_t>(id);
  vertexOfEdge_[id] = static_cast<std::uint16_t>(n);
  const float* const a = &density_[((row.i + 1) * kReach + row.j + 1) * kRow + k + 1];
  const float* const b = a + kStride[along];
  edges_.valueA[n] = *a;
  edges_.valueB[n] = *b;
  for (int d = 0; d < 3; ++d) {
    edges_.gradientA[d][n] = a[kStride[d]] - a[-kStride[d]];
    edges_.gradientB[d][n] = b[kStride[d]] - b[-kStride[d]];
  }
  edges_.axis[n] = along;
  edges_.position[0][n] = static_cast<float>(row.i);
  edges_.position[1][n] = static_cast<float>(row.j);
  edges_.position[2][n] = static_cast<float>(k);
  const auto from = row.window.place(row.i, row.j, k);
  const auto to = row.window.place(row.i + (along == 0), row.j + (along == 1), k + (along == 2));
  edges_.coloursA[n] = from.block->attributes[from.index];
  edges_.coloursB[n] = to.block->attributes[to.index];
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
  for (int i = 0; i < Side; ++i)
    for (int j = 0; j < Side; ++j) {
      const int row = i * kNodes + j;
      const std::uint32_t m0 = inside_[row], m1 = inside_[row + 1];
      const std::uint32_t m2 = inside_[row + kNodes], m3 = inside_[row + kNodes + 1];
      const std::uint32_t some = m0 | m1 | m2 | m3, every = m0 & m1 & m2 & m3;
      const std::uint32_t crossing = (some | some >> 1) & ~(every & every >> 1) & kOwned;
      forBits(crossing, [&](int k) {
        emitCube(i, j, k,
                 (m0 >> k & 3) | (m1 >> k & 3) << 2 | (m2 >> k & 3) << 4 | (m3 >> k & 3) << 6);
      });
    }
}

template <int Side>
BOZZETTO_KERNEL void Mesher<Side>::emitCube(int i, int j, int k, std::uint32_t mask) {
  cubes_[cubeCount_++] = {static_cast<std::uint16_t>((i * Side + j) * Side + k),
                          static_cast<std::uint16_t>(mask)};
  const std::uint16_t* const vertexOfEdge = &vertexOfEdge_[Edges::idOf({i, j, k}, Axis::x)];
  const auto& ids = CaseIds<Side>::get().id[mask];
  const int count = kCaseTable[mask].indexCount;
  for (int n = 0; n < count; ++n) indices_[indexCount_++] = vertexOfEdge[ids[n]];
}

template class Mesher<1>;
template class Mesher<8>;

}  // namespace bozzetto
