// Occlusion, bent normal and cavity of vertices, read from the volume itself: no screen pass, no
// halos, the same from every side.
#pragma once
#include <array>
#include <vector>

#include "bozzetto/field/field.hpp"
#include "bozzetto/render/camera.hpp"
#include "bozzetto/render/patch.hpp"

namespace bozzetto {

/// 8³ texels of occupancy, 0…255.
struct OccupancyBrick : RefCounted {
  static constexpr int kSide = 8;
  std::array<std::uint8_t, kSide * kSide * kSide> texel{};
};

/// Occupancy (1 in clay, 0 in air, a ramp of two cells between, however soft the field's own slope)
/// in ever coarser levels: each is the one below in 2×2×2 boxes and one (1 2 1) blur per axis.
/// Texel t of level l lies at t·2ˡ + (2ˡ − 1)/2 cells. Absent bricks are air.
class OcclusionPyramid {
 public:
  using Level = KeyTree<OccupancyBrick>;
  static constexpr int kLevels = 7;

  OcclusionPyramid() = default;
  /// O(blocks near the surface + runs inside), in parallel.
  explicit OcclusionPyramid(const Clay& clay);

  const Level& level(int n) const { return levels_[std::size_t(n)]; }

  /// Texels of `box` at a level, i slowest, k fastest, 0…1.
  void read(int level, const KeyBox& box, std::span<float> texels) const;

 private:
  std::array<Level, kLevels> levels_;
};

/// Light of all vertices of `patches` (whose `light` is not read), one array per patch. Looks
/// `reach` cells far. About 3 µs a vertex and thread; the same on any number of threads.
std::vector<std::vector<VertexLight>> lightOf(const OcclusionPyramid& pyramid,
                                              std::span<const PatchVertices> patches, double reach);

/// How open the floor under the clay is, on a square around the stage's centre.
struct FloorOcclusion {
  static constexpr int kSide = 96;
  static constexpr double kHalfUnits = 3;  ///< half side of the square, stage units
  std::vector<std::uint8_t> texels;        ///< rows along z, then x; 255 in the open; or empty
};

FloorOcclusion floorOcclusion(const OcclusionPyramid& pyramid, const Stage& stage,
                              const CellBounds& clay);

}  // namespace bozzetto
