// The strip over the status line: undo, the last steps, redo, and the way to all of them.
#include <fmt/format.h>

#include <algorithm>

#include "ui/icons.hpp"
#include "ui/panels.hpp"
#include "ui/widgets.hpp"

namespace bozzetto::ui {
namespace {

bool arrow(Atelier& atelier, Command command, ImVec2 centre) {
  const float r = px(15);
  ImGui::SetCursorScreenPos({centre.x - r, centre.y - r});
  ImGui::PushID(int(command));
  const bool clicked = hotArea("arrow", {2 * r, 2 * r});
  const bool possible = atelier.isPossible(command);
  const unsigned colour = !possible ? tint::faint : ImGui::IsItemHovered() ? 0xFFFFFF : tint::text;
  drawTurn(ImGui::GetWindowDrawList(), centre, command == Command::undo ? Turn::undo : Turn::redo,
           ink(colour));
  tooltip(atelier.keymap, command);
  ImGui::PopID();
  if (clicked && possible) atelier.run(command);
  return clicked;
}

void treeButton(Atelier& atelier, ImVec2 centre) {
  const float r = px(14);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddLine({centre.x - r - px(5), centre.y - px(18)},
                {centre.x - r - px(5), centre.y + px(18)}, ink(0xFFFFFF, .08f));
  ImGui::SetCursorScreenPos({centre.x - r, centre.y - r});
  if (hotArea("tree", {2 * r, 2 * r})) atelier.run(Command::history);
  const bool lit = ImGui::IsItemHovered() || atelier.historyShown;
  tooltip(atelier.keymap, Command::history);
  drawTree(list, centre, ink(atelier.historyShown ? tint::accent : lit ? 0xFFFFFF : tint::text));
}

void stepCard(const PanelContext& context, std::size_t n, ImVec2 low, ImVec2 size) {
  Atelier& atelier = context.atelier;
  const HistoryView& history = *atelier.status().history;
  const bool current = n + 1 == history.done, ahead = n >= history.done;
  const StepLine step = *history.find(history.line[n]);
  const ImTextureID picture = pictureOf(context, step.number);
  ImDrawList* list = ImGui::GetWindowDrawList();
  ImGui::SetCursorScreenPos(low);
  ImGui::PushID(int(n));
  if (hotArea("step", size)) atelier.goTo(step.number);
  const bool hovered = ImGui::IsItemHovered();
  tooltip(fmt::format("{}. {}", step.number, step.title));
  ImGui::PopID();
  const ImVec2 high{low.x + size.x, low.y + size.y};
  list->AddRectFilled(low, high, ink(hovered ? tint::hover : 0x26292E, ahead ? .5f : 1), px(5));
  const float fade = ahead ? .32f : current ? 1.f : .82f;
  if (picture) {
    list->AddImageRounded(picture, low, high, {0, 1}, {1, 0}, ink(0xFFFFFF, fade), px(5));
  }
  if (current) {
    const float d = px(1.5f);
    list->AddRect({low.x - d, low.y - d}, {high.x + d, high.y + d}, ink(tint::accent), px(6), 0,
                  px(2));
  }
  const ImVec2 badge = picture ? ImVec2(low.x + px(11), high.y - px(11))
                               : ImVec2((low.x + high.x) / 2, (low.y + high.y) / 2);
  if (picture && step.action) list->AddCircleFilled(badge, px(8.5f), ink(0x17181B, .85f), 24);
  if (step.action) {
    drawIcon(list, rowOf(*step.action).icon, {badge, px(picture ? 5.2f : 10.f)},
             {ink(tint::text, fade), ink(tint::accent, fade)});
  } else if (!picture) {
    const std::string text = fitted(fonts().medium, step.title, size.x - px(8));
    drawText(list, fonts().medium,
             {(low.x + high.x - textWidth(fonts().medium, text)) / 2,
              (low.y + high.y - fonts().medium->FontSize) / 2},
             ink(tint::dim, fade), text);
  }
}

}  // namespace

ImTextureID pictureOf(const PanelContext& context, StepNumber step) {
  const auto found = context.pictures.steps.find(step);
  return found == context.pictures.steps.end() ? nullptr : found->second;
}

void drawHistoryStrip(const PanelContext& context) {
  Atelier& atelier = context.atelier;
  const HistoryView& history = *atelier.status().history;
  if (history.line.empty() || !context.layout.panels) return;
  const Rect& at = context.layout.viewport;
  const float cardW = px(58), cardH = px(46), gap = px(6), pad = px(8), arrows = px(43),
              tree = px(34);
  const int room = int((at.width() - 2 * (arrows + pad) - px(120)) / (cardW + gap));
  const int most = std::clamp(room, 1, 8);
  const int count = int(history.line.size()), shown = std::min(count, most);
  // The step we stand at is the last but one, where there are some ahead.
  const int first = std::clamp(int(history.done) - shown + 1, 0, count - shown);
  const float width = float(shown) * (cardW + gap) - gap + 2 * arrows + 2 * pad + tree;
  const float height = cardH + 2 * pad;
  const ImVec2 low{float(at.centre().x) - width / 2, float(at.high.y) - height - px(14)};
  ImGui::SetNextWindowPos(low);
  ImGui::SetNextWindowSize({width, height + px(3)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::Begin("history", nullptr, kFixed | ImGuiWindowFlags_NoBackground);
  ImGui::PopStyleVar();
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 high{low.x + width, low.y + height};
  list->AddRectFilled({low.x, low.y + px(2)}, {high.x, high.y + px(3)}, ink(0, .20f), px(11));
  list->AddRectFilled(low, high, ink(0x1B1D20, .93f), px(10));
  list->AddRect(low, high, ink(0xFFFFFF, .07f), px(10));
  const float middle = low.y + height / 2;
  arrow(atelier, Command::undo, {low.x + pad + px(15), middle});
  arrow(atelier, Command::redo, {high.x - pad - tree - px(15), middle});
  treeButton(atelier, {high.x - pad - px(14), middle});
  float x = low.x + pad + arrows;
  for (int n = first; n < first + shown && n < int(atelier.status().history->line.size()); ++n) {
    stepCard(context, std::size_t(n), {x, low.y + pad}, {cardW, cardH});
    x += cardW + gap;
  }
  ImGui::End();
}

}  // namespace bozzetto::ui
