#include "bozzetto/render/renderer.hpp"

#include <algorithm>
#include <cassert>
#include <string>

#include "bozzetto/base/error.hpp"
#include "render/renderer_impl.hpp"

namespace bozzetto {
namespace {

constexpr int kSmallest = 16, kLargest = 32768, kLargestPart = 8192;

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
              " found, 16 to 32768 pixels a side expected");
}

namespace {

void requireDrawable(const Shot& shot) {
  requireSize(shot);
  const PixelRect part = shot.drawn();
  if (std::max(part.width, part.height) <= kLargestPart) return;
  throw Error("picture size: " + std::to_string(part.width) + "x" + std::to_string(part.height) +
              " found, at most 8192 pixels a side expected at once");
}

}  // namespace

Renderer::Renderer() : impl_(std::make_unique<Impl>()) {}
Renderer::~Renderer() = default;

void Renderer::uploadPatch(const PatchVertices& patch) {
  Impl& r = *impl_;
  r.changes.note(r.store(patch.fineness).upload(patch, r.uploads.bytes));
  ++r.uploads.patches;
}

void Renderer::removePatch(Key origin, Fineness fineness) {
  Impl& r = *impl_;
  r.changes.note(r.store(fineness).remove(origin, r.uploads.bytes));
}

void Renderer::clear() {
  for (PatchStore& store : impl_->stores) store.clear();
  impl_->changes.noteAll();
}

void Renderer::clear(Fineness fineness) {
  impl_->store(fineness).clear();
  impl_->changes.noteAll();
}

std::size_t Renderer::triangleCount(Fineness fineness) const {
  return impl_->store(fineness).triangleCount();
}

const UploadCounters& Renderer::uploads() const { return impl_->uploads; }

void Renderer::setFloorOcclusion(const FloorOcclusion& floor) {
  impl_->floorMap = floorTexture(floor);
  impl_->changes.noteAll();
}

void Renderer::draw(const Shot& shot, const Look& look) {
  requireDrawable(shot);
  impl_->drawFrame(shot, look, impl_->finest());
  gl::check("drawing a frame");
}

void Renderer::restart() { impl_->still.restart(); }
int Renderer::sliceCount() const { return impl_->still.slices; }

void Renderer::addSlice(const Shot& shot, const Look& look) {
  requireDrawable(shot);
  impl_->advance(impl_->still, shot, look);
}

void Renderer::showSlices(const Shot& shot) {
  if (impl_->still.slices == 0) return;
  glViewport(0, 0, shot.drawn().width, shot.drawn().height);
  impl_->show(impl_->still);
}

Image Renderer::mean(const Shot& shot) {
  assert(impl_->still.slices > 0);
  const gl::KeepTarget keep;
  impl_->still.slice->bind();
  showSlices(shot);
  Image image = readPixels(*impl_->still.slice);
  gl::check("reading the picture");
  return image;
}

std::string Renderer::driverName() const {
  const GLubyte* name = glGetString(GL_RENDERER);
  return name == nullptr ? "unknown" : reinterpret_cast<const char*>(name);
}

}  // namespace bozzetto
