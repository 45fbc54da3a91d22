// The head of scenes.hpp, ready to be drawn, and pictures read back from framebuffers.
#pragma once
#include "bozzetto/render/dresser.hpp"
#include "bozzetto/render/pick.hpp"
#include "bozzetto/render/renderer.hpp"
#include "render/stage_textures.hpp"
#include "scenes.hpp"

namespace bozzetto::test {

struct Loaded {
  Scene scene = sceneOf(head());
  Dresser dresser;
  std::vector<UnpackedPatch> patches = dresser.rebuild(scene.clay, scene.surface);
  CellBounds bounds = dresser.bounds(scene.surface);

  Shot shot(int width = 160, int height = 120) const {
    Shot shot;
    shot.width = width;
    shot.height = height;
    shot.stage = Stage::around(bounds);
    shot.camera = framed({&bounds, 1}, {.aspect = double(width) / height});
    return shot;
  }
  void upload(Renderer& renderer) const {
    for (const UnpackedPatch& patch : patches) renderer.uploadPatch(patch.view());
    renderer.setFloorOcclusion(dresser.floor(Stage::around(bounds), bounds));
  }
};

inline const Loaded& theHead() {
  static const Loaded loaded;
  return loaded;
}

/// A part of the framebuffer bound for reading, rows from the top.
Image readBack(const PixelRect& part);
/// Mean difference of the colours, 0…255; 255 for other sizes.
double meanDifference(const Image& a, const Image& b);
/// Pixels that differ by more than `by` in some colour.
int pixelsThatDiffer(const Image& a, const Image& b, int by = 0);

}  // namespace bozzetto::test
