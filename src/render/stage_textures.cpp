#include "render/stage_textures.hpp"

#include "bozzetto/base/error.hpp"
#include "render/environment.hpp"

namespace bozzetto {
namespace {

void requireComplete() {
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw Error("OpenGL: the driver refuses a framebuffer");
  }
}

// The standard studio's takes 0.2 s when good: once, not per renderer.
SphereMap standardMap(const Surroundings& surroundings, MapQuality quality) {
  static const Surroundings standard{Studio()};
  if (surroundings != standard) return reflectionMap(surroundings, quality);
  if (quality == MapQuality::quick) return reflectionMap(standard, quality);
  static const SphereMap map = reflectionMap(standard, MapQuality::good);
  return map;
}

}  // namespace

ShadowMap::ShadowMap()
    : depth(gl::newTexture({GL_DEPTH_COMPONENT24, kSide, kSide})),
      framebuffer(gl::newFramebuffer()) {
  constexpr float kLit[4] = {1, 1, 1, 1};
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, kLit);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth.get(), 0);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  requireComplete();
}

gl::Texture reflectionTexture(const Surroundings& surroundings, MapQuality quality) {
  const SphereMap map = standardMap(surroundings, quality);
  gl::Texture texture =
      gl::newTexture({GL_RGBA16F, SphereMap::kSide, SphereMap::kSide, gl::Filter::mipmaps});
  for (int n = 0; n < SphereMap::kLevels; ++n) {
    const int side = SphereMap::kSide >> n;
    glTexImage2D(GL_TEXTURE_2D, n, GL_RGBA16F, side, side, 0, GL_RGB, GL_FLOAT,
                 map.level[std::size_t(n)].data());
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, SphereMap::kLevels - 1);
  return texture;
}

gl::Texture imageTexture(const Image& image) {
  gl::Texture texture = gl::newTexture({GL_RGBA8, image.width, image.height, gl::Filter::mipmaps});
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE,
                  image.pixels.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  return texture;
}

gl::Texture floorTexture(const FloorOcclusion& floor) {
  const bool open = floor.texels.empty();
  const int side = open ? 1 : FloorOcclusion::kSide;
  const std::uint8_t white = 255;
  gl::Texture texture = gl::newTexture({GL_R8, side, side});
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, side, side, GL_RED, GL_UNSIGNED_BYTE,
                  open ? &white : floor.texels.data());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  return texture;
}

Target::Target(GLenum format, int w, int h, Depth withDepth)
    : colour(gl::newTexture({format, w, h, gl::Filter::nearest})),
      framebuffer(gl::newFramebuffer()),
      width(w),
      height(h) {
  if (withDepth == Depth::buffer) {
    depth = gl::newTexture({GL_DEPTH_COMPONENT24, w, h, gl::Filter::nearest});
  }
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour.get(), 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth.get(), 0);
  requireComplete();
}

void Target::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  glViewport(0, 0, width, height);
}

void Target::smooth() const {
  gl::bindTexture(gl::making, colour);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
}

Multisampled::Multisampled(int width, int height, int samples)
    : colour(gl::newRenderbuffer()),
      depth(gl::newRenderbuffer()),
      framebuffer(gl::newFramebuffer()) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  const auto attach = [&](const gl::Renderbuffer& buffer, GLenum format, GLenum where) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.get());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, where, GL_RENDERBUFFER, buffer.get());
  };
  attach(colour, GL_RGBA8, GL_COLOR_ATTACHMENT0);
  attach(depth, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT);
  requireComplete();
}

}  // namespace bozzetto
