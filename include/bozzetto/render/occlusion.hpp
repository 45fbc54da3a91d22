// Occlusion, bent normal and cavity of vertices, read from the volume itself: no screen pass, no
// halos, the same from every side.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "bozzetto/field/field.hpp"
#include "bozzetto/field/pyramid.hpp"
#include "bozzetto/render/camera.hpp"
#include "bozzetto/render/patch.hpp"

namespace bozzetto {

/// Occupancy of space, 1 in clay, 0 in air, with a ramp of two cells between, however soft the
/// field's own slope: clay made with soft tools shades like clay made with hard ones. Its pyramid
/// is built like the field's; corner t of level l lies at t·2ˡ + (2ˡ − 1)/2 cells.
class OcclusionVolume {
 public:
  static constexpr int kLevels = 7;

  OcclusionVolume() = default;
  /// O(blocks near the surface + runs inside), in parallel.
  explicit OcclusionVolume(const Clay& clay);

  /// Brings up to date what depends on changed blocks of the clay (Delta::keys()).
  void refresh(const Clay& clay, std::span<const KeyRun> changed);

  /// Corners of `box` at a level 0 … kLevels − 1, i slowest, k fastest, 0…1.
  void read(int level, const KeyBox& box, std::span<float> texels) const;

 private:
  Clay occupied_;
  Pyramid pyramid_{kLevels - 1};
};

/// `quick` looks along four cones instead of six: in strokes, until there is time for `good`.
enum class LightDetail { quick, good };

/// Light of all vertices of `patches` (whose `light` is not read), one array per patch. Looks
/// `reach` cells far. 2–3 µs a vertex and thread; the same on any number of threads.
std::vector<std::vector<VertexLight>> lightOf(const OcclusionVolume& volume,
                                              std::span<const PatchVertices> patches, double reach,
                                              LightDetail detail = LightDetail::good);

/// How open the floor under the clay is, on a square around the stage's centre.
struct FloorOcclusion {
  static constexpr int kSide = 96;
  static constexpr double kHalfUnits = 3;  ///< half side of the square, stage units
  std::vector<std::uint8_t> texels;        ///< rows along z, then x; 255 in the open; or empty
};

FloorOcclusion floorOcclusion(const OcclusionVolume& volume, const Stage& stage,
                              const CellBounds& clay);

}  // namespace bozzetto
