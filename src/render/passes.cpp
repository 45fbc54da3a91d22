// The passes of one frame: shadow map, background, floor, clay.
#include <algorithm>
#include <iterator>

#include "render/enabled.hpp"
#include "render/renderer_impl.hpp"

namespace bozzetto {
namespace {

using gl::Enabled;

template <class Block>
void uploadBlock(GLuint binding, const gl::Buffer& buffer, const Block& block) {
  glBindBuffer(GL_UNIFORM_BUFFER, buffer.get());
  glBufferData(GL_UNIFORM_BUFFER, sizeof(Block), &block, GL_STREAM_DRAW);
  glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffer.get());
}

bool anyNear(const StudioBlock& block) {
  return std::any_of(std::begin(block.lightPlace), std::end(block.lightPlace),
                     [](const glm::vec4& place) { return place.w > 0; });
}

}  // namespace

Programs::Programs()
    : clay({"frame", "surface.vert"},
           {"frame", "noise", "colour", "studio", "surface", "shadow", "clay.frag"}),
      baked({"frame", "surface.vert"},
            {"frame", "noise", "colour", "studio", "surface", "baked.frag"}),
      metal({"frame", "surface.vert"},
            {"frame", "noise", "colour", "studio", "surface", "metal.frag"}),
      glass({"frame", "surface.vert"},
            {"frame", "noise", "colour", "studio", "surface", "glass.frag"}),
      matcap({"frame", "surface.vert"},
             {"frame", "noise", "colour", "studio", "surface", "matcap.frag"}),
      wire({"frame", "surface.vert"},
           {"frame", "noise", "colour", "studio", "surface", "wire.frag"}),
      depth({"frame", "depth.vert"}, {"depth.frag"}),
      background({"screen.vert"}, {"frame", "noise", "background.frag"}),
      floor({"frame", "floor.vert"}, {"frame", "noise", "shadow", "floor.frag"}),
      floorWithoutShadow({"frame", "floor.vert"}, {"frame", "noise", "no_shadow", "floor.frag"}),
      bake({"screen.vert"}, {"colour", "studio", "bake.frag"}),
      copy({"screen.vert"}, {"copy.frag"}) {}

Renderer::Impl::Impl() : floorMap(floorTexture({})) { gl::check("setting up the renderer"); }

