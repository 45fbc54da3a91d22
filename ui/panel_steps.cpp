// The history as a tree: every step with its picture, newest on top. Go to one, compare it with
// the clay now, or let the tool bring it back where it touches.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "ui/icons.hpp"
#include "ui/panels.hpp"
#include "ui/widgets.hpp"

namespace bozzetto::ui {
namespace {

constexpr float kRowHeight = 54, kLaneWidth = 13;
constexpr float kBelow = 90;  // the strip of steps and its margins
constexpr int kMostLanes = 6;

// Where each state of the tree stands: row 0 is the newest step, the last one the root.
struct Tree {
  std::map<StepNumber, int> row, lane;
  int lanes = 1;

  explicit Tree(const HistoryView& history) {
    const int count = int(history.steps.size());
    row[history.root] = count;
    lane[history.root] = 0;
    const auto mainChildren = mainChildrenOf(history);
    for (int n = 0; n < count; ++n) {
      const StepLine& step = history.steps[std::size_t(n)];
      row[step.number] = count - 1 - n;
      const bool goesOn = mainChildren.at(step.parent) == step.number;
      lane[step.number] = goesOn ? lane[step.parent] : std::min(lanes++, kMostLanes - 1);
    }
    lanes = std::min(lanes, kMostLanes);
  }

 private:
  // The child that goes straight on: the one on our line, else the first.
  static std::map<StepNumber, StepNumber> mainChildrenOf(const HistoryView& history) {
    std::map<StepNumber, StepNumber> children;
    for (const StepLine& step : history.steps) children.try_emplace(step.parent, step.number);
    for (const StepNumber number : history.line) {
      children[history.find(number)->parent] = number;
    }
    return children;
  }
};

std::string timeText(std::int64_t milliseconds) {
  const auto now = fmt::localtime(std::time(nullptr));
  const auto then = fmt::localtime(static_cast<std::time_t>(milliseconds / 1000));
  const bool today = now.tm_yday == then.tm_yday && now.tm_year == then.tm_year;
  return today ? fmt::format("{:%H:%M:%S}", then) : fmt::format("{:%d.%m. %H:%M}", then);
}

// What is drawn for one frame.
struct Panel {
  const PanelContext& context;
  const HistoryView& history;
  Tree tree;
  ImVec2 origin;  // of row 0, scrolled
  float width;

