// One cloth's rays in tiles of 8 × 8, each with the two ends between which its first corner inside
// lies (Dewaele & Cani 2003, §4.3).
//
// Depth grows along the ray: it is the coordinate on the axis or, when rays come from above, −1
// less the coordinate: so blocks stay blocks. u and v are the two other axes, (u, v, axis)
// right-handed.
#pragma once
#include <array>
#include <limits>
#include <map>

#include "bozzetto/field/sampler.hpp"
#include "bozzetto/surface/height_field.hpp"

namespace bozzetto {

/// Cells that extra rays look on behind the farthest whole ray round them, and that walls reach
/// along the rays.
inline constexpr std::int32_t kBeyond = 8, kWall = 24;

inline constexpr std::int32_t kNoDepth = std::numeric_limits<std::int32_t>::max();

struct RayFrame {
  Facing facing;

  Axis axis() const { return facing.axis; }
  Axis u() const { return next(facing.axis); }
  Axis v() const { return next(next(facing.axis)); }
  bool fromAbove() const { return facing.from == Facing::From::above; }
  /// A coordinate on the axis to a depth, or a block's to its depth in blocks; and back.
  std::int32_t turned(std::int32_t at) const { return fromAbove() ? -1 - at : at; }
  Key key(std::int32_t atU, std::int32_t atV, std::int32_t depth) const;
};

/// First and last block along the axis, as depth orders them.
struct BlockSpan {
  std::int32_t first, last;
};

struct RayTile {
  static constexpr int kSide = 8, kRays = kSide * kSide;

  std::array<std::int32_t, kRays> near, far;  // kNoDepth: no clay on this ray
  std::array<float, kRays> back{};            // how far before `near` the surface lies, cells
  std::array<PatchVertex, kRays> vertex{};
  std::vector<BlockSpan> clay;             // blocks with corners inside, turned, ascending
  std::uint64_t unsettled = 0, moved = 0;  // rays to cast, vertices to make
  bool stale = false;                      // its triangles are
  bool shown = false;
  bool jumps = false;     // depth does, somewhere: extra rays and walls reach deeper
  std::int32_t base = 0;  // depth from which its piece counts, once shown

  RayTile() {
    near.fill(kNoDepth);
    far.fill(kNoDepth);
  }
  bool hits(int ray) const { return near[std::size_t(ray)] != kNoDepth; }
  double depth(int ray) const { return double(near[std::size_t(ray)]) - back[std::size_t(ray)]; }
  /// Rays that wait or whose surface lies no nearer than this.
  bool reaches(std::int32_t depth) const;
};

/// Along u, then along v.
struct TilePlace {
  std::int32_t u, v;
  friend auto operator<=>(const TilePlace&, const TilePlace&) = default;
};

class RaySheet {
 public:
  explicit RaySheet(Facing facing) : frame_{facing} {}

  const RayFrame& frame() const { return frame_; }
  const std::map<TilePlace, RayTile>& tiles() const { return tiles_; }
  std::map<TilePlace, RayTile>& tiles() { return tiles_; }

  /// `length` blocks from `block` upwards along z are now this one (null: nothing).
  void change(Key block, std::int32_t length, const CornerBlock<8>* now, float iso);
  /// Casts what waits; the number of rays cast.
  std::int64_t settle(const Clay& field);

 private:
  void changeSpan(TilePlace place, BlockSpan span, const CornerBlock<8>* now, float iso);
  void narrow(RayTile& tile, const BlockSpan& span, const CornerBlock<8>* now, float iso);
  void touchAround(TilePlace place, const BlockSpan& span);
  static std::int64_t cast(const Clay& field, const RayFrame& frame, TilePlace place,
                           RayTile& tile);

  RayFrame frame_;
  std::map<TilePlace, RayTile> tiles_;
};

}  // namespace bozzetto
