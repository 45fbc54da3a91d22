#include "bozzetto/render/renderer.hpp"

#include <gtest/gtest.h>

#include "bozzetto/render/offscreen.hpp"
#include "loaded.hpp"

namespace bozzetto {
namespace {

using namespace test;

Shot shotOf(const Loaded& loaded) { return loaded.shot(128, 96); }

Look lookOf(Detail detail) {
  Look look;
  look.detail = detail;
  return look;
}

Image still(Renderer& renderer, const Shot& shot) {
  renderer.restart();
  for (int n = 0; n < 2; ++n) renderer.addSlice(shot, {});
  return renderer.mean(shot);
}

TEST(Renderer, PatchesComeAndGo) {
  const Loaded& loaded = theHead();
  const OffscreenContext context;
  Renderer renderer;
  const Image empty = still(renderer, shotOf(loaded));
  for (const UnpackedPatch& patch : loaded.patches) renderer.uploadPatch(patch.view());
  EXPECT_EQ(renderer.triangleCount(), std::size_t(loaded.scene.surface.totals().triangles));
  const Image whole = still(renderer, shotOf(loaded));
  EXPECT_NE(whole.pixels, empty.pixels);

  // Every second patch away and back again, in another order, changes nothing.
  for (std::size_t n = 0; n < loaded.patches.size(); n += 2) {
    renderer.removePatch(loaded.patches[n].origin);
  }
  EXPECT_NE(still(renderer, shotOf(loaded)).pixels, whole.pixels);
  for (std::size_t n = loaded.patches.size(); n-- > 0;) {
    renderer.uploadPatch(loaded.patches[n].view());
  }
  EXPECT_EQ(still(renderer, shotOf(loaded)).pixels, whole.pixels);

  for (const UnpackedPatch& patch : loaded.patches) {
    renderer.uploadPatch({patch.origin, {}, {}, {}, {}, {}});  // empty: gone
  }
  EXPECT_EQ(renderer.triangleCount(), 0u);
  EXPECT_EQ(still(renderer, shotOf(loaded)).pixels, empty.pixels);
}

TEST(Renderer, ClearForgetsEverything) {
  const Loaded& loaded = theHead();
  const OffscreenContext context;
  Renderer renderer;
  for (const UnpackedPatch& patch : loaded.patches) renderer.uploadPatch(patch.view());
  renderer.clear();
  EXPECT_EQ(renderer.triangleCount(), 0u);
}

TEST(Renderer, SlicesAddUpAndRestart) {
  const Loaded& loaded = theHead();
  const OffscreenContext context;
  Renderer renderer;
  renderer.addSlice(shotOf(loaded), {});
  renderer.addSlice(shotOf(loaded), {});
  EXPECT_EQ(renderer.sliceCount(), 2);
  renderer.restart();
  EXPECT_EQ(renderer.sliceCount(), 0);
  Shot wrong = shotOf(loaded);
  wrong.width = 40000;
  EXPECT_THROW(renderer.addSlice(wrong, {}), Error);
}

// What a window does: a frame of its own size into a framebuffer of its own.
TEST(Renderer, DrawsIntoTheBoundFramebuffer) {
  const Loaded& loaded = theHead();
  const OffscreenContext context;
  Renderer renderer;
  for (const UnpackedPatch& patch : loaded.patches) renderer.uploadPatch(patch.view());
  const Shot shot = shotOf(loaded);
  const Target target(GL_RGBA8, shot.width, shot.height, Target::Depth::buffer);
  target.bind();
  for (const Detail detail : {Detail::baked, Detail::full}) {
    renderer.draw(shot, lookOf(detail));
    Image frame(shot.width, shot.height);
    glReadPixels(0, 0, shot.width, shot.height, GL_RGBA, GL_UNSIGNED_BYTE, frame.pixels.data());
    const Image refined = still(renderer, shot);
    GLint bound = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    EXPECT_EQ(GLuint(bound), target.framebuffer.get());
    // GL counts rows from the bottom.
    double difference = 0;
    for (int y = 0; y < shot.height; ++y) {
      for (int x = 0; x < shot.width; ++x) {
        difference += std::abs(frame.at(x, shot.height - 1 - y)[0] - refined.at(x, y)[0]);
      }
    }
    EXPECT_LT(difference / (shot.width * shot.height), 8);
  }
}

TEST(Offscreen, ContextsLiveBesideEachOther) {
  OffscreenContext first;
  {
    const OffscreenContext second;
    EXPECT_FALSE(second.rendererName().empty());
  }
  first.makeCurrent();
  EXPECT_NE(first.rendererName(), "unknown");
  Renderer renderer;
}

}  // namespace
}  // namespace bozzetto
