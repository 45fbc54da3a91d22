// Cloths thrown over the clay (Dewaele & Cani 2003, §4.2) as the renderer takes them: which ones an
// eye needs, and light that follows behind.
#pragma once
#include <array>
#include <map>

#include "bozzetto/render/camera.hpp"
#include "bozzetto/render/occlusion.hpp"
#include "bozzetto/render/unpack.hpp"
#include "bozzetto/surface/height_field.hpp"

namespace bozzetto {

/// From where cloths show all that can be seen of clay within `bounds`: one to five sides.
std::vector<Facing> facingsFor(const Camera& camera, const CellBounds& bounds);

/// All six, for any camera.
std::vector<Facing> allFacings();

/// Cloths as patches of Fineness::heights in good light that looks `reach` cells far.
std::vector<UnpackedPatch> clothPatches(const Clay& clay, std::vector<Facing> facings,
                                        const OcclusionVolume& volume, double reach);

/// The surface's stand-in while much of the clay moves. Patches are of Fineness::heights.
class HeightView {
 public:
  HeightView(std::vector<Facing> facings, double reach)
      : field_(std::move(facings)), reach_(reach) {}

  /// All of it.
  std::vector<UnpackedPatch> rebuild(const Clay& clay, const OcclusionVolume& volume);
  /// What changed. A vertex keeps the light of its ray until the surface has moved by two cells.
  std::vector<UnpackedPatch> refresh(const Clay& clay, const OcclusionVolume& volume,
                                     std::span<const KeyRun> changed);

  const std::vector<Facing>& facings() const { return field_.facings(); }
  /// Of the last call.
  const HeightReport& report() const { return report_; }

 private:
  static constexpr int kRays = 9;
  struct Lit {
    glm::vec3 position{0};
    VertexLight light;
    bool known = false;
  };
  using LitRays = std::array<Lit, kRays * kRays>;

  std::vector<UnpackedPatch> dress(const OcclusionVolume& volume);

  HeightField field_;
  double reach_;
  HeightReport report_;
  std::map<Key, LitRays> lit_;
};

/// When cloths stand in for the mesh: when bringing the mesh to the screen took too long two times
/// running. When it comes back: when what changes would have taken little four times running, by
/// what a block took.
class HeightSwitch {
 public:
  /// Milliseconds.
  explicit HeightSwitch(double tooLong = 50, double little = 20)
      : tooLong_(tooLong), little_(little) {}

  /// The mesh followed the change of so many blocks in so long.
  void meshed(std::size_t blocks, double milliseconds);
  /// Cloths did.
  void draped(std::size_t blocks);
  bool wantsCloths() const { return wantsCloths_; }
  void reset() { *this = HeightSwitch(tooLong_, little_); }

 private:
  double tooLong_, little_, perBlock_ = 0;
  int slow_ = 0, quick_ = 0;
  bool wantsCloths_ = false;
};

}  // namespace bozzetto
