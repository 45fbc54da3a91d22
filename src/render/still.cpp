// Stills from a renderer: in parts when they are large, for two eyes when they are stereo.
#include <algorithm>
#include <functional>

#include "bozzetto/render/picture.hpp"

namespace bozzetto {
namespace {

constexpr int kPartSide = 4096;

void paste(const Image& part, const PixelRect& place, Image& whole) {
  const int top = whole.height - place.y - place.height;
  for (int y = 0; y < part.height; ++y) {
    std::copy_n(&part.at(0, y), part.width, &whole.at(place.x, top + y));
  }
}

std::vector<PixelRect> partsOf(const Shot& shot) {
  std::vector<PixelRect> parts;
  for (int y = 0; y < shot.height; y += kPartSide) {
    for (int x = 0; x < shot.width; x += kPartSide) {
      parts.push_back(
          {x, y, std::min(kPartSide, shot.width - x), std::min(kPartSide, shot.height - y)});
    }
  }
  return parts;
}

Image stillOfPart(Renderer& renderer, const Shot& shot, const Look& look, int slices,
                  const std::function<void(double)>& done) {
  renderer.restart();
  for (int n = 0; n < slices; ++n) {
    done(double(n) / slices);
    renderer.addSlice(shot, look);
  }
  return renderer.mean(shot);
}

// Each eye's picture squeezed to half its width.
Image sideBySide(const Image& left, const Image& right) {
  Image both(left.width, left.height);
  const int half = left.width / 2;
  for (int y = 0; y < both.height; ++y) {
    for (int x = 0; x < both.width; ++x) {
      const Image& eye = x < half ? left : right;
      const int from = std::min(2 * (x < half ? x : x - half), left.width - 2);
      const Image::Pixel &a = eye.at(from, y), &b = eye.at(from + 1, y);
      for (std::size_t c = 0; c < 4; ++c) both.at(x, y)[c] = std::uint8_t((a[c] + b[c] + 1) / 2);
    }
  }
  return both;
}

Image rowInterlaced(Image left, const Image& right) {
  for (int y = 1; y < left.height; y += 2) std::copy_n(&right.at(0, y), left.width, &left.at(0, y));
  return left;
}

// Red from the left eye's brightness rather than its red: terracotta then does not flicker between
// the eyes ("half-colour" anaglyph).
Image anaglyph(Image left, const Image& right) {
  for (std::size_t n = 0; n < left.pixels.size(); ++n) {
    const Image::Pixel &l = left.pixels[n], &r = right.pixels[n];
    const int red = (299 * l[0] + 587 * l[1] + 114 * l[2] + 500) / 1000;
    left.pixels[n] = {std::uint8_t(red), r[1], r[2], 255};
  }
  return left;
}

}  // namespace

Image still(Renderer& renderer, const Shot& shot, const Look& look, int slices,
            Progress& progress) {
  requireSize(shot);
  const std::vector<PixelRect> parts = partsOf(shot);
  Image whole(shot.width, shot.height);
  for (std::size_t n = 0; n < parts.size(); ++n) {
    Shot part = shot;
    part.part = parts[n];
    const auto done = [&](double share) {
      progress.step("picture", (double(n) + share) / double(parts.size()));
    };
    paste(stillOfPart(renderer, part, look, slices, done), parts[n], whole);
  }
  progress.step("picture", 1);
  return whole;
}

Image stereoStill(Renderer& renderer, const Shot& shot, const Look& look, const Stereo& stereo,
                  int slices, Progress& progress) {
  if (stereo.mode == StereoMode::off) return still(renderer, shot, look, slices, progress);
  Shot left = shot, right = shot;
  left.eye = eyeShift(shot.camera, stereo, Eye::left);
  right.eye = eyeShift(shot.camera, stereo, Eye::right);
  Image l = still(renderer, left, look, slices, progress);
  const Image r = still(renderer, right, look, slices, progress);
  switch (stereo.mode) {
    case StereoMode::rowInterlaced:
      return rowInterlaced(std::move(l), r);
    case StereoMode::anaglyph:
      return anaglyph(std::move(l), r);
    default:
      return sideBySide(l, r);
  }
}

}  // namespace bozzetto
