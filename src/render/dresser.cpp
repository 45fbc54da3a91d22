#include "bozzetto/render/dresser.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "render/coarse_clay.hpp"

namespace bozzetto {
namespace {

// Occlusion looks this far, cells: beyond, things no longer darken each other while one works.
constexpr double kReach = 160;
// Blocks around a changed one whose light is worth doing again.
constexpr int kNear = 3;

using Geometry = Clay::Geometry;

UnpackedPatch finePatch(const Surface<8>& surface, Key block) {
  const Key origin = Geometry::firstCornerOf(block);
  const SurfacePatch* found = surface.patches().find(block);
  return found == nullptr ? UnpackedPatch(origin) : UnpackedPatch(origin, *found);
}

void light(const OcclusionVolume& volume, std::vector<UnpackedPatch>& patches, LightDetail detail) {
  std::vector<PatchVertices> views;
  views.reserve(patches.size());
  for (const UnpackedPatch& patch : patches) views.push_back(patch.view());
  auto lights = lightOf(volume, views, kReach, detail);
  for (std::size_t n = 0; n < patches.size(); ++n) patches[n].light = std::move(lights[n]);
}

}  // namespace

struct Dresser::Impl {
  OcclusionVolume volume;
  CoarseClay coarse;
  std::set<Key> waiting;  // blocks in quick light
  std::set<Key> soon;     // these and their neighbours: to be done in good light
  std::optional<HeightView> heights;
  std::vector<KeyRun> late;  // changed under cloths: the coarse clay does not have it yet

  void widen(const Surface<8>& surface);
};

// Clay that came or went also changes the light of what stands near.
void Dresser::Impl::widen(const Surface<8>& surface) {
  constexpr int row = 2 * kNear + 1;
  for (const Key block : waiting) {
    for (int n = 0; n < row * row * row; ++n) {
      const Key near = block + Key{n / row / row - kNear, n / row % row - kNear, n % row - kNear};
      if (surface.patches().find(near) != nullptr) soon.insert(near);
    }
  }
  waiting.clear();
}

Dresser::Dresser() : impl_(std::make_unique<Impl>()) {}
Dresser::~Dresser() = default;

std::vector<UnpackedPatch> Dresser::rebuild(const Clay& clay, const Surface<8>& surface) {
  impl_->volume = OcclusionVolume(clay);
  impl_->waiting.clear();
  impl_->soon.clear();
  impl_->heights.reset();
  impl_->late.clear();
  std::vector<UnpackedPatch> patches;
  for (const auto& [block, run] : surface.patches()) patches.push_back(finePatch(surface, block));
  for (const Key block : impl_->coarse.rebuild(clay)) patches.push_back(impl_->coarse.patch(block));
  light(impl_->volume, patches, LightDetail::good);
  return patches;
}

std::vector<UnpackedPatch> Dresser::refresh(const Clay& clay, const Surface<8>& surface,
                                            std::span<const KeyRun> changedBlocks,
                                            std::span<const Key> changedPatches) {
  impl_->heights.reset();
  std::vector<KeyRun> late = std::exchange(impl_->late, {});
  if (!late.empty()) {
    late.insert(late.end(), changedBlocks.begin(), changedBlocks.end());
    late = withoutOverlaps(std::move(late));
    changedBlocks = late;
  }
  impl_->volume.refresh(clay, changedBlocks);
  std::vector<UnpackedPatch> patches;
  for (const Key block : changedPatches) {
    patches.push_back(finePatch(surface, block));
    impl_->waiting.insert(block);
  }
  for (const Key block : impl_->coarse.refresh(clay, changedBlocks)) {
    patches.push_back(impl_->coarse.patch(block));
  }
  light(impl_->volume, patches, LightDetail::quick);
  return patches;
}

std::vector<UnpackedPatch> Dresser::drape(const Clay& clay, std::vector<Facing> facings) {
  return impl_->heights.emplace(std::move(facings), kReach).rebuild(clay, impl_->volume);
}

std::vector<UnpackedPatch> Dresser::redrape(const Clay& clay,
                                            std::span<const KeyRun> changedBlocks) {
  Impl& d = *impl_;
  d.late.insert(d.late.end(), changedBlocks.begin(), changedBlocks.end());
  d.late = withoutOverlaps(std::move(d.late));
  d.volume.refresh(clay, changedBlocks);  // light in clay that has gone would be dark
  return d.heights->refresh(clay, d.volume, changedBlocks);
}

const HeightView* Dresser::drapery() const {
  return impl_->heights ? &*impl_->heights : nullptr;
}

std::vector<UnpackedPatch> Dresser::settle(const Surface<8>& surface, std::size_t most) {
  impl_->widen(surface);
  std::vector<UnpackedPatch> patches;
  auto& soon = impl_->soon;
  while (!soon.empty() && patches.size() < most) {
    UnpackedPatch patch = finePatch(surface, *soon.begin());
    soon.erase(soon.begin());
    if (!patch.indices.empty()) patches.push_back(std::move(patch));
  }
  light(impl_->volume, patches, LightDetail::good);
  return patches;
}

CellBounds Dresser::bounds(const Surface<8>& surface) const {
  CellBounds bounds;
  for (const auto& [block, run] : surface.patches()) {
    const Key corner = Geometry::firstCornerOf(block);
    const glm::dvec3 low(corner.i, corner.j, corner.k);
    for (const PatchVertex& vertex : run.block->content().vertices) {
      const glm::dvec3 p =
          low + glm::dvec3(vertex.position[0], vertex.position[1], vertex.position[2]);
      bounds.add({p, p});
    }
  }
  return bounds;
}

FloorOcclusion Dresser::floor(const Stage& stage, const CellBounds& clay) const {
  return floorOcclusion(impl_->volume, stage, clay);
}

}  // namespace bozzetto
