// One view to draw.
#pragma once
#include "bozzetto/render/camera.hpp"
#include "bozzetto/render/stereo.hpp"

namespace bozzetto {

/// A part of a picture, pixels from its lower left corner.
struct PixelRect {
  int x = 0, y = 0, width = 0, height = 0;
  friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

struct Shot {
  Camera camera;
  Stage stage;
  int width = 1280, height = 960;  ///< pixels of the whole picture, 16…32768
  PixelRect part;                  ///< what is drawn of it, up to 8192 a side; empty: all
  EyeShift eye;

  PixelRect drawn() const { return part.width > 0 ? part : PixelRect{0, 0, width, height}; }
  friend bool operator==(const Shot&, const Shot&) = default;
};

/// Throws Error unless width and height are within their limits.
void requireSize(const Shot& shot);

}  // namespace bozzetto
