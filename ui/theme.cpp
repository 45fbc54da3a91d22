#include "ui/theme.hpp"

#include <imgui_freetype.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "ui/letters.hpp"

namespace bozzetto::ui {
namespace {

Fonts theFonts;
float theScale = 1;
const ImWchar* theRanges = nullptr;

ImVec4 paint(unsigned hex, float alpha = 1) {
  return ImGui::ColorConvertU32ToFloat4(ink(hex, alpha));
}

// The first of the files that is there.
std::string firstFile(std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (std::filesystem::exists(name)) return name;
  return "";
}

// What it lacks comes from the other files; the atlas keeps pointers to their ranges.
ImFont* loadFace(const std::string& file, float size, const std::vector<FontFile>& others) {
  ImFontConfig config;
  config.OversampleH = config.OversampleV = 1;
  config.PixelSnapH = true;
  config.RasterizerMultiply = 1.08f;
  ImFontAtlas* atlas = ImGui::GetIO().Fonts;
  config.SizePixels = std::floor(size * theScale);
  if (file.empty()) return atlas->AddFontDefault(&config);
  ImFont* face = atlas->AddFontFromFileTTF(file.c_str(), config.SizePixels, &config, theRanges);
  face->FallbackChar = kPlaceholder;
  config.MergeMode = true;
  for (const FontFile& other : others) {
    config.FontNo = other.index;
    atlas->AddFontFromFileTTF(other.path.c_str(), config.SizePixels, &config, other.ranges.data());
  }
  return face;
}

#define BOZZETTO_INTER "/usr/share/fonts/opentype/inter/"
#define BOZZETTO_TTF "/usr/share/fonts/truetype/"

// Faces with the first of their files that is there.
void loadFaces(const std::vector<FontFile>& others) {
  ImFontAtlas* atlas = ImGui::GetIO().Fonts;
  atlas->Clear();
  atlas->FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  atlas->FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  const auto load = [&](std::initializer_list<const char*> files, float size) {
    return loadFace(firstFile(files), size, others);
  };
  theFonts.regular =
      load({BOZZETTO_INTER "Inter-Regular.otf", BOZZETTO_TTF "roboto/Roboto-Regular.ttf",
            BOZZETTO_TTF "dejavu/DejaVuSans.ttf"},
           15);
  theFonts.semiBold =
      load({BOZZETTO_INTER "Inter-SemiBold.otf", BOZZETTO_TTF "roboto/Roboto-Medium.ttf",
            BOZZETTO_TTF "dejavu/DejaVuSans-Bold.ttf"},
           14);
  theFonts.medium =
      load({BOZZETTO_INTER "Inter-Medium.otf", BOZZETTO_TTF "roboto/Roboto-Regular.ttf",
            BOZZETTO_TTF "dejavu/DejaVuSans.ttf"},
           12.5f);
  theFonts.display =
      load({BOZZETTO_INTER "InterDisplay-SemiBold.otf", BOZZETTO_INTER "Inter-SemiBold.otf",
            BOZZETTO_TTF "roboto/Roboto-Medium.ttf", BOZZETTO_TTF "dejavu/DejaVuSans-Bold.ttf"},
           18);
  ImGui::GetIO().FontDefault = theFonts.regular;
  atlas->Build();
}

// Other fonts are asked only for letters that ours lack.
void loadFonts() {
  static std::vector<FontFile> others;
  theRanges = lettersToBuild();
  loadFaces({});
  others = fontsWith(lettersMissing(*theFonts.regular));
  if (!others.empty()) loadFaces(others);
}

void setColours(ImVec4* colours) {
  // Forgotten ones show.
  for (int n = 0; n < ImGuiCol_COUNT; ++n) colours[n] = paint(0xFF00FF);
  const auto set = [&](std::initializer_list<int> which, unsigned hex, float alpha = 1) {
    for (const int n : which) colours[n] = paint(hex, alpha);
  };
  set({ImGuiCol_Text}, tint::text);
  set({ImGuiCol_TextDisabled}, tint::dim);
  set({ImGuiCol_WindowBg}, tint::panel);
  set({ImGuiCol_ChildBg, ImGuiCol_BorderShadow, ImGuiCol_ScrollbarBg, ImGuiCol_ResizeGrip,
       ImGuiCol_ResizeGripHovered, ImGuiCol_ResizeGripActive, ImGuiCol_Tab, ImGuiCol_TabUnfocused,
       ImGuiCol_TableRowBg},
      0, 0);
  set({ImGuiCol_PopupBg}, 0x222529, .98f);
  set({ImGuiCol_Border, ImGuiCol_Separator, ImGuiCol_TableBorderLight, ImGuiCol_TableBorderStrong},
      0xFFFFFF, .07f);
  set({ImGuiCol_FrameBg, ImGuiCol_TableHeaderBg}, tint::well);
  set({ImGuiCol_FrameBgHovered}, 0x1B1D21);
  set({ImGuiCol_FrameBgActive}, 0x202328);
  set({ImGuiCol_TitleBg, ImGuiCol_TitleBgActive, ImGuiCol_TitleBgCollapsed, ImGuiCol_MenuBarBg},
      tint::bar);
  set({ImGuiCol_ScrollbarGrab}, 0xFFFFFF, .10f);
  set({ImGuiCol_ScrollbarGrabHovered}, 0xFFFFFF, .18f);
  set({ImGuiCol_ScrollbarGrabActive}, 0xFFFFFF, .26f);
  set({ImGuiCol_CheckMark, ImGuiCol_SliderGrab, ImGuiCol_PlotLines, ImGuiCol_PlotHistogram,
       ImGuiCol_DragDropTarget},
      tint::accent);
  set({ImGuiCol_SliderGrabActive, ImGuiCol_PlotLinesHovered, ImGuiCol_PlotHistogramHovered},
      tint::accentHover);
  set({ImGuiCol_Button}, tint::raised);
  set({ImGuiCol_ButtonHovered}, tint::hover);
  set({ImGuiCol_ButtonActive}, 0x3D4249);
  set({ImGuiCol_Header}, tint::accent, .22f);
  set({ImGuiCol_HeaderHovered, ImGuiCol_TabHovered}, 0xFFFFFF, .07f);
  set({ImGuiCol_HeaderActive, ImGuiCol_TabActive, ImGuiCol_TabUnfocusedActive}, 0xFFFFFF, .10f);
  set({ImGuiCol_SeparatorHovered, ImGuiCol_SeparatorActive}, tint::accent, .8f);
  set({ImGuiCol_TableRowBgAlt}, 0xFFFFFF, .02f);
  set({ImGuiCol_TextSelectedBg}, tint::accent, .35f);
  set({ImGuiCol_NavHighlight, ImGuiCol_NavWindowingHighlight}, tint::second);
  set({ImGuiCol_NavWindowingDimBg, ImGuiCol_ModalWindowDimBg}, 0, .55f);
}

}  // namespace

const Fonts& fonts() { return theFonts; }
float scale() { return theScale; }

void useTheme(float wanted) {
  theScale = wanted;
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  style.WindowPadding = {14, 12};
  style.FramePadding = {8, 5};
  style.ItemSpacing = {8, 8};
  style.ItemInnerSpacing = {6, 4};
  style.WindowRounding = 0;
  style.ChildRounding = 8;
  style.FrameRounding = 5;
  style.PopupRounding = 8;
  style.GrabRounding = 4;
  style.ScrollbarRounding = 6;
  style.ScrollbarSize = 10;
  style.GrabMinSize = 10;
  style.WindowBorderSize = style.FrameBorderSize = style.ChildBorderSize = 0;
  style.PopupBorderSize = 1;
  style.AntiAliasedLinesUseTex = false;
  style.CircleTessellationMaxError = .15f;
  style.CurveTessellationTol = .6f;
  setColours(style.Colors);
  style.ScaleAllSizes(theScale);
  loadFonts();
}

void drawText(ImDrawList* list, ImFont* font, ImVec2 at, ImU32 colour, const std::string& text) {
  list->AddText(font, font->FontSize, {std::floor(at.x), std::floor(at.y)}, colour, lettered(text),
                text.data() + text.size());
}

float textWidth(ImFont* font, const std::string& text) {
  const char* end = text.data() + text.size();
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, lettered(text), end).x;
}

std::string fitted(ImFont* font, std::string text, float width) {
  if (textWidth(font, text) <= width) return text;
  // Whole characters: UTF-8 goes on while the top bits are 10.
  const auto goesOn = [&] { return (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80; };
  while (!text.empty() && textWidth(font, text + "…") > width) {
    while (text.size() > 1 && goesOn()) text.pop_back();
    text.pop_back();
  }
  return text + "…";
}

}  // namespace bozzetto::ui