void Renderer::Impl::drawTriangle(const gl::Program& program) {
  program.use();
  glBindVertexArray(nothing.get());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

// Full light asks for the good map; a moving frame takes a quick one while lights are dragged.
void Renderer::Impl::bindStudio(const Frame& frame, const Look& look) {
  const bool full = look.detail == Detail::full;
  const StudioCache::Map& map =
      studios.mapOf(look.studio, full ? MapQuality::good : MapQuality::quick);
  const StudioBlock block = studioFor(look, map.harmonics, frame.pose);
  uploadBlock(gl::kStudioBlock, studioBuffer, block);
  gl::bindTexture(gl::environmentMap, map.reflections);
  if (look.mode == Mode::matcap || look.mode == Mode::wire) {
    const gl::Texture& ball = studios.matcapOf(look);
    gl::bindTexture(gl::matcap, ball);
  } else if (!full) {
    bindBall(block, map);
  }
  gl::bindTexture(gl::shadowMap, shadow.depth);
  gl::bindTexture(gl::floorOcclusion, floorMap);
}

// The ball knows nothing of what changes without light: options that act on the pixel, and where
// the stage stands, which only near lights see.
void Renderer::Impl::bindBall(const StudioBlock& block, const StudioCache::Map& map) {
  StudioBlock key = block;
  key.options = {};
  key.tint = {};
  if (!anyNear(key)) key.middle = {};
  const gl::Texture* ball = studios.ball(key, map);
  if (ball == nullptr) {
    const gl::KeepTarget keep;
    Target target(GL_RGBA8, 256, 256, Target::Depth::none);
    target.bind();
    drawTriangle(programs.bake);
    target.smooth();
    ball = &studios.keepBall(key, map, std::move(target.colour));
  }
  gl::bindTexture(gl::matcap, *ball);
}

void Renderer::Impl::setUp(const Frame& frame, const Look& look) {
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glCullFace(GL_BACK);
  uploadBlock(gl::kFrameBlock, frameBuffer, frame.block);
  bindStudio(frame, look);
}

void Renderer::Impl::beginShadowMap() {
  const gl::KeepTarget keep;
  glBindFramebuffer(GL_FRAMEBUFFER, shadow.framebuffer.get());
  glClear(GL_DEPTH_BUFFER_BIT);
  ++shadowTicket;
}

void Renderer::Impl::drawShadows(const Frame&, std::span<const PatchStore::Seen> chunks) {
  const gl::KeepTarget keep;
  glBindFramebuffer(GL_FRAMEBUFFER, shadow.framebuffer.get());
  glViewport(0, 0, ShadowMap::kSide, ShadowMap::kSide);
  const Enabled test(GL_DEPTH_TEST), cull(GL_CULL_FACE);
  programs.depth.use();
  PatchStore::draw(programs.depth, chunks);
}

// Background, and the floor where it is in sight: premultiplied, leaving no depth.
void Renderer::Impl::drawBackdrop(const Frame& frame) {
  glClear(GL_DEPTH_BUFFER_BIT);
  drawTriangle(programs.background);
  if (!frame.floorInSight) return;
  const Enabled blend(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  const bool shadows = frame.block.shadowing.z > 0;
  (shadows ? programs.floor : programs.floorWithoutShadow).use();
  glBindVertexArray(nothing.get());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

const gl::Program& Renderer::Impl::programFor(const Look& look) const {
  switch (look.mode) {
    case Mode::metal:
      return programs.metal;
    case Mode::glass:
      return programs.glass;
    case Mode::matcap:
    case Mode::wire:
      return programs.matcap;
    default:
      return look.detail == Detail::full ? programs.clay : programs.baked;
  }
}

void Renderer::Impl::drawClay(const Frame&, const Look& look,
                              std::span<const PatchStore::Seen> chunks) {
  const Enabled test(GL_DEPTH_TEST), cull(GL_CULL_FACE);
  const gl::Program& program = programFor(look);
  program.use();
  if (look.mode == Mode::glass) {
    drawGlass(chunks);
  } else {
    PatchStore::draw(program, chunks);
  }
  if (look.mode == Mode::wire || look.edges) drawEdges(chunks);
}

// Per side only the layer next to the eye: depth first, then colour where depth is equal.
void Renderer::Impl::drawGlass(std::span<const PatchStore::Seen> chunks) {
  const Enabled blend(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  for (const GLenum hidden : {GL_FRONT, GL_BACK}) {
    glCullFace(hidden);
    glClear(GL_DEPTH_BUFFER_BIT);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    PatchStore::draw(programs.glass, chunks);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthFunc(GL_EQUAL);
    PatchStore::draw(programs.glass, chunks);
    glDepthFunc(GL_LESS);
  }
}

void Renderer::Impl::drawEdges(std::span<const PatchStore::Seen> chunks) {
  const Enabled blend(GL_BLEND), offset(GL_POLYGON_OFFSET_LINE);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glPolygonOffset(-1, -8);
  glDepthMask(GL_FALSE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  programs.wire.use();
  programs.wire.set("ink", glm::vec4(.10f, .16f, .28f, .62f));
  PatchStore::draw(programs.wire, chunks);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glDepthMask(GL_TRUE);
}

namespace {

std::size_t trianglesOf(std::span<const PatchStore::Seen> chunks) {
  std::size_t sum = 0;
  for (const PatchStore::Seen& chunk : chunks) sum += chunk.triangles();
  return sum;
}

}  // namespace

std::size_t Renderer::Impl::drawFrame(const Shot& shot, const Look& look, Fineness fineness,
                                      int taps) {
  Slice slice;
  slice.taps = taps;
  const Frame frame = makeFrame(shot, look, slice);
  setUp(frame, look);
  if (look.detail == Detail::full) {
    beginShadowMap();
    drawShadows(frame, store(fineness).seen(frame.anchor, frame.block.shadowFromCells));
  }
  glViewport(0, 0, frame.width, frame.height);
  const auto chunks = store(fineness).seen(frame.anchor, frame.block.clipFromCells);
  drawBackdrop(frame);
  drawClay(frame, look, chunks);
  glBindVertexArray(0);
  return trianglesOf(chunks);
}

// Everything is placed as for the whole frame; scissors and culling keep to the part.
std::size_t Renderer::Impl::redrawPart(const Shot& shot, const Look& look, const PixelRect& part) {
  const Frame frame = makeFrame(shot, look, Slice{});
  Shot cropped = shot;
  cropped.part = part;
  const Frame seen = makeFrame(cropped, look, Slice{});
  setUp(frame, look);
  glViewport(0, 0, frame.width, frame.height);
  const Enabled scissor(GL_SCISSOR_TEST);
  glScissor(part.x, part.y, part.width, part.height);
  const auto chunks = store(finest()).seen(frame.anchor, seen.block.clipFromCells);
  drawBackdrop(frame);
  drawClay(frame, look, chunks);
  glBindVertexArray(0);
  return trianglesOf(chunks);
}

void Renderer::Impl::begin(SliceSum& sum, const Shot& shot, const Look& look) {
  const PixelRect part = shot.drawn();
  if (!sum.slice || sum.slice->width != part.width || sum.slice->height != part.height) {
    sum.slice.emplace(GL_RGBA8, part.width, part.height, Target::Depth::buffer);
    sum.sum.emplace(GL_RGBA16F, part.width, part.height, Target::Depth::none);
    gl::check("making room for the picture");
    sum.slices = 0;
  }
  if (sum.slices == 0) {
    sum.sum->bind();
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
  }
  SliceProgress& next = sum.progress.emplace();
  next.frame = makeFrame(shot, look, sliceAt(sum.slices));
  const PatchStore& clay = store(finest());
  if (look.detail == Detail::full) {
    next.shadow = clay.seen(next.frame.anchor, next.frame.block.shadowFromCells);
    beginShadowMap();
  }
  next.clay = clay.seen(next.frame.anchor, next.frame.block.clipFromCells);
  next.shadowTicket = shadowTicket;
}

namespace {

// The next chunks of about `triangles` in all, at least one; all of them for 0.
std::span<const PatchStore::Seen> nextOf(const std::vector<PatchStore::Seen>& all,
                                         std::size_t& done, std::size_t& triangles) {
  const std::size_t begin = done;
  std::size_t sum = 0;
  while (done < all.size() && (triangles == 0 || sum < triangles)) sum += all[done++].triangles();
  if (triangles > 0) triangles = sum < triangles ? triangles - sum : 1;
  return std::span(all).subspan(begin, done - begin);
}

}  // namespace

// Shadow map, backdrop, clay, each as far as the budget goes. True when the slice is whole.
bool Renderer::Impl::drawSome(SliceSum& sum, const Look& look, std::size_t triangles) {
  SliceProgress& p = *sum.progress;
  const bool all = triangles == 0;
  drawShadows(p.frame, nextOf(p.shadow, p.shadowDone, triangles));
  if (p.shadowDone < p.shadow.size() || (!all && triangles == 1)) return false;
  sum.slice->bind();
  if (!p.backgroundDone) drawBackdrop(p.frame);
  p.backgroundDone = true;
  if (look.mode == Mode::glass || look.mode == Mode::wire || look.edges) triangles = 0;
  drawClay(p.frame, look, nextOf(p.clay, p.clayDone, triangles));
  return p.clayDone == p.clay.size();
}

void Renderer::Impl::addTo(SliceSum& sum) {
  sum.sum->bind();
  gl::bindTexture(gl::source, sum.slice->colour);
  const Enabled blend(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  programs.copy.use();
  programs.copy.set("weight", 1 / SliceSum::kScale);
  drawTriangle(programs.copy);
  ++sum.slices;
  sum.progress.reset();
}

bool Renderer::Impl::advance(SliceSum& sum, const Shot& shot, const Look& look,
                             std::size_t triangles) {
  const gl::KeepTarget keep;
  if (sum.progress && sum.progress->shadowTicket != shadowTicket) sum.progress.reset();
  if (!sum.progress) begin(sum, shot, look);
  setUp(sum.progress->frame, look);
  const bool whole = drawSome(sum, look, triangles);
  if (whole) addTo(sum);
  glBindVertexArray(0);
  gl::check("drawing a slice");
  return whole;
}

void Renderer::Impl::show(const SliceSum& sum) {
  gl::bindTexture(gl::source, sum.sum->colour);
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  programs.copy.use();
  programs.copy.set("weight", SliceSum::kScale / float(sum.slices));
  drawTriangle(programs.copy);
}

}  // namespace bozzetto
