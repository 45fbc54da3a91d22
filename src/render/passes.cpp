// The passes of one frame: shadow map, background, floor, clay.
#include "render/environment.hpp"
#include "render/renderer_impl.hpp"

namespace bozzetto {
namespace {

// On during a scope, off after it.
class Enabled {
 public:
  explicit Enabled(GLenum what) : what_(what) { glEnable(what_); }
  Enabled(const Enabled&) = delete;
  Enabled& operator=(const Enabled&) = delete;
  ~Enabled() { glDisable(what_); }

 private:
  GLenum what_;
};

template <class Block>
void uploadBlock(GLuint binding, const gl::Buffer& buffer, const Block& block) {
  glBindBuffer(GL_UNIFORM_BUFFER, buffer.get());
  glBufferData(GL_UNIFORM_BUFFER, sizeof(Block), &block, GL_STREAM_DRAW);
  glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffer.get());
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
      bake({"screen.vert"}, {"colour", "studio", "bake.frag"}),
      copy({"screen.vert"}, {"copy.frag"}) {}

Renderer::Impl::Impl()
    : harmonics(ambientHarmonics()), reflections(reflectionTexture()), floorMap(floorTexture({})) {
  gl::check("setting up the renderer");
}

void Renderer::Impl::drawTriangle(const gl::Program& program) {
  program.use();
  glBindVertexArray(nothing.get());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Renderer::Impl::bindFrame(const Frame& frame) {
  uploadBlock(gl::kFrameBlock, frameBuffer, frame.block);
}

void Renderer::Impl::bindStudio(const Look& look) {
  uploadBlock(gl::kStudioBlock, studioBuffer, studioFor(look, harmonics));
  gl::bindTexture(gl::environmentMap, reflections);
  gl::bindTexture(gl::shadowMap, shadow.depth);
  gl::bindTexture(gl::floorOcclusion, floorMap);
}

const gl::Texture& Renderer::Impl::bakedBall(const Look& look) {
  gl::Texture& ball = bakedBalls[look.mode];
  if (ball) return ball;
  const gl::KeepTarget keep;
  Target target(GL_RGBA8, 256, 256, Target::Depth::none);
  target.bind();
  drawTriangle(programs.bake);
  ball = std::move(target.colour);
  gl::bindTexture(gl::matcap, ball);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  return ball;
}

// Wire shows its lines on plaster.
void Renderer::Impl::bindMatcap(const Look& look) {
  if (look.mode == Mode::matcap || look.mode == Mode::wire) {
    const Matcap which = look.mode == Mode::wire ? Matcap::plaster : look.matcap;
    gl::Texture& texture = painted[which];
    if (!texture) texture = matcapTexture(which);
    gl::bindTexture(gl::matcap, texture);
  } else if (look.detail == Detail::baked) {
    gl::bindTexture(gl::matcap, bakedBall(look));
  }
}

void Renderer::Impl::drawShadowMap(const Frame& frame) {
  const gl::KeepTarget keep;
  glBindFramebuffer(GL_FRAMEBUFFER, shadow.framebuffer.get());
  glViewport(0, 0, ShadowMap::kSide, ShadowMap::kSide);
  glClear(GL_DEPTH_BUFFER_BIT);
  const Enabled test(GL_DEPTH_TEST), cull(GL_CULL_FACE);
  programs.depth.use();
  patches.draw(programs.depth, frame.anchor, frame.block.shadowFromCells);
}

// Premultiplied; the floor leaves no depth and is not there from below.
void Renderer::Impl::drawFloor(const Frame& frame) {
  if (!frame.eyeAboveFloor) return;
  const Enabled blend(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  programs.floor.use();
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

void Renderer::Impl::drawClay(const Frame& frame, const Look& look) {
  const Enabled test(GL_DEPTH_TEST), cull(GL_CULL_FACE);
  const gl::Program& program = programFor(look);
  program.use();
  if (look.mode == Mode::glass) return drawGlass(frame);
  patches.draw(program, frame.anchor, frame.block.clipFromCells);
  if (look.mode == Mode::wire) drawWire(frame);
}

// Per side only the layer next to the eye: depth first, then colour where depth is equal.
void Renderer::Impl::drawGlass(const Frame& frame) {
  const Enabled blend(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  for (const GLenum hidden : {GL_FRONT, GL_BACK}) {
    glCullFace(hidden);
    glClear(GL_DEPTH_BUFFER_BIT);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    patches.draw(programs.glass, frame.anchor, frame.block.clipFromCells);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthFunc(GL_EQUAL);
    patches.draw(programs.glass, frame.anchor, frame.block.clipFromCells);
    glDepthFunc(GL_LESS);
  }
}

void Renderer::Impl::drawWire(const Frame& frame) {
  const Enabled blend(GL_BLEND), offset(GL_POLYGON_OFFSET_LINE);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glPolygonOffset(-1, -8);
  glDepthMask(GL_FALSE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  programs.wire.use();
  programs.wire.set("ink", glm::vec4(.10f, .16f, .28f, .62f));
  patches.draw(programs.wire, frame.anchor, frame.block.clipFromCells);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glDepthMask(GL_TRUE);
}

void Renderer::Impl::drawFrame(const Shot& shot, const Look& look, const Slice& at) {
  const Frame frame = makeFrame(shot, look, at);
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glCullFace(GL_BACK);
  bindFrame(frame);
  bindStudio(look);
  bindMatcap(look);
  if (look.detail == Detail::full) drawShadowMap(frame);
  glViewport(0, 0, shot.width, shot.height);
  glClear(GL_DEPTH_BUFFER_BIT);
  drawTriangle(programs.background);
  drawFloor(frame);
  drawClay(frame, look);
  glBindVertexArray(0);
}

}  // namespace bozzetto
