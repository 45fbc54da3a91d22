// Text drawn by FreeType, whose types stop here.
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_MODULE_H

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "bozzetto/base/error.hpp"
#include "bozzetto/base/text.hpp"
#include "bozzetto/io/grey_image.hpp"

namespace bozzetto {
namespace {

constexpr std::size_t kLongest = 256;

struct Font {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  explicit Font(const std::filesystem::path& path) {
    if (FT_Init_FreeType(&library) != 0) throw Error("text: FreeType does not start");
    FT_UInt reach = kTextReach;
    FT_Property_Set(library, "sdf", "spread", &reach);
    if (FT_New_Face(library, path.c_str(), 0, &face) != 0) {
      FT_Done_FreeType(library);
      throw Error("text: font " + path.string() + " cannot be read");
    }
  }
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;
  ~Font() {
    FT_Done_Face(face);
    FT_Done_FreeType(library);
  }
};

std::filesystem::path fontFor(const TextOptions& options) {
  if (!options.font.empty()) return options.font;
  const auto files = fontFiles();
  const auto there = std::ranges::find_if(files, [](const auto& file) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(file, ignored);
  });
  if (there == files.end()) {
    throw Error("text: no font found at " + files.back().string() +
                " and the like; the package fonts-dejavu-core, or a font by name, expected");
  }
  return *there;
}

// U+05E9
std::string named(char32_t character) {
  char text[16];
  std::snprintf(text, sizeof text, "U+%04X", unsigned(character));
  return text;
}

// The blocks of scripts that are, and of marks that turn lines round.
bool runsFromTheRight(char32_t c) {
  constexpr std::pair<char32_t, char32_t> kBlocks[] = {
      {0x590, 0x8ff},   {0x200f, 0x200f}, {0x202a, 0x202e},   {0x2066, 0x2069},
      {0xfb1d, 0xfdff}, {0xfe70, 0xfeff}, {0x10800, 0x10fff}, {0x1e800, 0x1efff}};
  return std::ranges::any_of(kBlocks, [&](const auto& b) { return c >= b.first && c <= b.second; });
}

std::vector<char32_t> charactersOf(const std::string& text) {
  std::vector<char32_t> characters;
  for (std::size_t at = 0; at < text.size();) {
    const auto character = nextCharacter(text, at);
    if (!character) {
      throw Error("text: no character at byte " + std::to_string(at) +
                  ", UTF-8 in one line expected");
    }
    if (runsFromTheRight(*character)) {
      throw Error("text: " + named(*character) +
                  " found, which runs from right to left, characters from left to right expected");
    }
    characters.push_back(*character);
  }
  if (characters.empty() || characters.size() > kLongest) {
    throw Error("text: " + std::to_string(characters.size()) + " characters, 1 to 256 expected");
  }
  return characters;
}

struct Glyph {
  GreyImage image;
  int left = 0, top = 0;  // of its picture, pixels from the pen, upward
};

Glyph render(Font& font, char32_t character) {
  const FT_UInt index = FT_Get_Char_Index(font.face, character);
  if (index == 0) throw Error("text: the font lacks the character " + named(character));
  const bool loaded = FT_Load_Glyph(font.face, index, FT_LOAD_NO_HINTING) == 0;
  const FT_GlyphSlot slot = font.face->glyph;
  const bool blank = loaded && slot->outline.n_contours == 0;  // of which no distance is known
  if (!loaded || (!blank && FT_Render_Glyph(slot, FT_RENDER_MODE_SDF) != 0)) {
    throw Error("text: the font's glyph cannot be drawn");
  }
  if (blank) return {};
  const FT_Bitmap& bitmap = slot->bitmap;
  Glyph glyph{{int(bitmap.width), int(bitmap.rows), {}}, slot->bitmap_left, slot->bitmap_top};
  for (unsigned y = 0; y < bitmap.rows; ++y)
    for (unsigned x = 0; x < bitmap.width; ++x) {
      const unsigned char* row = bitmap.buffer + static_cast<std::ptrdiff_t>(y) * bitmap.pitch;
      glyph.image.grey.push_back(static_cast<float>(row[x]) / 255.0f);
    }
  return glyph;
}

void paste(const GreyImage& from, int x0, int y0, GreyImage& to) {
  for (int y = 0; y < from.height; ++y)
    for (int x = 0; x < from.width; ++x) {
      const int tx = x0 + x, ty = y0 + y;
      if (tx < 0 || ty < 0 || tx >= to.width || ty >= to.height) continue;
      float& pixel = to.grey[static_cast<std::size_t>(ty) * static_cast<std::size_t>(to.width) +
                             static_cast<std::size_t>(tx)];
      pixel = std::max(pixel, from.at(x, y));
    }
}

}  // namespace

std::vector<std::filesystem::path> fontFiles() {
  std::vector<std::filesystem::path> files;
  if (const char* chosen = std::getenv("BOZZETTO_FONT")) files.emplace_back(chosen);
  const std::filesystem::path fonts("/usr/share/fonts/truetype");
  files.push_back(fonts / "freefont/FreeSansBold.ttf");
  files.push_back(fonts / "liberation/LiberationSans-Bold.ttf");
  files.insert(files.end() - 2, fonts / "dejavu/DejaVuSans-Bold.ttf");
  return files;
}

GreyImage drawText(const std::string& text, const TextOptions& options) {
  if (options.pixels < 8 || options.pixels > 1024) throw Error("text: pixels not in 8…1024");
  const std::vector<char32_t> characters = charactersOf(text);
  Font font(fontFor(options));
  if (FT_Set_Pixel_Sizes(font.face, 0, static_cast<FT_UInt>(options.pixels)) != 0) {
    throw Error("text: the font has no such size");
  }
  // Pictures of all glyphs where the pen meets them, then one picture that holds them.
  std::vector<std::pair<Glyph, int>> glyphs;
  long pen = 0;  // 1/64 pixels
  int low = 1 << 30, high = -low, top = -low, bottom = low;
  for (const char32_t character : characters) {
    Glyph glyph = render(font, character);
    const int x = static_cast<int>(pen >> 6) + glyph.left;
    pen += font.face->glyph->advance.x;
    if (glyph.image.grey.empty()) continue;  // a blank
    low = std::min(low, x);
    high = std::max(high, x + glyph.image.width);
    top = std::max(top, glyph.top);
    bottom = std::min(bottom, glyph.top - glyph.image.height);
    glyphs.emplace_back(std::move(glyph), x);
  }
  if (glyphs.empty()) throw Error("text: blanks only, something to see expected");
  const int margin = options.pixels / 16 + 1;
  GreyImage image{high - low + 2 * margin, top - bottom + 2 * margin, {}};
  image.grey.assign(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
                    0);
  for (const auto& [glyph, x] : glyphs)
    paste(glyph.image, x - low + margin, top - glyph.top + margin, image);
  return image;
}

}  // namespace bozzetto
