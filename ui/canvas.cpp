#include "ui/canvas.hpp"

#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "bozzetto/render/png.hpp"
#include "bozzetto/render/renderer.hpp"
#include "bozzetto/render/viewport.hpp"

namespace bozzetto::ui {
namespace {

constexpr std::size_t kUploadBytesAFrame = 12 << 20;
constexpr int kBallPixels = 128;

// A framebuffer with colour and depth.
class Target {
 public:
  Target(int width, int height) {
    glGenFramebuffers(1, &framebuffer_);
    glGenTextures(1, &colour_);
    glGenRenderbuffers(1, &depth_);
    glBindTexture(GL_TEXTURE_2D, colour_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glBindRenderbuffer(GL_RENDERBUFFER, depth_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
  }
  ~Target() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(1, &depth_);
    if (colour_ != 0) glDeleteTextures(1, &colour_);
  }
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;
  /// The picture; the caller deletes it.
  GLuint takeColour() { return std::exchange(colour_, 0); }
  GLuint name() const { return framebuffer_; }

 private:
  GLuint framebuffer_ = 0, colour_ = 0, depth_ = 0;
};

// A ball of 20 cells in one patch.
UnpackedPatch ballPatch(Colour colour) {
  constexpr int kAround = 64, kUp = 32;
  constexpr float kRadius = 20;
  UnpackedPatch ball(Key{});
  for (int up = 0; up <= kUp; ++up) {
    const float polar = std::numbers::pi_v<float> * float(up) / kUp;
    for (int n = 0; n <= kAround; ++n) {
      const float turn = 2 * std::numbers::pi_v<float> * float(n) / kAround;
      const glm::vec3 normal(std::sin(polar) * std::cos(turn), std::cos(polar),
                             std::sin(polar) * std::sin(turn));
      ball.positions.push_back(normal * kRadius);
      ball.normals.push_back(normal);
      ball.colours.push_back(colour);
    }
  }
  for (int up = 0; up < kUp; ++up) {
    for (int n = 0; n < kAround; ++n) {
      const auto a = std::uint16_t(up * (kAround + 1) + n), b = std::uint16_t(a + kAround + 1);
      const auto a1 = std::uint16_t(a + 1), b1 = std::uint16_t(b + 1);
      ball.indices.insert(ball.indices.end(), {a, a1, b, a1, b1, b});
    }
  }
  return ball;
}

// Pictures that we draw begin at the bottom.
enum class Rows { fromTop, fromBottom };

// Its middle: cards are square.
Image squareOf(const Image& image) {
  const int side = std::min(image.width, image.height);
  const int left = (image.width - side) / 2, top = (image.height - side) / 2;
  Image square{side, side};
  for (int y = 0; y < side; ++y) {
    const Image::Pixel* const row = &image.at(left, top + y);
    std::copy_n(row, side, &square.at(0, y));
  }
  return square;
}

enum class Cut { whole, square };

// Of a PNG; 0 for one that is damaged.
GLuint textureOf(const Bytes& png, const std::string& name, Rows rows, Cut cut = Cut::whole) {
  Image image;
  try {
    image = decodePng(png, name);
  } catch (const Error&) {
    return 0;
  }
  if (cut == Cut::square) image = squareOf(image);
  for (int y = 0; rows == Rows::fromBottom && y < image.height / 2; ++y) {
    Image::Pixel* const row = &image.at(0, y);
    std::swap_ranges(row, row + image.width, &image.at(0, image.height - 1 - y));
  }
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               image.pixels.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  return texture;
}

ImTextureID asTexture(GLuint name) { return reinterpret_cast<ImTextureID>(std::uintptr_t(name)); }

}  // namespace

struct Canvas::Impl {
  Interface* interface;
  Atelier* atelier;
  Renderer renderer;
  std::unique_ptr<Viewport> viewport;
  std::vector<GLuint> textures;
  std::vector<GLuint> dying;  // this frame's panels may show them still
  Publication waiting;
  std::shared_ptr<const SolidShown> solid;  // whose surface is uploaded
  bool hasFonts = false;

