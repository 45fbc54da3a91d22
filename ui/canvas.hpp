// Draws a frame with OpenGL: the clay in its viewport, then the panels over it. Needs a current 3.3
// core context for its whole life; the same object serves the real window and pictures off-screen.
#pragma once
#include <memory>

#include "bozzetto/render/image.hpp"
#include "ui/interface.hpp"

namespace bozzetto::ui {

class Canvas {
 public:
  Canvas(Interface& interface, Atelier& atelier);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Draws what Interface::frame built, `fresh` patches included, into the framebuffer bound for
  /// drawing. True when nothing would change without new input.
  bool draw(Publication fresh, glm::dvec2 size);
  /// Some patches wait for a later frame, so that no frame waits for them.
  bool hasUploads() const;

  /// The framebuffer bound for reading.
  static Image readBack(glm::dvec2 size);
  /// A small PNG of the clay as it is seen.
  Bytes thumbnail();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace bozzetto::ui
