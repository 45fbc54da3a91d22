// The column of tools, with the colours in hand below.
#include <algorithm>
#include <cmath>

#include "ui/icons.hpp"
#include "ui/panels.hpp"
#include "ui/solid_icons.hpp"
#include "ui/widgets.hpp"

namespace bozzetto::ui {
namespace {

// What makes all of the column fit into a low window.
float theShrinking = 1;

constexpr std::array<ToolCell, 13> kCells{{
    {ActionKind::add, Command::toolAdd},
    {ActionKind::remove, Command::toolRemove},
    {ActionKind::erase, Command::toolErase},
    {ActionKind::smooth, Command::toolSmooth},
    {ActionKind::stamp, Command::toolStamp},
    {ActionKind::push, Command::toolPush, ToolCell::Starts::group},
    {ActionKind::grip, Command::toolGrip},
    {ActionKind::swell, Command::toolSwell},
    {ActionKind::paint, Command::toolPaint, ToolCell::Starts::group},
    {ActionKind::paintSoft, Command::toolPaintSoft},
    {ActionKind::hold, Command::toolHold, ToolCell::Starts::group},
    {ActionKind::stiffen, Command::toolStiffen},
    {ActionKind::soften, Command::toolSoften},
}};

void toolCell(Atelier& atelier, const ToolCell& cell, float left, float top) {
  const float side = toolPx(44);
  ImGui::SetCursorScreenPos({left, top});
  ImGui::PushID(int(cell.action));
  if (hotArea("tool", {side, side})) atelier.setTool(cell.action);
  const bool hovered = ImGui::IsItemHovered();
  const bool chosen = atelier.sculpt.action == cell.action && !atelier.sculpt.recall;
  // What a held key makes of the tool lights up too.
  const bool meant = !chosen && atelier.actionNow() == cell.action;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 low{left, top}, high{left + side, top + side};
  if (chosen) {
    list->AddRectFilled(low, high, ink(hovered ? tint::accentHover : tint::accent), px(9));
  } else if (hovered || meant) {
    list->AddRectFilled(low, high, ink(tint::hover), px(9));
  }
  drawIcon(
      list, rowOf(cell.action).icon, {{left + side / 2, top + side / 2}, toolPx(12.5f)},
      {chosen ? ink(0xFFFFFF) : ink(tint::icon), chosen ? ink(tint::onAccent) : ink(tint::accent)});
  tooltip(atelier.keymap, cell.command);
  ImGui::PopID();
}

// Opens the drawer.
void shelfCell(Atelier& atelier, float left, float top) {
  const float side = toolPx(44);
  ImGui::SetCursorScreenPos({left, top});
  if (hotArea("shelf", {side, side})) atelier.run(Command::shelf);
  const bool lit = ImGui::IsItemHovered() || atelier.shelf.open;
  ImDrawList* list = ImGui::GetWindowDrawList();
  if (lit) list->AddRectFilled({left, top}, {left + side, top + side}, ink(tint::hover), px(9));
  drawIcon(list, Icon::shelf, {{left + side / 2, top + side / 2}, toolPx(12.5f)},
           {ink(tint::icon), ink(tint::accent)});
  tooltip(atelier.keymap, Command::shelf);
}

void modeCell(Atelier& atelier, float left, float top) {
  const float side = toolPx(44);
  ImGui::SetCursorScreenPos({left, top});
  if (hotArea("mode", {side, side})) atelier.run(Command::solidMode);
  const bool lit = ImGui::IsItemHovered() || atelier.mode() == WorkMode::solid;
  ImDrawList* list = ImGui::GetWindowDrawList();
  if (lit) list->AddRectFilled({left, top}, {left + side, top + side}, ink(tint::hover), px(9));
  drawSolidMode(list, {{left + side / 2, top + side / 2}, toolPx(12.5f)},
                {ink(tint::icon), ink(tint::accent)});
  tooltip(atelier.keymap, Command::solidMode);
}

void separator(const Rect& at, float& y) {
  ImGui::GetWindowDrawList()->AddLine({float(at.low.x) + px(18), y + px(3)},
                                      {float(at.high.x) - px(18), y + px(3)}, ink(0xFFFFFF, .08f));
  y += toolPx(9);
}

void colourBalls(Atelier& atelier, const Rect& at) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float x = float(at.centre().x), y = float(at.high.y) - px(32);
  ImGui::SetCursorScreenPos({x - px(19), y - px(19)});
  if (hotArea("colours", {px(42), px(42)})) atelier.run(Command::swapColours);
  tooltip(atelier.keymap, Command::swapColours);
  list->AddCircleFilled({x, y}, px(17), ink(atelier.sculpt.colour), 40);
  list->AddCircle({x, y}, px(19.5f), ink(0xFFFFFF, .22f), 40, px(1.5f));
  list->AddCircleFilled({x + px(14), y + px(14)}, px(8), ink(tint::panel), 24);
  list->AddCircleFilled({x + px(14), y + px(14)}, px(6), ink(atelier.sculpt.second), 24);
}

// How far all of the column shrinks, but for the colours in hand.
float shrinking(WorkMode mode, float height) {
  constexpr float kEnds = 18, kLines = 4 * 9, kColours = 62;
  const bool clay = mode == WorkMode::clay;
  const auto cells = float(clay ? kCells.size() + 2 : kSolidToolCount + 1);
  const float room = height - px(kEnds + (clay ? kColours : 0));
  return std::min(1.f, room / px(kLines + cells * 48));
}

}  // namespace

float toolPx(float at1) { return std::floor(px(at1) * theShrinking); }

std::span<const ToolCell> toolCells() { return kCells; }

void drawToolColumn(const PanelContext& context) {
  const Rect& at = context.layout.tools;
  Atelier& atelier = context.atelier;
  ImGui::SetNextWindowPos({float(at.low.x), float(at.low.y)});
  ImGui::SetNextWindowSize({float(at.width()), float(at.height())});
  ImGui::Begin("tools", nullptr, kFixed | ImGuiWindowFlags_NoScrollWithMouse);
  theShrinking = shrinking(atelier.mode(), float(at.height()));
  float y = float(at.low.y) + px(10);
  const float left = std::floor(float(at.centre().x) - toolPx(44) / 2);
  if (atelier.mode() == WorkMode::solid) {
    solidTools(atelier, left, y);
  } else {
    for (const ToolCell& cell : kCells) {
      if (cell.starts == ToolCell::Starts::group) separator(at, y);
      toolCell(atelier, cell, left, y);
      y += toolPx(48);
    }
  }
  separator(at, y);
  modeCell(atelier, left, y);
  y += toolPx(48);
  if (atelier.mode() == WorkMode::clay) {
    shelfCell(atelier, left, y);
    colourBalls(atelier, at);
  }
  ImGui::End();
}

}  // namespace bozzetto::ui
