// From rays to triangles, with extra rays where depth jumps (Dewaele & Cani 2003, §4.2).
#pragma once
#include "surface/height_line.hpp"

namespace bozzetto {

/// A point of a cloth; none where there is no clay.
struct HeightPoint {
  PatchVertex vertex{};
  double depth = 0;
  std::int32_t near = kNoDepth;  ///< first corner inside

  bool hit() const { return near != kNoDepth; }
};

/// A triangle may join these.
bool joined(const HeightPoint& a, const HeightPoint& b);
/// Extra rays are wanted between these neighbours.
bool parted(const HeightPoint& a, const HeightPoint& b);

/// A piece while it is made. Places count quarters of a cell from the tile's first ray.
class PieceMaker {
 public:
  PieceMaker(const Clay& field, const RayFrame& frame, TilePlace place, std::int32_t base);

  HeightPoint point(FinePlace place, std::int32_t near, LineVertex found) const;
  /// The first clay on a ray, looked for between two depths.
  HeightPoint cast(FinePlace place, std::int32_t first, std::int32_t last);
  /// What a ray passes at a corner, inside or not.
  HeightPoint passing(FinePlace place, std::int32_t depth);
  /// Whether the corner at this depth of a ray is inside.
  bool inside(FinePlace place, std::int32_t depth);

  std::uint16_t add(const PatchVertex& vertex);
  /// Counter-clockwise in (u, v).
  void triangle(std::uint16_t a, std::uint16_t b, std::uint16_t c);

  const RayFrame& frame() const { return frame_; }
  HeightPiece piece;
  std::int64_t extraRays = 0;
  bool jumps = false;  ///< it has fine cells

 private:
  RayLine line(FinePlace place);

  FieldSampler<8> sampler_;
  float iso_;
  const RayFrame& frame_;
  TilePlace place_;
};

/// A cell of four rays between which depth jumps: 4 × 4 cells of extra rays, and walls where their
/// triangles end.
void meshFineCell(PieceMaker& maker, FinePlace place, const std::array<HeightPoint, 4>& corners);

/// Makes the vertices of a tile's `moved` rays; their number.
std::int64_t makeRayVertices(const Clay& field, const RayFrame& frame, TilePlace place,
                             RayTile& tile);

/// The triangles of one tile's rays and those right beyond them. Settled tiles only.
PieceMaker meshTile(const Clay& field, const RaySheet& sheet, TilePlace place);

}  // namespace bozzetto
