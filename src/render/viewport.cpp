#include "bozzetto/render/viewport.hpp"

#include <algorithm>
#include <chrono>

#include "render/clay_picture.hpp"
#include "render/overlay_painter.hpp"

namespace bozzetto {
namespace {

constexpr int kSmallest = 16;  // pixels; a smaller view shows nothing

double secondsSince(std::chrono::steady_clock::time_point then) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
}

// A window's leftovers that would spoil a frame.
void tidyState() {
  for (const GLenum what : {GL_BLEND, GL_DEPTH_TEST, GL_CULL_FACE, GL_SCISSOR_TEST, GL_STENCIL_TEST,
                            GL_FRAMEBUFFER_SRGB}) {
    glDisable(what);
  }
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glBlendEquation(GL_FUNC_ADD);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

bool isMultisampled() {
  GLint buffers = 0;
  glGetIntegerv(GL_SAMPLE_BUFFERS, &buffers);
  return buffers > 0;
}

bool hasQuadBuffer() {
  GLboolean stereo = GL_FALSE;
  glGetBooleanv(GL_STEREO, &stereo);
  return stereo == GL_TRUE;
}

}  // namespace

// A clay picture with what stands still around it, kept while a cursor moves.
struct Dressed {
  std::optional<Target> picture;
  std::uint64_t version = 0;  // of the clay's
  std::optional<FloorGrid> grid;
  std::optional<BoxOutline> box;
  std::vector<ReferencePicture> pictures;

  bool needed() const { return grid || box || !pictures.empty(); }
  /// False when it is what is kept.
  bool take(const Overlays& overlays, std::uint64_t clayVersion, const PixelRect& place);
};

bool Dressed::take(const Overlays& overlays, std::uint64_t clayVersion, const PixelRect& place) {
  const bool sized = picture && picture->width == place.width && picture->height == place.height;
  if (sized && version == clayVersion && grid == overlays.grid && box == overlays.box &&
      pictures == overlays.pictures) {
    return false;
  }
  version = clayVersion;
  grid = overlays.grid;
  box = overlays.box;
  pictures = overlays.pictures;
  if (needed() && !sized) {
    const gl::KeepTarget keep;
    picture.emplace(GL_RGBA8, place.width, place.height, Target::Depth::none);
  }
  return true;
}

struct Viewport::Impl {
  Renderer::Impl& renderer;
  QualityLadder ladder;
  std::optional<Quality> fixed;
  OverlayPainter painter;
  gl::Program restore{{"screen.vert"}, {"restore.frag"}};
  gl::Program compose{{"screen.vert"}, {"stereo.frag"}};
  std::array<ClayPicture, 2> eyes;
  std::array<Dressed, 2> dressed;
  std::array<std::optional<Target>, 2> composed;  // clay and overlays, for stereo
  std::int64_t uploadedBefore = 0;

  // A good map at once: the first slice would bring it, and every moving frame after it would
  // look a little different.
  Impl(Renderer::Impl& r, std::string_view driver)
      : renderer(r), ladder(driver), eyes{ClayPicture(r), ClayPicture(r)} {
    renderer.studios.mapOf(Studio(), MapQuality::good);
  }

  Quality quality() const { return fixed.value_or(ladder.quality()); }
  ClayPicture::Request requestFor(const ViewFrame& frame) const;
  ClayPicture::Request forEye(int eye, const ViewFrame& frame, ClayPicture::Request request) const;
  void copyTo(const Target& from, const PixelRect& place);
  void drawEye(int eye, const ViewFrame& frame, const Overlays& overlays, const PixelRect& place);
  void drawStereo(const ViewFrame& frame, const Overlays& overlays);
  void composeEyes(const ViewFrame& frame);
};

Shot shotOf(const ViewFrame& frame) {
  Shot shot;
  shot.camera = frame.camera;
  shot.stage = frame.stage;
  shot.width = frame.place.width;
  shot.height = frame.place.height;
  return shot;
}

// A processor draws slices in pieces that would hold up a hand: it waits longer for it to rest.
ClayPicture::Request Viewport::Impl::requestFor(const ViewFrame& frame) const {
  ClayPicture::Request request;
  request.shot = shotOf(frame);
  request.look = frame.look;
  request.quality = quality();
  request.onProcessor = ladder.onProcessor();
  request.now = frame.now;
  request.mayRefine =
      !frame.stroke && frame.now - frame.lastInput >= (ladder.onProcessor() ? .4 : .15);
  return request;
}

// The least quality moves in half the resolution. What has come to rest is drawn in full, and stays
// until the view or the clay changes.
ClayPicture::Request Viewport::Impl::forEye(int eye, const ViewFrame& frame,
                                            ClayPicture::Request request) const {
  request.shot.eye = eyeShift(frame.camera, frame.stereo, Eye(eye));
  const bool atRest = request.mayRefine || (!frame.stroke && eyes[std::size_t(eye)].shows(request));
  if (request.quality == Quality::least && !atRest) {
    request.shot.width = std::max((request.shot.width + 1) / 2, 16);
    request.shot.height = std::max((request.shot.height + 1) / 2, 16);
  }
  return request;
}

void Viewport::Impl::copyTo(const Target& from, const PixelRect& place) {
  if (isMultisampled()) {
    const gl::KeepTarget keep;
    glViewport(place.x, place.y, place.width, place.height);
    gl::bindTexture(gl::source, from.colour);
    renderer.drawTriangle(restore);
    return;
  }
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer.get());
  const bool scaled = from.width != place.width || from.height != place.height;
  glBlitFramebuffer(0, 0, from.width, from.height, place.x, place.y, place.x + place.width,
                    place.y + place.height, GL_COLOR_BUFFER_BIT, scaled ? GL_LINEAR : GL_NEAREST);
}