  ImVec2 node(StepNumber state) const {
    return {origin.x + px(12) + px(kLaneWidth) * float(tree.lane.at(state)),
            origin.y + px(kRowHeight) * (float(tree.row.at(state)) + .5f)};
  }
  bool isOnLine(StepNumber state) const {
    return state == history.root || std::ranges::find(history.line, state) != history.line.end();
  }
};

void drawEdges(const Panel& panel, ImDrawList* list) {
  for (const StepLine& step : panel.history.steps) {
    const ImVec2 from = panel.node(step.parent), to = panel.node(step.number);
    const ImU32 colour =
        panel.isOnLine(step.number) ? ink(tint::accent, .75f) : ink(0xFFFFFF, .20f);
    if (from.x == to.x) {
      list->AddLine(from, to, colour, px(1.6f));
      continue;
    }
    const float turn = from.y - px(kRowHeight) * .5f;
    list->PathLineTo(from);
    list->PathBezierCubicCurveTo({from.x, turn}, {to.x, from.y}, {to.x, turn - px(4)});
    list->PathLineTo(to);
    list->PathStroke(colour, 0, px(1.6f));
  }
}

void drawNode(const Panel& panel, ImDrawList* list, StepNumber state) {
  const ImVec2 at = panel.node(state);
  const bool here = panel.history.place == state;
  list->AddCircleFilled(at, px(here ? 6.f : 4.5f), ink(tint::bar), 24);
  list->AddCircleFilled(at, px(here ? 4.6f : 3.2f),
                        panel.isOnLine(state) ? ink(tint::accent) : ink(tint::faint), 24);
}

// A small round button at a row's end. True when clicked.
bool rowButton(const char* id, ImVec2 centre, const char* tip,
               void (*draw)(ImDrawList*, ImVec2, ImU32)) {
  const float r = px(13);
  ImGui::SetCursorScreenPos({centre.x - r, centre.y - r});
  const bool clicked = hotArea(id, {2 * r, 2 * r});
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList* list = ImGui::GetWindowDrawList();
  if (hovered) list->AddCircleFilled(centre, r, ink(0xFFFFFF, .10f), 24);
  draw(list, centre, ink(hovered ? 0xFFFFFF : tint::dim));
  tooltip(tip);
  return clicked;
}

void drawPicture(const Panel& panel, ImDrawList* list, const StepLine& step, ImVec2 low) {
  const ImVec2 high{low.x + px(58), low.y + px(46)};
  const float fade = panel.isOnLine(step.number) ? 1 : .6f;
  list->AddRectFilled(low, high, ink(0x26292E), px(5));
  if (const ImTextureID picture = pictureOf(panel.context, step.number)) {
    list->AddImageRounded(picture, low, high, {0, 1}, {1, 0}, ink(0xFFFFFF, fade), px(5));
  } else if (step.action) {
    const ImVec2 centre{(low.x + high.x) / 2, (low.y + high.y) / 2};
    for (const ToolRow& row : toolTable())
      if (row.action == *step.action)
        drawIcon(list, row.icon, {centre, px(10)}, {ink(tint::dim), ink(tint::accent, .7f)});
  }
}

void drawWords(const Panel& panel, ImDrawList* list, const StepLine& step, ImVec2 at) {
  const bool here = panel.history.place == step.number;
  const bool ours = panel.isOnLine(step.number);
  const float room = panel.origin.x + panel.width - at.x - px(6);
  drawText(list, here ? fonts().semiBold : fonts().regular, at,
           ink(here   ? tint::strong
               : ours ? tint::text
                      : tint::dim),
           fitted(fonts().regular, step.title, room));
  std::string facts = fmt::format("{}  ·  {}", step.number, timeText(step.time));
  const ImVec2 below{at.x, at.y + px(20)};
  drawText(list, fonts().medium, below, ink(ours ? tint::dim : tint::faint), facts);
  if (panel.history.saved != step.number) return;
  const float x = below.x + textWidth(fonts().medium, facts) + px(8);
  drawText(list, fonts().medium, {x, below.y}, ink(tint::ok), "in the file");
}

void drawRow(const Panel& panel, ImDrawList* list, const StepLine& step) {
  Atelier& atelier = panel.context.atelier;
  const float top = panel.origin.y + px(kRowHeight) * float(panel.tree.row.at(step.number));
  const float left = panel.origin.x + px(16) + px(kLaneWidth) * float(panel.tree.lanes);
  const float right = panel.origin.x + panel.width;
  ImGui::PushID(int(step.number));
  ImGui::SetCursorScreenPos({left, top});
  const bool here = panel.history.place == step.number;
  if (hotArea("row", {right - left, px(kRowHeight)})) atelier.goTo(step.number);
  ImGui::SetItemAllowOverlap();
  const bool hovered =
      ImGui::IsMouseHoveringRect({panel.origin.x, top}, {right, top + px(kRowHeight)}) &&
      ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  const bool recalled = atelier.sculpt.recall == step.number;
  if (here || hovered || recalled) {
    list->AddRectFilled({left, top + px(1)}, {right, top + px(kRowHeight - 1)},
                        here ? ink(tint::accent, .17f) : ink(0xFFFFFF, hovered ? .06f : .03f),
                        px(7));
  }
  drawPicture(panel, list, step, {left + px(4), top + px(4)});
  drawWords(panel, list, step, {left + px(71), top + px(9)});
  const float middle = top + px(kRowHeight) / 2;
  if (!here && (hovered || recalled)) {
    const auto back = [](ImDrawList* l, ImVec2 at, ImU32 colour) {
      drawTurn(l, at, Turn::undo, colour);
    };
    if (rowButton("recall", {right - px(16), middle},
                  "Bring back: strokes restore the clay of this step where they touch.", back)) {
      atelier.recallFrom(step.number);
    }
    if (rowButton("compare", {right - px(43), middle}, "Compare this step with the clay now.",
                  drawCompare)) {
      atelier.compareWith(step.number);
    }
  }
  if (recalled) list->AddCircle({right - px(16), middle}, px(13), ink(tint::accent), 24, px(1.5f));
  ImGui::PopID();
}

void drawRoot(const Panel& panel, ImDrawList* list) {
  const float top = panel.origin.y + px(kRowHeight) * float(panel.tree.row.at(panel.history.root));
  const float left = panel.origin.x + px(16) + px(kLaneWidth) * float(panel.tree.lanes);
  ImGui::SetCursorScreenPos({left, top});
  if (hotArea("root", {panel.origin.x + panel.width - left, px(kRowHeight)})) {
    panel.context.atelier.goTo(panel.history.root);
  }
  const bool here = panel.history.place == panel.history.root;
  const unsigned colour = here || ImGui::IsItemHovered() ? tint::strong : tint::dim;
  const float middle = top + px(kRowHeight) / 2 - fonts().regular->FontSize / 2;
  drawText(list, fonts().regular, {left + px(8), middle}, ink(colour), "Where it began");
  drawNode(panel, list, panel.history.root);
}

void drawSteps(const PanelContext& context, float height) {
  const HistoryView& history = *context.atelier.status().history;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::BeginChild("steps", {0, height});
  ImGui::PopStyleVar();
  ImDrawList* list = ImGui::GetWindowDrawList();
  const Panel panel{context, history, Tree(history), ImGui::GetCursorScreenPos(),
                    ImGui::GetContentRegionAvail().x - px(4)};
  drawEdges(panel, list);
  const float first = ImGui::GetScrollY() / px(kRowHeight) - 1;
  const float last = first + height / px(kRowHeight) + 2;
  for (const StepLine& step : history.steps) {
    const float row = float(panel.tree.row.at(step.number));
    if (row < first || row > last) continue;
    drawRow(panel, list, step);
    drawNode(panel, list, step.number);
  }
  drawRoot(panel, list);
  ImGui::SetCursorScreenPos(
      {panel.origin.x, panel.origin.y + px(kRowHeight) * float(history.steps.size() + 1)});
  ImGui::Dummy({1, 1});
  ImGui::EndChild();
}

std::string signedText(double value) {
  return fmt::format("{}{:.4g}", value < 0 ? "−" : "+", std::abs(value));
}

void comparisonFacts(const Comparison& comparison) {
  const FieldDifference& found = comparison.found;
  const double spacing = comparison.now.spacing;
  if (comparison.then.spacing != spacing) {
    factLine("Cell", fmt::format("{:.4g} → {:.4g} mm", comparison.then.spacing, spacing),
             "The grids differ; corners are compared by number.");
  }
  factLine("Corners that differ", grouped(found.corners), "In shape or colour.");
  factLine("In shape", grouped(found.reshaped));
  factLine("Blocks", grouped(found.blocks), "Of 8 × 8 × 8 corners.");
  factLine("Mass", signedText(found.massAfter - found.massBefore) + " mm³", "From then to now.");
  factLine("Volume", signedText(comparison.volumeNow - comparison.volumeThen) + " mm³",
           "Inside the surface, from then to now.");
  if (found.bounds.empty()) return;
  const Key size = found.bounds.high - found.bounds.low;
  factLine("Within", fmt::format("{:.3g} × {:.3g} × {:.3g} mm", size.i * spacing, size.j * spacing,
                                 size.k * spacing));
}

// What was compared, under the steps.
void drawComparison(Atelier& atelier) {
  const Comparison& comparison = *atelier.comparison;
  const std::string title = fmt::format("Step {} against now", comparison.step);
  ImGui::PushFont(fonts().semiBold);
  ImGui::TextUnformatted(title.c_str());
  ImGui::PopFont();
  comparisonFacts(comparison);
  const float half = (ImGui::GetContentRegionAvail().x - px(8)) / 2;
  button("Hold to see it", {half, 0}, ButtonKind::accent, "Shows the step while you press.");
  atelier.peek(ImGui::IsItemActive());
  ImGui::SameLine();
  if (button("Close", {half, 0})) atelier.comparison.reset();
}

void drawRecall(Atelier& atelier) {
  const std::string text = fmt::format("Strokes bring back step {}", *atelier.sculpt.recall);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text.c_str());
  ImGui::SameLine(ImGui::GetContentRegionAvail().x - px(46));
  if (button("Stop", {px(60), 0})) atelier.sculpt.recall.reset();
}

}  // namespace