  void makeBalls();
  void takeFonts();
  void forget(ImTextureID& texture);
  void deleteForgotten();
  void takePictures(const Publication& fresh);
  void forgetSteps();
  GLuint draw(const Shot& shot, Image* copy);
  void pictureStep();
  void uploadTools();
  void uploadSolid();
  void pictureDocument();
  Shot documentShot() const;
  std::size_t upload();
};

// Every look on a ball, once: cards and the word mark show them.
void Canvas::Impl::makeBalls() {
  renderer.uploadPatch(ballPatch(Colour{}).view());
  Shot shot;
  shot.width = shot.height = kBallPixels;
  shot.stage = {glm::dvec3(0), 20 / 1.3, -1000};
  shot.camera.distance = 20 / std::sin(shot.camera.fieldOfView / 2) * 1.02;
  for (std::size_t n = 0; n < kLookCards.size(); ++n) {
    Look look;
    look.mode = kLookCards[n].mode;
    look.matcap = kLookCards[n].matcap;
    look.detail = Detail::baked;
    look.floor = false;
    Target target(kBallPixels, kBallPixels);
    glBindFramebuffer(GL_FRAMEBUFFER, target.name());
    renderer.draw(shot, look);
    textures.push_back(target.takeColour());
    interface->pictures.balls[n] = asTexture(textures.back());
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  renderer.clear();
}

// Only their texture is made anew: the back end would forget that its buffers are empty again.
void Canvas::Impl::takeFonts() {
  if (!std::exchange(hasFonts, true)) {
    ImGui_ImplOpenGL3_CreateDeviceObjects();  // nobody calls the back end's NewFrame
    return;
  }
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
}

void Canvas::Impl::forget(ImTextureID& texture) {
  const GLuint name = GLuint(reinterpret_cast<std::uintptr_t>(std::exchange(texture, nullptr)));
  if (name != 0) dying.push_back(name);
}

void Canvas::Impl::deleteForgotten() {
  glDeleteTextures(GLsizei(dying.size()), dying.data());
  dying.clear();
}

// Pictures that came from the disk.
void Canvas::Impl::takePictures(const Publication& fresh) {
  UiPictures& pictures = interface->pictures;
  if (fresh.opened) {
    for (auto& [step, texture] : pictures.steps) forget(texture);
    pictures.steps.clear();
    forget(pictures.document);
  }
  for (const auto& [step, png] : fresh.pictures) {
    ImTextureID& texture = pictures.steps[step];
    forget(texture);
    texture = asTexture(textureOf(png, "picture of a step", Rows::fromBottom));
  }
  if (!fresh.left) return;
  for (auto& [path, texture] : pictures.left) forget(texture);
  pictures.left.clear();
  for (const LeftDocument& left : *fresh.left) {
    if (left.glance.thumbnail.empty()) continue;
    pictures.left[left.path] =
        asTexture(textureOf(left.glance.thumbnail, "left behind", Rows::fromBottom));
  }
}

// Pictures of steps that are no more go.
void Canvas::Impl::forgetSteps() {
  const HistoryView& history = *atelier->status().history;
  auto& pictures = interface->pictures.steps;
  for (auto at = pictures.begin(); at != pictures.end();) {
    const bool gone = history.find(at->first) == nullptr;
    if (gone) forget(at->second);
    at = gone ? pictures.erase(at) : std::next(at);
  }
}

// The clay alone, in a texture of its own; the caller deletes it.
GLuint Canvas::Impl::draw(const Shot& shot, Image* copy) {
  Look look = atelier->options.look;
  look.detail = Detail::baked;
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  Target target(shot.width, shot.height);
  renderer.draw(shot, look);
  if (copy != nullptr) *copy = readBack({shot.width, shot.height});
  glBindFramebuffer(GL_FRAMEBUFFER, GLuint(bound));
  return target.takeColour();
}

// The step we stand at, seen close to where it happened; at rest only.
void Canvas::Impl::pictureStep() {
  const ClayStatus& status = atelier->status();
  const StepNumber step = status.history->place;
  auto& pictures = interface->pictures.steps;
  if (step == status.history->root || status.peek || status.lastEdit.empty()) return;
  if (status.lastEditStep != step || pictures.contains(step)) return;
  ViewState near = atelier->view;
  CellBounds box = status.lastEdit;
  const glm::dvec3 least = glm::dvec3(status.stage.unit * .35);
  box.low = glm::min(box.low, box.centre() - least) * status.scale.spacing;
  box.high =
      glm::max(status.lastEdit.high, status.lastEdit.centre() + least) * status.scale.spacing;
  Shot shot;
  shot.width = kStepPicture.x;
  shot.height = kStepPicture.y;
  frame(near, std::span(&box, 1), double(shot.width) / shot.height, .9);
  shot.camera = cameraOf(near, status.scale.spacing);
  shot.stage = status.stage;
  Image image;
  pictures[step] = asTexture(draw(shot, &image));
  atelier->keepPicture(step, encodePng(image));
}

// What came back, for the dialog that tells of it.
void Canvas::Impl::pictureDocument() {
  if (atelier->dialog != Dialog::recovered || interface->pictures.document) return;
  Shot shot = documentShot();
  shot.width = 400;
  shot.height = 300;
  interface->pictures.document = asTexture(draw(shot, nullptr));
}

Shot Canvas::Impl::documentShot() const {
  Shot shot;
  shot.camera = atelier->viewFrame().camera;
  shot.stage = atelier->viewFrame().stage;
  return shot;
}

// Pictures of tools on the shelf, each once; those nobody shows any more go.
void Canvas::Impl::uploadTools() {
  auto& pictures = interface->pictures.tools;
  const std::vector<ShelfCard>& cards = atelier->shelf.cards;
  std::erase_if(pictures, [&](const auto& entry) {
    const auto same = [&](const ShelfCard& card) { return card.pictureId == entry.first; };
    if (std::ranges::any_of(cards, same)) return false;
    ImTextureID texture = entry.second;
    forget(texture);
    return true;
  });
  for (const ShelfCard& card : cards) {
    if (!card.picture || card.picture->empty() || pictures.contains(card.pictureId)) continue;
    pictures[card.pictureId] =
        asTexture(textureOf(*card.picture, card.entry.name, Rows::fromTop, Cut::square));
  }
}

// The solid's surface among the clay's patches, in both finenesses: it is not coarsened.
void Canvas::Impl::uploadSolid() {
  const bool shows = atelier->mode() == WorkMode::solid && atelier->solid.surface;
  const auto wanted = shows ? atelier->solidShown() : nullptr;
  if (wanted == solid) return;
  constexpr Fineness both[] = {Fineness::fine, Fineness::coarse};
  if (solid) {
    for (const UnpackedPatch& patch : solid->surface)
      for (const Fineness fineness : both) renderer.removePatch(patch.origin, fineness);
  }
  solid = wanted;
  if (!solid) return;
  for (const UnpackedPatch& patch : solid->surface) {
    PatchVertices view = patch.view();
    for (const Fineness fineness : both) {
      view.fineness = fineness;
      renderer.uploadPatch(view);
    }
  }
}

// As much as a frame has time for; the rest stays.
std::size_t Canvas::Impl::upload() {
  if (std::exchange(waiting.cleared, false)) {
    renderer.clear();
    solid = nullptr;
  }
  std::size_t bytes = 0, patches = 0;
  const auto some = [&](std::map<Key, PatchRef>& from, Fineness fineness,
                        std::size_t most = kUploadBytesAFrame) {
    while (!from.empty() && bytes < most) {
      const auto first = from.begin();
      if (first->second) {
        renderer.uploadPatch(first->second->data.view());
        bytes += first->second->uploadBytes();
      } else {
        renderer.removePatch(first->first, fineness);
      }
      ++patches;
      from.erase(first);
    }
  };
  // Cloths come and go in one frame.
  const bool draped = !waiting.heights.empty();
  if (draped && std::exchange(waiting.undraped, false)) renderer.clear(Fineness::heights);
  some(waiting.heights, Fineness::heights, SIZE_MAX);
  some(waiting.fine, Fineness::fine);
  some(waiting.coarse, Fineness::coarse);
  const bool whole = waiting.fine.empty() && waiting.coarse.empty();
  if (whole && std::exchange(waiting.undraped, false)) renderer.clear(Fineness::heights);
  if (waiting.floor) renderer.setFloorOcclusion(*waiting.floor);
  waiting.floor.reset();
  return patches;
}

Canvas::Canvas(Interface& interface, Atelier& atelier) : impl_(std::make_unique<Impl>()) {
  impl_->interface = &interface;
  impl_->atelier = &atelier;
  GLboolean twoEyes = GL_FALSE;
  glGetBooleanv(GL_STEREO, &twoEyes);
  atelier.quadBuffer = twoEyes == GL_TRUE;
  ImGui_ImplOpenGL3_Init("#version 330 core");
  interface.fontsChanged = [impl = impl_.get()] { impl->takeFonts(); };
  impl_->makeBalls();
  impl_->viewport = std::make_unique<Viewport>(impl_->renderer);
}

Canvas::~Canvas() {
  impl_->interface->fontsChanged = nullptr;
  glDeleteTextures(GLsizei(impl_->textures.size()), impl_->textures.data());
  ImGui_ImplOpenGL3_Shutdown();
}

bool Canvas::hasUploads() const {
  const Publication& waiting = impl_->waiting;
  return !waiting.fine.empty() || !waiting.coarse.empty() || !waiting.heights.empty();
}

bool Canvas::draw(Publication fresh, glm::dvec2 size) {
  Impl& c = *impl_;
  if (c.atelier->shelf.open) c.uploadTools();
  c.takePictures(fresh);
  if (fresh.status) c.forgetSteps();
  c.waiting.add(std::move(fresh));
  const std::size_t patches = c.upload();
  c.uploadSolid();
  const Rect& at = c.interface->layout().viewport;
  const ClayStatus& status = c.atelier->status();
  ViewFrame frame = c.atelier->viewFrame();
  frame.place = {int(at.low.x), int(size.y - at.high.y), int(at.width()), int(at.height())};
  c.viewport->fixQuality(c.atelier->options.quality);
  const FrameReport report = c.viewport->draw(frame, c.atelier->overlays());
  if (!status.inStroke && status.isLit && !hasUploads()) {
    c.pictureStep();
    c.pictureDocument();
  }
  c.interface->figures.viewport = report;
  c.interface->figures.uploadedPatches = patches;
  glViewport(0, 0, int(size.x), int(size.y));
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  c.deleteForgotten();
  return report.settled && !hasUploads();
}

Image Canvas::readBack(glm::dvec2 size) {
  Image image{int(size.x), int(size.y)};
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  for (int y = 0; y < image.height; ++y) {
    glReadPixels(0, image.height - 1 - y, image.width, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                 image.at(0, y).data());
  }
  for (Image::Pixel& pixel : image.pixels) pixel[3] = 255;
  return image;
}

Bytes Canvas::thumbnail() {
  Shot shot = impl_->documentShot();
  shot.width = 240;
  shot.height = 180;
  Image image;
  const GLuint drawn = impl_->draw(shot, &image);
  glDeleteTextures(1, &drawn);
  return encodePng(image);
}

}  // namespace bozzetto::ui
