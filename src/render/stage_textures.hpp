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
/// Rows as they come.
gl::Texture imageTexture(const Image& image);
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
  /// Reads of the colour between pixels mix them from now on.
  void smooth() const;
};

/// Colour and depth of several samples a pixel, to draw into and to resolve.
struct Multisampled {
  gl::Renderbuffer colour, depth;
  gl::Framebuffer framebuffer;

  Multisampled(int width, int height, int samples);
};

}  // namespace bozzetto
