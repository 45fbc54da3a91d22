#include "loaded.hpp"

#include <cstdlib>

namespace bozzetto::test {

Image readBack(const PixelRect& part) {
  Image image(part.width, part.height);
  for (int y = 0; y < image.height; ++y) {
    glReadPixels(part.x, part.y + part.height - 1 - y, part.width, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                 image.at(0, y).data());
  }
  for (Image::Pixel& pixel : image.pixels) pixel[3] = 255;
  return image;
}

double meanDifference(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) return 255;
  double sum = 0;
  for (std::size_t n = 0; n < a.pixels.size(); ++n) {
    for (int c = 0; c < 3; ++c) sum += std::abs(int(a.pixels[n][c]) - int(b.pixels[n][c]));
  }
  return sum / double(a.pixels.size() * 3);
}

int pixelsThatDiffer(const Image& a, const Image& b, int by) {
  int count = 0;
  for (std::size_t n = 0; n < a.pixels.size(); ++n) {
    bool differs = false;
    for (int c = 0; c < 3; ++c) {
      differs |= std::abs(int(a.pixels[n][c]) - int(b.pixels[n][c])) > by;
    }
    count += differs;
  }
  return count;
}

}  // namespace bozzetto::test
