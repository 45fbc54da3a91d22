// What the studio needs besides geometry: reflection map, matcaps, shadow map, floor's occlusion.
#pragma once
#include <array>

#include "bozzetto/render/occlusion.hpp"
#include "render/environment.hpp"
#include "render/gl.hpp"
#include "render/studio.hpp"

namespace bozzetto {

/// A depth map that texture() compares with; beyond its rim everything is lit.
struct ShadowMap {
  static constexpr int kSide = 2048;
  gl::Texture depth;
  gl::Framebuffer framebuffer;

  ShadowMap();
};

gl::Texture reflectionTexture(const Surroundings& surroundings, MapQuality quality);
/// A ball that fills a square, rows from the bottom; drawn with its rim at .49 of the side.
gl::Texture matcapTexture(const Image& ball);
/// White (all open) for an empty map.
gl::Texture floorTexture(const FloorOcclusion& floor);

/// A colour texture with depth to draw into.
struct Target {
  gl::Texture colour, depth;
  gl::Framebuffer framebuffer;
  int width = 0, height = 0;

  Target() = default;
  enum class Depth { none, buffer };
  Target(GLenum format, int w, int h, Depth withDepth);
  void bind() const;
};

}  // namespace bozzetto
