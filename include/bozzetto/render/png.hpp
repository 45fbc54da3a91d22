// Pictures as PNG files and bytes.
#pragma once
#include <filesystem>
#include <span>

#include "bozzetto/base/bytes.hpp"
#include "bozzetto/render/image.hpp"

namespace bozzetto {

enum class PngEffort {
  small,  ///< as few bytes as can be
  quick,  ///< a tenth of the time, half as many bytes again
};

/// The image as a PNG file's bytes: RGB where every pixel is opaque, RGBA otherwise. The same
/// image gives the same bytes. About 0.5 s for 1280 × 960. Throws Error for an empty image.
Bytes encodePng(const Image& image, PngEffort effort = PngEffort::small);

/// The image in a PNG file's bytes, up to 16384 pixels a side. Throws Error for anything damaged;
/// `name` opens the text.
Image decodePng(std::span<const std::byte> bytes, std::string_view name = "PNG");

/// encodePng and decodePng with whole files; "-" and /dev/stdout write to standard output.
void writePng(const std::filesystem::path& path, const Image& image);
Image readPng(const std::filesystem::path& path);

}  // namespace bozzetto
