// What is drawn: the piece of surface inside one block of cubes (Ferley §3.1: the block's crossing
// cubes, its edges with their vertices, its triangles), relative to the block's first corner.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "bozzetto/grid/key.hpp"
#include "bozzetto/grid/ref.hpp"

namespace bozzetto {

/// 20 bytes, ready for the graphics card.
struct PatchVertex {
  std::array<float, 3> position;       ///< cells from the block's first corner, 0…Side, exact
  std::array<std::int16_t, 2> normal;  ///< outward, octahedral: see octahedralNormal
  std::array<std::uint8_t, 4> colour;  ///< r, g, b, hold; mixed from the two corners of the edge
  friend bool operator==(const PatchVertex&, const PatchVertex&) = default;
};

/// A cube that the surface crosses. Bit n of `mask` is set when corner n is inside.
struct CrossingCube {
  std::uint16_t cube;  ///< (i · Side + j) · Side + k inside the block
  std::uint16_t mask;  ///< never 0 or 255
  friend bool operator==(const CrossingCube&, const CrossingCube&) = default;
};

/// Unit vector from 2×16 bits: (x, y) on the octahedron |x|+|y|+|z| = 1, lower half folded out.
std::array<float, 3> octahedralNormal(std::array<std::int16_t, 2> packed);

/// Edges of a block's cubes, the ones on its + faces included. Ids ascend by (i, j, axis, k).
template <int Side>
struct PatchEdges {
  static constexpr int kNodes = Side + 1;
  static constexpr int kIds = kNodes * kNodes * 3 * kNodes;

  static constexpr int idOf(Key local, Axis axis) {
    return ((local.i * kNodes + local.j) * 3 + index(axis)) * kNodes + local.k;
  }
  static constexpr Key cornerOf(int id) {
    const int row = id / kNodes / 3;
    return {row / kNodes, row % kNodes, id % kNodes};
  }
  static constexpr Axis axisOf(int id) { return kAxes[id / kNodes % 3]; }
};

/// Views into a patch or into the scratch of whoever makes one.
struct PatchContent {
  std::size_t owned = 0;  ///< the first `owned` vertices lie on edges that start in this block
  std::span<const PatchVertex> vertices;   ///< owned ones first, then copies from the + neighbours'
  std::span<const std::uint16_t> edges;    ///< edge id of each vertex; ascending in both groups
  std::span<const CrossingCube> cubes;     ///< ascending
  std::span<const std::uint16_t> indices;  ///< three a triangle, counter-clockwise from outside

  bool sameAs(const PatchContent& other) const;
};

/// One block's patch in one piece of pooled memory, reused when the block is meshed again.
/// Whoever holds a Ref to it sees it unchanged: the surface then puts a new one in its place.
class SurfacePatch : public RefCounted {
 public:
  SurfacePatch() = default;
  explicit SurfacePatch(const PatchContent& content) { assign(content); }
  ~SurfacePatch();
  SurfacePatch(const SurfacePatch&) = delete;
  SurfacePatch& operator=(const SurfacePatch&) = delete;

  void assign(const PatchContent& content);
  PatchContent content() const;

  std::size_t ownedCount() const { return owned_; }
  std::size_t vertexCount() const { return vertices_; }
  std::size_t cubeCount() const { return cubes_; }
  std::size_t triangleCount() const { return indices_ / 3; }
  std::size_t bytes() const { return sizeof *this + capacity_; }

 private:
  std::byte* memory_ = nullptr;
  std::uint32_t capacity_ = 0;
  std::uint16_t owned_ = 0, vertices_ = 0, cubes_ = 0, indices_ = 0;
};

}  // namespace bozzetto
