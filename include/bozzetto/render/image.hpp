// Pictures in memory.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bozzetto {

/// Width × height pixels of sRGB and opacity, 8 bits a channel, row by row from the top.
struct Image {
  using Pixel = std::array<std::uint8_t, 4>;

  int width = 0, height = 0;
  std::vector<Pixel> pixels;

  Image() = default;
  Image(int w, int h) : width(w), height(h), pixels(std::size_t(w) * std::size_t(h)) {}

  Pixel& at(int x, int y) { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
  const Pixel& at(int x, int y) const {
    return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  }
};

}  // namespace bozzetto