void drawHistoryPanel(const PanelContext& context) {
  Atelier& atelier = context.atelier;
  if (!atelier.comparison) atelier.peek(false);
  if (!atelier.historyShown || !context.layout.panels) return;
  const Rect& at = context.layout.viewport;
  const float width = px(288), top = float(at.low.y) + px(112);
  const float steps = px(kRowHeight) * float(atelier.status().history->steps.size() + 1);
  const float footer =
      (atelier.comparison ? px(222) : 0.f) + (atelier.sculpt.recall ? px(38) : 0.f);
  const float room = float(at.high.y) - px(kBelow) - top;
  const float wanted = px(62) + steps + footer;
  ImGui::SetNextWindowPos({float(at.high.x) - width - px(14), top});
  ImGui::SetNextWindowSize({width, std::min(wanted, room)});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ink(0x1B1D20, .96f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, px(10));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::Begin("history tree", nullptr, kFixed | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor();
  ImGui::PushFont(fonts().semiBold);
  ImGui::TextUnformatted("History");
  ImGui::PopFont();
  ImGui::SameLine(ImGui::GetContentRegionAvail().x - px(50));
  if (button("Close", {px(64), px(24)})) atelier.historyShown = false;
  drawSteps(context, ImGui::GetContentRegionAvail().y - footer);
  if (atelier.sculpt.recall) drawRecall(atelier);
  if (atelier.comparison) drawComparison(atelier);
  ImGui::End();
}

}  // namespace bozzetto::ui
