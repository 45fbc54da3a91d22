#include "bozzetto/render/renderer.hpp"

#include <cassert>
#include <string>

#include "bozzetto/base/error.hpp"
#include "render/renderer_impl.hpp"

namespace bozzetto {
namespace {

constexpr int kSmallest = 16, kLargest = 8192;

// GL's first row is the lowest.
Image readPixels(const Target& target) {
  Image image(target.width, target.height);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, target.framebuffer.get());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  for (int y = 0; y < image.height; ++y) {
    glReadPixels(0, image.height - 1 - y, image.width, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                 image.at(0, y).data());
  }
  for (Image::Pixel& pixel : image.pixels) pixel[3] = 255;
  return image;
}

}  // namespace

void requireSize(const Shot& shot) {
  const auto within = [](int v) { return kSmallest <= v && v <= kLargest; };
  if (within(shot.width) && within(shot.height)) return;
  throw Error("picture size: " + std::to_string(shot.width) + "x" + std::to_string(shot.height) +
              " found, 16 to 8192 pixels a side expected");
}

Renderer::Renderer() : impl_(std::make_unique<Impl>()) {}
Renderer::~Renderer() = default;

void Renderer::uploadPatch(const PatchVertices& patch) { impl_->patches.upload(patch); }
void Renderer::removePatch(Key origin) { impl_->patches.remove(origin); }
void Renderer::clear() { impl_->patches.clear(); }
std::size_t Renderer::triangleCount() const { return impl_->patches.triangleCount(); }

void Renderer::setFloorOcclusion(const FloorOcclusion& floor) {
  impl_->floorMap = floorTexture(floor);
}

void Renderer::draw(const Shot& shot, const Look& look) {
  requireSize(shot);
  impl_->drawFrame(shot, look, Slice{});
  gl::check("drawing a frame");
}

void Renderer::restart() { impl_->slices = 0; }
int Renderer::sliceCount() const { return impl_->slices; }

void Renderer::Impl::prepareSum(const Shot& shot) {
  if (!slice || slice->width != shot.width || slice->height != shot.height) {
    slice.emplace(GL_RGBA8, shot.width, shot.height, Target::Depth::buffer);
    sum.emplace(GL_RGBA16F, shot.width, shot.height, Target::Depth::none);
    gl::check("making room for the picture");
    slices = 0;
  }
  if (slices > 0) return;
  sum->bind();
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
}

void Renderer::addSlice(const Shot& shot, const Look& look) {
  requireSize(shot);
  const gl::KeepTarget keep;
  Impl& r = *impl_;
  r.prepareSum(shot);
  r.slice->bind();
  r.drawFrame(shot, look, sliceAt(r.slices));
  r.sum->bind();
  gl::bindTexture(gl::source, r.slice->colour);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  r.programs.copy.use();
  r.programs.copy.set("weight", 1 / Impl::kSumScale);
  r.drawTriangle(r.programs.copy);
  glDisable(GL_BLEND);
  ++r.slices;
  gl::check("drawing a slice");
}

void Renderer::showSlices(const Shot& shot) {
  if (impl_->slices == 0) return;
  glViewport(0, 0, shot.width, shot.height);
  gl::bindTexture(gl::source, impl_->sum->colour);
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  impl_->programs.copy.use();
  impl_->programs.copy.set("weight", Impl::kSumScale / float(impl_->slices));
  impl_->drawTriangle(impl_->programs.copy);
}

Image Renderer::mean(const Shot& shot) {
  assert(impl_->slices > 0);
  const gl::KeepTarget keep;
  impl_->slice->bind();
  showSlices(shot);
  Image image = readPixels(*impl_->slice);
  gl::check("reading the picture");
  return image;
}

}  // namespace bozzetto
