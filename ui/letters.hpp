// Letters beyond Latin: noted where texts are shown, and looked for in the fonts that are
// installed, so that starting costs nothing for them.
#pragma once
#include <imgui.h>

#include <set>
#include <string>
#include <vector>

namespace bozzetto::ui {

/// Stands for every letter that no font has.
inline constexpr ImWchar kPlaceholder = 0x25A1;

/// Notes letters of a text that is shown; gives its characters.
const char* lettered(const std::string& text);
/// Letters were noted that the faces have not been built with.
bool lettersAreNew();

/// What the faces are built with from now on: Latin, and runs of 128 round letters that were noted.
/// Pairs as ImGui takes them; they stay where they are until the next call.
const ImWchar* lettersToBuild();
/// Of the letters that were noted, those a face lacks.
std::set<ImWchar> lettersMissing(const ImFont& face);

struct FontFile {
  std::string path;
  int index = 0;                ///< in a collection
  std::vector<ImWchar> ranges;  ///< what is to be taken from it; pairs, ends with 0
};
/// Installed fonts that have them, as few as that takes; what no font has is left out.
std::vector<FontFile> fontsWith(std::set<ImWchar> letters);

}  // namespace bozzetto::ui
