// What Space brings under the pointer: tools, size and strength, colours.
#include "ui/icons.hpp"
#include "ui/panels.hpp"
#include "ui/widgets.hpp"

namespace bozzetto::ui {
namespace {

void tools(Atelier& atelier) {
  const float gap = px(6), side = (ImGui::GetContentRegionAvail().x - 5 * gap) / 6;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  int n = 0;
  for (const ToolCell& cell : toolCells()) {
    const ToolRow& row = rowOf(cell.action);
    if (n++ % 6 != 0) ImGui::SameLine();
    ImGui::PushID(int(row.action));
    if (hotArea("tool", {side, side})) {
      atelier.setTool(row.action);
      atelier.paletteOpen = false;
    }
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const bool chosen = atelier.sculpt.action == row.action;
    ImDrawList* list = ImGui::GetWindowDrawList();
    if (chosen || ImGui::IsItemHovered()) {
      list->AddRectFilled(low, high, ink(chosen ? tint::accent : tint::hover), px(9));
    }
    drawIcon(list, row.icon, {{(low.x + high.x) / 2, (low.y + high.y) / 2}, px(12.5f)},
             {chosen ? ink(0xFFFFFF) : ink(tint::icon),
              chosen ? ink(tint::onAccent) : ink(tint::accent)});
    tooltip(atelier.keymap, cell.command);
    ImGui::PopID();
  }
  ImGui::PopStyleVar();
}

}  // namespace

void drawPalette(const PanelContext& context) {
  Atelier& atelier = context.atelier;
  if (!atelier.paletteOpen) return;
  const float width = px(290);
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float left = std::clamp(float(atelier.palettePlace.x) - width / 2, 0.f, size.x - width);
  const float top = std::clamp(float(atelier.palettePlace.y) - px(34), 0.f, size.y - px(330));
  ImGui::SetNextWindowPos({left, top});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, px(12));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ink(0x222529, .97f));
  // Over the panels.
  constexpr auto kFlags = kFixed & ~ImGuiWindowFlags_NoBringToFrontOnFocus;
  ImGui::Begin("palette", nullptr, kFlags | ImGuiWindowFlags_AlwaysAutoResize);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  tools(atelier);
  SculptState& sculpt = atelier.sculpt;
  const double cell = atelier.status().scale.spacing;
  slider("Size", sculpt.size, {kSmallestToolCells * cell, 128 * cell, "mm", 1, 1, true},
         "The tool's limit of influence.");
  if (rowOf(sculpt.action).usesStrength) {
    const Strengths says = strengthsOf(sculpt.action);
    slider(says.name.data(), sculpt.strengthOf(sculpt.action), {0.01, 1, "%", 100, 0},
           says.what.data());
  }
  const float gap = px(6), side = (ImGui::GetContentRegionAvail().x - 6 * gap) / 7;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  int n = 0;
  for (const Colour colour : clayColours()) {
    if (n % 7 != 0) ImGui::SameLine();
    ImGui::PushID(n++);
    if (swatch("swatch", colour, side, colour == sculpt.colour)) {
      sculpt.colour = colour;
      atelier.paletteOpen = false;
    }
    ImGui::PopID();
  }
  ImGui::PopStyleVar();
  const bool outside = ImGui::IsMouseClicked(0) &&
                       !ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  if (outside || ImGui::IsMouseClicked(1)) atelier.paletteOpen = false;
  ImGui::End();
}

}  // namespace bozzetto::ui
