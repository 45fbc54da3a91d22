#include "bozzetto/render/picture.hpp"

#include <memory>
#include <numbers>

#include "bozzetto/render/height_view.hpp"
#include "bozzetto/render/occlusion.hpp"
#include "bozzetto/render/offscreen.hpp"
#include "bozzetto/render/renderer.hpp"
#include "bozzetto/render/unpack.hpp"

namespace bozzetto {
namespace {

// Occlusion looks about half a model far: things beyond light each other as they darken.
constexpr double kReachUnits = 1.2;

std::vector<PatchVertices> viewsOf(const std::vector<UnpackedPatch>& patches) {
  std::vector<PatchVertices> views;
  views.reserve(patches.size());
  for (const UnpackedPatch& patch : patches) views.push_back(patch.view());
  return views;
}

// The clay on the graphics card and where it is seen from: what all pictures of a run share.
class Photographer {
 public:
  Photographer(const Surface<8>& surface, const Clay& clay, const PictureOptions& options,
               Progress& progress);
  Image frame(int number, Progress& progress);

 private:
  const PictureOptions& options_;
  std::unique_ptr<OffscreenContext> context_;
  std::unique_ptr<Renderer> renderer_;
  Shot shot_;
};

Shot framedShot(const std::vector<UnpackedPatch>& patches, const PictureOptions& options) {
  Shot shot;
  shot.width = options.width;
  shot.height = options.height;
  std::vector<CellBounds> boxes;
  CellBounds bounds;
  for (const UnpackedPatch& patch : patches) {
    boxes.push_back(patch.bounds());
    bounds.add(boxes.back());
  }
  Framing framing{options.viewpoint, options.projection, double(shot.width) / shot.height};
  framing.yaw = options.yaw;
  framing.pitch = options.pitch;
  shot.stage = Stage::around(bounds);
  shot.camera = options.camera.value_or(framed(boxes, framing));
  if (!options.camera) shot.camera.distance /= options.zoom;
  return shot;
}

CellBounds boundsOf(const std::vector<UnpackedPatch>& patches) {
  CellBounds bounds;
  for (const UnpackedPatch& patch : patches) bounds.add(patch.bounds());
  return bounds;
}

Photographer::Photographer(const Surface<8>& surface, const Clay& clay,
                           const PictureOptions& options, Progress& progress)
    : options_(options) {
  Shot size;
  size.width = options.width;
  size.height = options.height;
  requireSize(size);
  progress.step("light", 0);
  auto patches = structurePatches(surface, clay, options.structure);
  shot_ = framedShot(patches, options);
  const CellBounds bounds = boundsOf(patches);
  const double reach = kReachUnits * shot_.stage.unit;
  const OcclusionVolume volume(clay);
  progress.step("light", 0.2);
  if (options.structure == Structure::heights) {
    const bool turns = options.frames > 1;
    patches =
        clothPatches(clay, turns ? allFacings() : facingsFor(shot_.camera, bounds), volume, reach);
  } else {
    auto lights = lightOf(volume, viewsOf(patches), reach);
    for (std::size_t n = 0; n < patches.size(); ++n) patches[n].light = std::move(lights[n]);
  }
  progress.step("light", 1);

  context_ = std::make_unique<OffscreenContext>();
  renderer_ = std::make_unique<Renderer>();
  for (const UnpackedPatch& patch : patches) renderer_->uploadPatch(patch.view());
  renderer_->setFloorOcclusion(floorOcclusion(volume, shot_.stage, bounds));
}

Image Photographer::frame(int number, Progress& progress) {
  Shot shot = shot_;
  shot.camera.yaw += 2 * std::numbers::pi * number / options_.frames;
  Look look = options_.look;
  look.cellLines |=
      options_.structure == Structure::cubes || options_.structure == Structure::crossingCubes;
  return stereoStill(*renderer_, shot, look, options_.stereo, options_.slices, progress);
}

}  // namespace

Image renderPicture(const Surface<8>& surface, const Clay& clay, const PictureOptions& options,
                    Progress& progress) {
  return Photographer(surface, clay, options, progress).frame(0, progress);
}

void renderTurn(const Surface<8>& surface, const Clay& clay, const PictureOptions& options,
                FunctionRef<void(int frame, const Image&)> take, Progress& progress) {
  Photographer photographer(surface, clay, options, progress);
  for (int n = 0; n < options.frames; ++n) {
    progress.step("turn", double(n) / options.frames);
    take(n, photographer.frame(n, Progress::none()));
  }
}

}  // namespace bozzetto
