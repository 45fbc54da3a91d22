// The head in a framebuffer, as the window shows it while things move.
#pragma once
#include "bozzetto/render/offscreen.hpp"
#include "bozzetto/render/viewport.hpp"
#include "loaded.hpp"

namespace bozzetto::test {

struct HeadView {
  PixelRect place;
  OffscreenContext context;
  Target target;
  Renderer renderer;
  Viewport viewport{renderer};
  ViewFrame frame;

  /// In a framebuffer of so many pixels that is magenta elsewhere.
  HeadView(const PixelRect& at, int width, int height)
      : place(at), target(GL_RGBA8, width, height, Target::Depth::buffer) {
    theHead().upload(renderer);
    const Shot shot = theHead().shot(place.width, place.height);
    frame.camera = shot.camera;
    frame.stage = shot.stage;
    frame.place = place;
    viewport.fixQuality(Quality::light);
    target.bind();
    glClearColor(1, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
  }
  FrameReport draw(const Overlays& overlays = {}) {
    target.bind();
    return viewport.draw(frame, overlays);
  }
  Image picture() {
    target.bind();
    return readBack(place);
  }
};

}  // namespace bozzetto::test