void Viewport::Impl::drawEye(int eye, const ViewFrame& frame, const Overlays& overlays,
                             const PixelRect& place) {
  const ClayPicture& clay = eyes[std::size_t(eye)];
  Dressed& kept = dressed[std::size_t(eye)];
  OverlayPainter::Scene scene;
  scene.frame = &clay.frame();
  scene.clayDepth = &clay.picture().depth;
  scene.depthWidth = clay.picture().width;
  scene.depthHeight = clay.picture().height;
  scene.perspective = frame.camera.projection == Projection::perspective;
  if (kept.take(overlays, clay.version(), place) && kept.needed()) {
    const gl::KeepTarget keep;
    kept.picture->bind();
    scene.place = {0, 0, place.width, place.height};
    copyTo(clay.picture(), scene.place);
    painter.drawStanding(overlays, scene);
  }
  copyTo(kept.needed() ? *kept.picture : clay.picture(), place);
  scene.place = place;
  painter.drawMoving(overlays, scene);
}

void Viewport::Impl::composeEyes(const ViewFrame& frame) {
  const gl::KeepTarget keep;
  const PixelRect& place = frame.place;
  glViewport(place.x, place.y, place.width, place.height);
  gl::bindTexture(gl::source, composed[0]->colour);
  gl::bindTexture(gl::other, composed[1]->colour);
  compose.use();
  compose.set("view", glm::vec4(place.x, place.y, place.width, place.height));
  compose.set("mode", frame.stereo.mode == StereoMode::rowInterlaced ? 2
                      : frame.stereo.mode == StereoMode::anaglyph    ? 3
                                                                     : 1);
  renderer.drawTriangle(compose);
}

void Viewport::Impl::drawStereo(const ViewFrame& frame, const Overlays& overlays) {
  const int w = frame.place.width, h = frame.place.height;
  if (frame.stereo.mode == StereoMode::quadBuffer && hasQuadBuffer()) {
    for (const int eye : {0, 1}) {
      glDrawBuffer(eye == 0 ? GL_BACK_LEFT : GL_BACK_RIGHT);
      drawEye(eye, frame, overlays, frame.place);
    }
    glDrawBuffer(GL_BACK);
    return;
  }
  for (const int eye : {0, 1}) {
    std::optional<Target>& target = composed[std::size_t(eye)];
    const gl::KeepTarget keep;
    if (!target || target->width != w || target->height != h) {
      target.emplace(GL_RGBA8, w, h, Target::Depth::buffer);
      target->smooth();
    }
    target->bind();
    drawEye(eye, frame, overlays, {0, 0, w, h});
  }
  composeEyes(frame);
}

Viewport::Viewport(Renderer& renderer)
    : impl_(std::make_unique<Impl>(*renderer.impl_, renderer.driverName())) {}
Viewport::~Viewport() = default;

void Viewport::fixQuality(std::optional<Quality> quality) { impl_->fixed = quality; }
const QualityLadder& Viewport::ladder() const { return impl_->ladder; }

FrameReport Viewport::draw(const ViewFrame& frame, const Overlays& overlays) {
  using enum FrameReport::Clay;
  Impl& v = *impl_;
  const auto began = std::chrono::steady_clock::now();
  if (std::min(frame.place.width, frame.place.height) < kSmallest) {
    return {.quality = v.quality(), .settled = true};
  }
  const Shot shot = shotOf(frame);
  requireSize(shot);
  tidyState();
  v.ladder.setStroke(frame.stroke);
  FrameReport report;
  report.quality = v.quality();
  report.settled = true;
  const bool stereo = frame.stereo.mode != StereoMode::off;
  const ClayPicture::Request request = v.requestFor(frame);
  for (const int eye : {0, 1}) {
    if (eye == 1 && !stereo) break;
    const ClayPicture::Report clay = v.eyes[std::size_t(eye)].bring(v.forEye(eye, frame, request));
    report.clay = std::max(report.clay, clay.clay);
    report.triangles += clay.triangles;
    report.settled = report.settled && clay.settled;
    // One eye's slice at a time: they share the shadow map.
    if (clay.clay == refined) {
      report.settled = false;
      break;
    }
  }
  if (stereo) {
    v.drawStereo(frame, overlays);
  } else {
    v.drawEye(0, frame, overlays, frame.place);
  }
  if (report.clay != kept) glFinish();
  gl::check("drawing the view");
  report.milliseconds = 1e3 * secondsSince(began);
  if (report.clay == drawn) v.ladder.measured(report.milliseconds, frame.now);
  report.slices = v.eyes[0].slices();
  report.uploadedBytes = v.renderer.uploads.bytes - v.uploadedBefore;
  v.uploadedBefore = v.renderer.uploads.bytes;
  return report;
}

}  // namespace bozzetto
