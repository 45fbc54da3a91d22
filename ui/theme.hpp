// Colours, fonts and measures of the window (look.md of the design, §7 and §8), in one place.
#pragma once
#include <imgui.h>

#include <string>

#include "bozzetto/base/colour.hpp"

namespace bozzetto::ui {

/// 0xRRGGBB and an opacity as ImGui packs colours.
constexpr ImU32 ink(unsigned hex, float alpha = 1) {
  return IM_COL32(hex >> 16 & 255, hex >> 8 & 255, hex & 255, int(alpha * 255 + .5f));
}
inline ImU32 ink(Colour c, float alpha = 1) { return IM_COL32(c.r, c.g, c.b, int(alpha * 255)); }

namespace tint {
inline constexpr unsigned bar = 0x18191C, panel = 0x1E2023, well = 0x15171A, card = 0x17191C,
                          raised = 0x282B30, hover = 0x33373D, text = 0xD9DBDE, strong = 0xF1F2F3,
                          dim = 0x8B9199, faint = 0x5C626A, accent = 0xE0764A,
                          accentHover = 0xF08A5D, onAccent = 0x4A1D0B, second = 0x5FB8C9,
                          ok = 0x7CC28A, axisX = 0xE36A5C, axisY = 0x8CC06A, axisZ = 0x5B9BE0,
                          seam = 0x0E0F11, knob = 0xF3E9E2, icon = 0xC3C7CC;
}

/// Sizes at scale 1.
namespace measure {
inline constexpr float topBar = 44, toolColumn = 60, properties = 288, status = 28;
}

/// The four faces, by use.
struct Fonts {
  ImFont* regular = nullptr;   ///< 15
  ImFont* semiBold = nullptr;  ///< 14, headings
  ImFont* medium = nullptr;    ///< 12.5, hints
  ImFont* display = nullptr;   ///< 18, titles
};

/// Of the current ImGui context; set by `useTheme`.
const Fonts& fonts();
/// Interface scale; multiplies every size.
float scale();
inline float px(float size) { return size * scale(); }

/// Style and fonts for a scale. Builds the font atlas; whoever draws uploads it anew.
void useTheme(float scale);

/// Text whose position is floored, in one of the faces.
void drawText(ImDrawList* list, ImFont* font, ImVec2 at, ImU32 colour, const std::string& text);
float textWidth(ImFont* font, const std::string& text);
/// Cut at the end with "…" to fit `width`.
std::string fitted(ImFont* font, std::string text, float width);

}  // namespace bozzetto::ui
