// One block's corners in, one block's patch out. Works in its own scratch memory; one per thread.
#pragma once
#include <array>
#include <cstdint>

#include "bozzetto/surface/patch.hpp"
#include "surface/block_window.hpp"
#include "surface/vertex_kernel.hpp"

namespace bozzetto {

template <int Side>
class Mesher {
 public:
  using Window = BlockWindow<Side>;

  /// False when no cube of the block crosses the surface; otherwise content() is its patch until
  /// the next call. The patch depends on the window and on iso alone.
  bool mesh(const Window& window, float iso);

  const PatchContent& content() const { return content_; }

 private:
  using Edges = PatchEdges<Side>;
  static constexpr int kNodes = Side + 1;  // corners of the block's cubes along an axis
  static constexpr int kReach = Side + 3;  // and one more at both ends, for gradients
  static constexpr int kRow = 16;          // floats between rows of `density_`
  static constexpr int kRows = kNodes * kNodes;
  static constexpr int kPaddedRows = (kRows + 7) / 8 * 8 + 16;

  // Crossing edges of a row of corners: bit axis · kNodes + k. So bits ascend like edge ids.
  using RowBits = std::uint32_t;
  static constexpr RowBits kOwnedK = (1u << Side) - 1, kAllK = (1u << kNodes) - 1;
  static constexpr RowBits allAxes(RowBits k) { return k | k << kNodes | k << 2 * kNodes; }

  bool findInside(const Window& window, float iso);
  void findCrossings();
  void noteWantedRows();
  void gatherDensity(const Window& window);
  void gatherEdges(const Window& window);
  void gatherRow(int i, int j, RowBits bits);
  void emitVertices();
  void emitCubes();
  void emitCube(int i, int j, int k, std::uint32_t mask);

  alignas(64) std::array<RowBits, kPaddedRows> inside_;  // bit k: corner (i, j, k) is inside
  alignas(64) std::array<RowBits, kPaddedRows> crossings_;
  std::array<std::uint32_t, kNodes> crossingRows_;  // bit j of entry i: the row has crossings
  std::array<std::uint32_t, kReach> wantedRows_;    // bit j + 1 of entry i + 1: row is needed
  std::array<const Attributes*, 8> attributes_;     // of the blocks that hold the cubes' corners
  alignas(64) std::array<float, kReach * kReach * kRow> density_;
  CrossingEdges edges_;
  int edgeCount_ = 0, cubeCount_ = 0, indexCount_ = 0;
  std::array<std::uint16_t, Edges::kIds> vertexOfEdge_{};
  std::array<std::uint16_t, CrossingEdges::kMost> ids_;
  std::array<PatchVertex, CrossingEdges::kMost> vertices_;
  std::array<CrossingCube, Side * Side * Side> cubes_;
  std::array<std::uint16_t, 15 * Side * Side * Side + 15> indices_;
  PatchContent content_;
};

extern template class Mesher<1>;
extern template class Mesher<8>;

}  // namespace bozzetto
