// The panels, one file each. They read and change the atelier and draw with ImGui; no OpenGL.
#pragma once
#include <imgui.h>

#include <array>
#include <map>

#include "ui/atelier.hpp"
#include "ui/layout.hpp"
#include "ui/theme.hpp"

namespace bozzetto::ui {

/// A look as a card shows it.
struct LookCard {
  const char* name;
  Mode mode;
  Matcap matcap;
  const char* tip;
};
inline constexpr std::array<LookCard, 9> kLookCards{{
    {"Clay", Mode::clay, Matcap::wax, "Matt wet clay: no environment"},
    {"Glaze", Mode::glaze, Matcap::wax, "Clear coat: the environment, by angle"},
    {"Chrome", Mode::metal, Matcap::wax, "The environment alone"},
    {"Plastic", Mode::plastic, Matcap::wax, "A layer of paint: the environment, half transparent"},
    {"Glass", Mode::glass, Matcap::wax, "See-through"},
    {"Wax", Mode::matcap, Matcap::wax, "A painted ball of wax"},
    {"Jade", Mode::matcap, Matcap::jade, "A painted ball of jade"},
    {"Plaster", Mode::matcap, Matcap::plaster, "A painted ball of plaster"},
    {"Pewter", Mode::matcap, Matcap::pewter, "A painted ball of pewter"},
}};
bool isShown(const LookCard& card, const Look& look);

/// Pictures that whoever draws has made; 0 where there is none.
struct UiPictures {
  std::array<ImTextureID, kLookCards.size()> balls{};
  std::map<StepNumber, ImTextureID> steps;
  std::map<std::filesystem::path, ImTextureID> left;  ///< of work that was left behind
  ImTextureID document = nullptr;                     ///< of recovered work
  std::map<std::uint64_t, ImTextureID> tools;         ///< by ShelfCard::pictureId
};

/// What the frame before took.
struct FrameFigures {
  double milliseconds = 0, framesPerSecond = 0;
  FrameReport viewport;
  std::size_t uploadedPatches = 0;
};

struct PanelContext {
  Atelier& atelier;
  const Layout& layout;
  const UiPictures& pictures;
  const FrameFigures& figures;
};

/// Null where there is none yet.
ImTextureID pictureOf(const PanelContext& context, StepNumber step);

/// A tool of the column.
struct ToolCell {
  enum class Starts { nothing, group };
  ActionKind action;
  Command command;
  Starts starts = Starts::nothing;
};
/// In the column's order.
std::span<const ToolCell> toolCells();
/// Pixels of the column, less than px() where the window is low.
float toolPx(float at1);

void drawTopBar(const PanelContext& context);
void drawToolColumn(const PanelContext& context);
void drawShelf(const PanelContext& context);
void drawProperties(const PanelContext& context);
void drawStatusLine(const PanelContext& context);
void drawViewportMarks(const PanelContext& context);
void drawAxisBall(const PanelContext& context);
void drawHistoryStrip(const PanelContext& context);
void drawHistoryPanel(const PanelContext& context);
void drawRecovery(const PanelContext& context);
void drawMessages(const PanelContext& context);
void drawDialogs(const PanelContext& context);
void drawProgress(const PanelContext& context);
void drawHelp(const PanelContext& context);
void drawPalette(const PanelContext& context);

// Sections of the properties panel.
void standSection(Atelier& atelier);
void toolSection(Atelier& atelier);
void shapeSection(Atelier& atelier);
void lookSection(Atelier& atelier, const UiPictures& pictures);
void colourSection(Atelier& atelier);
void stampSection(Atelier& atelier);
void placementSection(Atelier& atelier);
void movingSection(Atelier& atelier);
void ledgerSection(Atelier& atelier);
void holdSection(Atelier& atelier);
void supportSection(Atelier& atelier);
/// The column's tools in solid mode; `top` moves down.
void solidTools(Atelier& atelier, float left, float& top);
void solidSections(Atelier& atelier);
void drawSolidPoints(const PanelContext& context);
void drawSupportKnobs(const PanelContext& context);
void strokeSection(Atelier& atelier);
void symmetrySection(Atelier& atelier);
void lightSection(Atelier& atelier);
void viewSection(Atelier& atelier);
void referenceSection(Atelier& atelier);
void claySection(Atelier& atelier);
void performanceSection(Atelier& atelier, const FrameFigures& figures);

/// Runs and shows a command as a menu's line.
void menuLine(Atelier& atelier, Command command);

}  // namespace bozzetto::ui
