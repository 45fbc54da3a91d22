#include "ui/letters.hpp"

#include <fontconfig/fontconfig.h>
#include <imgui_internal.h>

#include <fstream>
#include <memory>

namespace bozzetto::ui {
namespace {

constexpr ImWchar kLatin[] = {0x20,   0x17F,  0x2010, 0x2027, 0x2190,       0x2193,
                              0x2212, 0x2212, 0x2248, 0x2248, kPlaceholder, kPlaceholder};
constexpr ImWchar kSingle = 0x3000;   // from here on letters are taken one by one
constexpr ImWchar kRun = 128;         // before, so many at a time: an alphabet
constexpr std::size_t kMost = 4'000;  // what a texture has room for

std::set<ImWchar> noted, built;
std::vector<ImWchar> ranges;

bool isLatin(unsigned letter) {
  for (std::size_t n = 0; n < std::size(kLatin); n += 2)
    if (letter >= kLatin[n] && letter <= kLatin[n + 1]) return true;
  return letter < 0x20;
}

struct Destroy {
  void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
  void operator()(FcFontSet* fonts) const { FcFontSetDestroy(fonts); }
  void operator()(FcCharSet* letters) const { FcCharSetDestroy(letters); }
};

// Installed fonts, the best for these letters first.
std::unique_ptr<FcFontSet, Destroy> sorted(const std::set<ImWchar>& letters) {
  const std::unique_ptr<FcCharSet, Destroy> wanted(FcCharSetCreate());
  for (const ImWchar letter : letters) FcCharSetAddChar(wanted.get(), letter);
  const std::unique_ptr<FcPattern, Destroy> pattern(FcPatternCreate());
  const auto* family = reinterpret_cast<const FcChar8*>("sans-serif");
  FcPatternAddString(pattern.get(), FC_FAMILY, family);
  FcPatternAddCharSet(pattern.get(), FC_CHARSET, wanted.get());
  FcPatternAddBool(pattern.get(), FC_SCALABLE, FcTrue);
  FcConfigSubstitute(nullptr, pattern.get(), FcMatchPattern);
  FcDefaultSubstitute(pattern.get());
  FcResult result = FcResultMatch;
  return std::unique_ptr<FcFontSet, Destroy>(
      FcFontSort(nullptr, pattern.get(), FcTrue, nullptr, &result));
}

// Moves what the font has of the letters to its ranges.
FontFile take(FcPattern* font, std::set<ImWchar>& letters) {
  FontFile found;
  FcChar8* path = nullptr;
  FcCharSet* has = nullptr;
  FcBool coloured = FcFalse, outlines = FcFalse;
  FcPatternGetBool(font, FC_COLOR, 0, &coloured);
  FcPatternGetBool(font, FC_OUTLINE, 0, &outlines);
  if (coloured || !outlines || FcPatternGetString(font, FC_FILE, 0, &path) != FcResultMatch ||
      FcPatternGetCharSet(font, FC_CHARSET, 0, &has) != FcResultMatch)
    return found;
  found.path = reinterpret_cast<const char*>(path);
  if (!std::ifstream(found.path)) return found;
  FcPatternGetInteger(font, FC_INDEX, 0, &found.index);
  found.index &= 0xFFFF;  // above are instances of variable fonts
  std::erase_if(letters, [&](ImWchar letter) {
    if (!FcCharSetHasChar(has, letter)) return false;
    found.ranges.insert(found.ranges.end(), 2, letter);
    return true;
  });
  return found;
}

}  // namespace

const char* lettered(const std::string& text) {
  const char *at = text.data(), *end = at + text.size();
  while (at < end) {
    unsigned letter = static_cast<unsigned char>(*at);
    if (letter < 0x80) {
      ++at;
      continue;
    }
    at += ImTextCharFromUtf8(&letter, at, end);
    if (!isLatin(letter) && letter < 0xFFFF && noted.size() < kMost) noted.insert(ImWchar(letter));
  }
  return text.c_str();
}

bool lettersAreNew() { return noted.size() != built.size(); }

const ImWchar* lettersToBuild() {
  built = noted;
  ranges.assign(std::begin(kLatin), std::end(kLatin));
  ImWchar last = 0;
  for (const ImWchar letter : built) {
    const bool single = letter >= kSingle;
    const auto first = ImWchar(single ? letter : letter & ~(kRun - 1));
    if (first == last) continue;
    ranges.insert(ranges.end(), {first, ImWchar(single ? first : first + kRun - 1)});
    last = first;
  }
  ranges.push_back(0);
  return ranges.data();
}

std::set<ImWchar> lettersMissing(const ImFont& face) {
  std::set<ImWchar> missing = built;
  std::erase_if(missing,
                [&](ImWchar letter) { return face.FindGlyphNoFallback(letter) != nullptr; });
  return missing;
}

std::vector<FontFile> fontsWith(std::set<ImWchar> letters) {
  std::vector<FontFile> files;
  if (letters.empty()) return files;
  const auto fonts = sorted(letters);
  for (int n = 0; fonts && n < fonts->nfont && !letters.empty(); ++n) {
    FontFile file = take(fonts->fonts[n], letters);
    if (file.ranges.empty()) continue;
    file.ranges.push_back(0);
    files.push_back(std::move(file));
  }
  return files;
}

}  // namespace bozzetto::ui
