#include "bozzetto/render/picture.hpp"

#include "bozzetto/render/occlusion.hpp"
#include "bozzetto/render/offscreen.hpp"
#include "bozzetto/render/renderer.hpp"
#include "bozzetto/render/unpack.hpp"

namespace bozzetto {
namespace {

// Occlusion looks about half a model far: things beyond light each other as they darken.
constexpr double kReachUnits = 1.2;

std::vector<UnpackedPatch> unpackedAll(const Surface<8>& surface) {
  std::vector<UnpackedPatch> patches;
  patches.reserve(std::size_t(surface.totals().patches));
  for (const auto& [block, run] : surface.patches()) {
    patches.emplace_back(BlockGeometry<8>::firstCornerOf(block), *run.block);
  }
  return patches;
}

std::vector<PatchVertices> viewsOf(const std::vector<UnpackedPatch>& patches) {
  std::vector<PatchVertices> views;
  views.reserve(patches.size());
  for (const UnpackedPatch& patch : patches) views.push_back(patch.view());
  return views;
}

}  // namespace

Image renderPicture(const Surface<8>& surface, const Clay& clay, const PictureOptions& options,
                    Progress& progress) {
  Shot shot;
  shot.width = options.width;
  shot.height = options.height;
  requireSize(shot);

  progress.step("light", 0);
  const std::vector<UnpackedPatch> patches = unpackedAll(surface);
  std::vector<CellBounds> boxes;
  CellBounds bounds;
  for (const UnpackedPatch& patch : patches) {
    boxes.push_back(patch.bounds());
    bounds.add(boxes.back());
  }
  const double aspect = double(shot.width) / shot.height;
  shot.stage = Stage::around(bounds);
  shot.camera = framed(boxes, {options.viewpoint, options.projection, aspect});

  const OcclusionVolume volume(clay);
  std::vector<PatchVertices> views = viewsOf(patches);
  progress.step("light", 0.2);
  const auto lights = lightOf(volume, views, kReachUnits * shot.stage.unit);
  progress.step("light", 1);

  OffscreenContext context;
  Renderer renderer;
  for (std::size_t n = 0; n < views.size(); ++n) {
    views[n].light = lights[n];
    renderer.uploadPatch(views[n]);
  }
  renderer.setFloorOcclusion(floorOcclusion(volume, shot.stage, bounds));
  for (int n = 0; n < options.slices; ++n) {
    progress.step("picture", double(n) / options.slices);
    renderer.addSlice(shot, options.look);
  }
  progress.step("picture", 1);
  return renderer.mean(shot);
}

}  // namespace bozzetto
