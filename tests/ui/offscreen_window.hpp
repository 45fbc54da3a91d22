// The whole window drawn without a display, into a framebuffer of its size.
#pragma once
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "bozzetto/render/offscreen.hpp"
#include "bozzetto/render/png.hpp"
#include "ui/canvas.hpp"
#include "ui/null_window.hpp"

namespace bozzetto::ui {

/// A framebuffer of the window's size with colour and depth.
class Screen {
 public:
  explicit Screen(glm::dvec2 size) {
    glGenFramebuffers(1, &framebuffer_);
    glGenRenderbuffers(2, buffers_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    const GLenum formats[] = {GL_RGBA8, GL_DEPTH_COMPONENT24};
    const GLenum places[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
    for (int n = 0; n < 2; ++n) {
      glBindRenderbuffer(GL_RENDERBUFFER, buffers_[n]);
      glRenderbufferStorage(GL_RENDERBUFFER, formats[n], int(size.x), int(size.y));
      glFramebufferRenderbuffer(GL_FRAMEBUFFER, places[n], GL_RENDERBUFFER, buffers_[n]);
    }
  }
  ~Screen() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(2, buffers_);
  }
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;
  void bind() const { glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_); }

 private:
  GLuint framebuffer_ = 0, buffers_[2] = {};
};

class Offscreen : public ::testing::Test, protected StateFolder {
 protected:
  explicit Offscreen(double radius = 48, glm::dvec2 size = {1280, 800})
      : atelier_(Atelier::Options{{}, {}, [] {}, radius}),
        interface_(atelier_),
        canvas_(interface_, atelier_) {
    resize(size);
    settle();
  }

  void resize(glm::dvec2 size) {
    size_ = size;
    screen_ = std::make_unique<Screen>(size);
  }
  bool frame() {
    now_ += 1 / 30.0;
    screen_->bind();
    Publication fresh = interface_.frame(size_, now_);
    return canvas_.draw(std::move(fresh), size_);
  }
  // All events read, all clay done and seen; nothing is refined.
  void settle() {
    do {
      frame();
      atelier_.worker().waitUntilSettled();
    } while (interface_.hasEvents() || atelier_.hasNews() || atelier_.job());
    do {
      atelier_.touch();
      frame();
    } while (canvas_.hasUploads());
  }
  // And the picture as good as it gets.
  void rest() {
    settle();
    for (int n = 0; n < 200 && !frame(); ++n) {
    }
  }
  // Kept to be looked at.
  Image picture(const std::string& name) {
    Image image = Canvas::readBack(size_);
    const std::filesystem::path folder = std::filesystem::path(BOZZETTO_BINARY_DIR) / "window";
    std::filesystem::create_directories(folder);
    writePng(folder / (name + ".png"), image);
    return image;
  }
  void moveTo(glm::dvec2 at) { interface_.post(PointerMoved{at, 1}); }
  glm::dvec2 middle() const { return interface_.layout().viewport.centre(); }

  OffscreenContext context_;
  Atelier atelier_;
  Interface interface_;
  Canvas canvas_;
  std::unique_ptr<Screen> screen_;
  glm::dvec2 size_{1280, 800};
  double now_ = 0;
};

}  // namespace bozzetto::ui
