// Grey pictures: from PNG files, and text drawn with a font.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace bozzetto {

/// Rows from the top; 0 black … 1 white.
struct GreyImage {
  int width = 0, height = 0;
  std::vector<float> grey;

  float at(int x, int y) const {
    return grey[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x)];
  }
};

/// A PNG of any kind, 8 or 16 bits: luminance × opacity. At most 4096 pixels a side and 256 MiB of
/// file; nothing is allocated before the header is checked. Throws Error naming the file.
GreyImage readGreyPng(const std::filesystem::path& path);

struct TextOptions {
  /// A TrueType or OpenType file; empty: the first of the packaged ones that is there
  /// (fontFiles()).
  std::filesystem::path font;
  int pixels = 128;  ///< height of a capital letter with its room, 8…1024
};

/// Pixels from the outline of a letter to white inside it and to black outside.
inline constexpr int kTextReach = 32;

/// The text in one line (UTF-8, at most 256 characters, no control characters) as distances to its
/// outline: ½ there, growing inward, by 1/(2·kTextReach) a pixel. Throws Error for fonts that
/// cannot be read and characters they do not have.
GreyImage drawText(const std::string& text, const TextOptions& options = {});

/// Where packaged fonts are looked for, in this order: $BOZZETTO_FONT, then DejaVu Sans Bold
/// (Debian's fonts-dejavu-core), FreeSans Bold, Liberation Sans Bold.
std::vector<std::filesystem::path> fontFiles();

}  // namespace bozzetto
