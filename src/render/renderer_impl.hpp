// The renderer's inside: programs, textures, and the passes of a frame.
#pragma once
#include <map>
#include <optional>

#include "bozzetto/render/renderer.hpp"
#include "render/frame.hpp"
#include "render/patch_store.hpp"
#include "render/stage_textures.hpp"

namespace bozzetto {

struct Programs {
  gl::Program clay, baked, metal, glass, matcap, wire;
  gl::Program depth, background, floor, bake, copy;
  Programs();
};

struct Renderer::Impl {
  Programs programs;
  PatchStore patches;
  gl::VertexArray nothing = gl::newVertexArray();  // for triangles made in the vertex shader
  gl::Buffer frameBuffer = gl::newBuffer(), studioBuffer = gl::newBuffer();
  std::array<glm::vec3, 9> harmonics;
  gl::Texture reflections;
  gl::Texture floorMap;
  ShadowMap shadow;
  std::map<Matcap, gl::Texture> painted;
  std::map<Mode, gl::Texture> bakedBalls;

  // The still in progress: one slice, and the sum of slices / kSumScale.
  static constexpr float kSumScale = 16;
  std::optional<Target> slice, sum;
  int slices = 0;

  Impl();
  void drawFrame(const Shot& shot, const Look& look, const Slice& slice);
  void prepareSum(const Shot& shot);
  void drawTriangle(const gl::Program& program);

 private:
  void bindStudio(const Look& look);
  void bindFrame(const Frame& frame);
  void bindMatcap(const Look& look);
  const gl::Texture& bakedBall(const Look& look);
  void drawShadowMap(const Frame& frame);
  void drawFloor(const Frame& frame);
  void drawClay(const Frame& frame, const Look& look);
  void drawGlass(const Frame& frame);
  void drawWire(const Frame& frame);
  const gl::Program& programFor(const Look& look) const;
};

}  // namespace bozzetto
