// Makes clay ready to be drawn, on whatever thread works on the clay: light for new vertices, and
// the half-resolution copy that stands in while the camera moves. No OpenGL.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "bozzetto/render/height_view.hpp"
#include "bozzetto/render/occlusion.hpp"
#include "bozzetto/render/unpack.hpp"
#include "bozzetto/surface/surface.hpp"

namespace bozzetto {

/// Patches come out with their light; those without triangles are gone. All are to be given to the
/// renderer, in any order. One thread at a time.
class Dresser {
 public:
  Dresser();
  ~Dresser();
  Dresser(const Dresser&) = delete;
  Dresser& operator=(const Dresser&) = delete;

  /// All patches, fine and coarse, in good light. O(blocks near the surface).
  std::vector<UnpackedPatch> rebuild(const Clay& clay, const Surface<8>& surface);

  /// What changed: blocks of the field (Delta::keys()) and patches (RefreshReport::changed), in
  /// quick light. O(changed).
  std::vector<UnpackedPatch> refresh(const Clay& clay, const Surface<8>& surface,
                                     std::span<const KeyRun> changedBlocks,
                                     std::span<const Key> changedPatches);

  /// While much of the clay moves: cloths from these sides in place of all patches, until the next
  /// refresh or rebuild. O(blocks + rays).
  std::vector<UnpackedPatch> drape(const Clay& clay, std::vector<Facing> facings);
  /// What changed of them: blocks of the field. Light lags behind. O(changed).
  std::vector<UnpackedPatch> redrape(const Clay& clay, std::span<const KeyRun> changedBlocks);
  /// The cloths there are; null when there are none.
  const HeightView* drapery() const;

  /// At rest: good light for what was refreshed and for what stands near it, at most `most` patches
  /// a call; empty when all is done.
  std::vector<UnpackedPatch> settle(const Surface<8>& surface, std::size_t most = 256);

  /// Of the vertices of all patches, cells.
  CellBounds bounds(const Surface<8>& surface) const;
  FloorOcclusion floor(const Stage& stage, const CellBounds& clay) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace bozzetto
