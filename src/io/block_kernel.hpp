// One block of clay from the triangles near it.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "bozzetto/mesh/winding.hpp"
#include "io/grid_mesh.hpp"
#include "io/touched_blocks.hpp"

namespace bozzetto {

/// How the inside is found. `sheets`: the surface is the triangles; corners that no triangle parts
/// are on one side. `rim`: the same, but an open edge is near: one corner may not speak for all.
/// `holes`: the ½ level of the winding number also is surface here. `level`: it alone is, and
/// smooth: every other corner is asked.
enum class BlockKind : std::uint8_t { sheets, rim, holes, level };

/// A block to compute. `block` is relative to the grid mesh's first block.
struct BlockTask {
  Key block;
  BlockKind kind = BlockKind::sheets;
  std::span<const BlockTriangle> triangles;
};

/// Scratch for one thread and the steps from triangles to values.
class BlockKernel {
 public:
  static constexpr int kSide = 8;
  static constexpr int kCount = kSide * kSide * kSide;

  BlockKernel(const GridMesh& grid, const WindingTree& winding, Colour colour)
      : grid_(grid), winding_(winding), colour_(colour) {}

  /// Writes values and attributes of all corners; returns whether any has clay.
  bool fill(const BlockTask& task, CornerBlock<8>& out);

 private:
  enum class Sheets { all, surfaceOnly };
  enum Side : std::uint8_t { kOutside, kInside, kCrumb };

  void findNearest(const BlockTask& task, Sheets sheets);
  void visitTriangle(std::uint32_t number, Sheets sheets);
  bool frontLiesBeyond(int corner, const DistanceTriangle& triangle) const;
  double windingBefore(const DistanceTriangle& triangle, const NearestPoint& nearest) const;
  bool isSurface(const DistanceTriangle& triangle, const NearestPoint& nearest) const;
  void findInsideOnTriangles();
  bool findInsideByRegions(BlockKind kind);
  bool regionAgrees(BlockKind kind, double winding) const;
  void findInsideEverywhere(BlockKind kind);
  void sampleWinding(int step);
  void interpolateWinding();
  void growRegion(int start);
  bool hasInsideNeighbour(int at) const;
  bool contradictsWinding() const;
  float valueAt(int corner) const;
  Colour colourAt(int corner) const;
  glm::dvec3 placeOf(int corner) const;

  const GridMesh& grid_;
  const WindingTree& winding_;
  Colour colour_;
  glm::dvec3 origin_{0};
  std::array<double, kCount> squared_;  ///< to the nearest triangle; far = beyond the slope
  std::array<double, kCount> toHole_;   ///< cells to the ½ level of the winding number
  std::array<std::uint32_t, kCount> nearest_;
  std::array<float, kCount> u_, v_;
  std::array<std::uint8_t, kCount> inside_;  ///< Side
  std::array<std::uint8_t, kCount> seen_;
  std::vector<int> region_;
  std::vector<float> winds_;
};

}  // namespace bozzetto
