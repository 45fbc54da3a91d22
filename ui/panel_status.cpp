// What every mouse button does now, with the keys that are held, and how the clay stands.
#include <fmt/format.h>

#include "ui/icons.hpp"
#include "ui/panels.hpp"
#include "ui/widgets.hpp"

namespace bozzetto::ui {
namespace {

struct Hint {
  std::string key;
  std::optional<MousePart> mouse;
  std::string verb;
};

std::string verb(ActionKind action) { return std::string(rowOf(action).verb); }

std::vector<Hint> draggingHints(Gesture gesture) {
  switch (gesture) {
    case Gesture::size:
      return {{"", {}, "Size: move the pointer"},
              {"", MousePart::left, "Take it"},
              {"Esc", {}, "As before"}};
    case Gesture::strength:
      return {{"", {}, "Strength: move the pointer"},
              {"", MousePart::left, "Take it"},
              {"Esc", {}, "As before"}};
    case Gesture::rotation:
      return {{"", {}, "Turn: move the pointer"},
              {"", MousePart::left, "Take it"},
              {"Esc", {}, "As before"}};
    case Gesture::pickColour:
      return {{"", MousePart::left, "Take this colour"}, {"Esc", {}, "Never mind"}};
    case Gesture::stroke:
      return {{"Esc", {}, "Take the stroke back"}};
    case Gesture::orbit:
      return {{"", {}, "Turning the view"}};
    case Gesture::pan:
      return {{"", {}, "Shifting the view"}};
    case Gesture::zoom:
      return {{"", {}, "Zooming"}};
    case Gesture::lasso:
      return {{"", {}, "Draw round the part"}, {"Esc", {}, "Never mind"}};
    case Gesture::solid:
      return {{"", {}, "Let go to do it"}, {"Esc", {}, "As before"}};
    case Gesture::support:
      return {{"Shift", {}, "Turn it"}, {"Ctrl", {}, "Nearer, farther"}, {"Esc", {}, "As before"}};
    case Gesture::reference:
      return {{"", {}, "Moving the picture"}};
    case Gesture::lightHandle:
    case Gesture::light:
      return {{"", {}, "Turning the light"}};
    default:
      return {};
  }
}

void addMiddle(const Atelier& atelier, Modifiers held, std::vector<Hint>& hints) {
  if (atelier.mouseMoves == Moves::light) {
    hints.push_back({"", MousePart::middle, "Turn light"});
    return;
  }
  const char* what = held.shift ? "Pan" : held.ctrl ? "Zoom" : "Orbit";
  hints.push_back({"", MousePart::middle, what});
  if (held.none()) hints.push_back({"Shift", MousePart::middle, "Pan"});
  const char* wheel = held.ctrl ? "Nearer, farther" : held.shift ? "Size" : "Zoom";
  hints.push_back({"", MousePart::wheel, wheel});
}

std::vector<Hint> solidHints(const Atelier& atelier) {
  const SolidToolRow& row = rowOf(atelier.solid.tool);
  std::vector<Hint> hints;
  if (!atelier.solidShown()) {
    hints.push_back({"", {}, "Make a block, a solid from the clay or a wrap"});
  } else {
    const bool held = atelier.curve().handle && atelier.curve().points.size() > 1;
    hints.push_back({"", MousePart::left, held ? "Drag the curve" : std::string(row.verb)});
    if (!atelier.curve().points.empty()) hints.push_back({"Esc", {}, "Let the curve go"});
    if (!row.inverse.empty()) {
      hints.push_back(
          {std::string(atelier.keymap.invertName()), MousePart::left, std::string(row.inverse)});
    }
  }
  addMiddle(atelier, atelier.held(), hints);
  return hints;
}

std::vector<Hint> restingHints(const Atelier& atelier) {
  const SculptState& sculpt = atelier.sculpt;
  const bool blender = atelier.keymap.profile() == KeyProfile::blender;
  const Modifiers held = atelier.held();
  std::vector<Hint> hints;
  if (atelier.followsStroke() && atelier.now() - atelier.lastInput() > 1) {
    hints.push_back({"Esc", {}, "Take the stroke back"});
  }
  if (atelier.movingReference) {
    return {{"", MousePart::left, "Move the picture"},
            {"Shift", MousePart::wheel, "Size"},
            {"Ctrl", MousePart::wheel, "Nearer, farther"},
            {"Esc", {}, "Leave it there"}};
  }
  if (atelier.mode() == WorkMode::solid) return solidHints(atelier);
  if (atelier.drawsLasso())
    return {{"", MousePart::left, "Draw round the part"}, {"Esc", {}, "Never mind"}};
  if (const auto how = atelier.combining()) {
    const char* verbs[] = {"Unite the tool here", "Subtract the tool here",
                           "Intersect with it here"};
    return {{"", MousePart::left, verbs[int(*how)]}, {"Esc", {}, "Never mind"}};
  }
  if (atelier.hoversLight()) {
    return {{"", MousePart::left, "Move this light; beyond the rim it goes behind the clay"}};
  }
  if (atelier.hoversSupport())
    return {{"", MousePart::left, "Move the support"},
            {"Shift", MousePart::left, "Turn it"},
            {"Ctrl", MousePart::left, "Nearer, farther"}};
  const bool turns = sculpt.emptyDrag == EmptyDrag::orbit && !atelier.hover().ground;
  if (blender && held.alt) {
    hints.push_back({"", MousePart::left, "Orbit"});
  } else {
    const bool recalls = sculpt.recall && atelier.actionNow() == sculpt.action;
    const std::string does =
        recalls ? fmt::format("Bring back step {}", *sculpt.recall) : verb(atelier.actionNow());
    hints.push_back({"", MousePart::left, turns ? "Orbit" : does});
  }
  if (held.none() && !blender) hints.push_back({"Ctrl", MousePart::left, verb(ActionKind::hold)});
  if (held.none()) {
    const ActionKind inverse = rowOf(sculpt.action).inverse;
    if (inverse != sculpt.action) {
      hints.push_back({std::string(atelier.keymap.invertName()), MousePart::left, verb(inverse)});
    }
    if (sculpt.action != ActionKind::smooth) {
      hints.push_back({"Shift", MousePart::left, "Smooth"});
    }
  }
  hints.push_back({"", MousePart::right, blender ? "Size · strength" : "Orbit"});
  addMiddle(atelier, held, hints);
  return hints;
}

float drawHint(ImDrawList* list, const Hint& hint, float x, float y) {
  ImFont* font = fonts().medium;
  if (!hint.key.empty()) {
    const float width = textWidth(font, hint.key) + px(12);
    list->AddRectFilled({x, y - px(9)}, {x + width, y + px(9)}, ink(0x2C2F34), px(4));
    drawText(list, font, {x + px(6), y - font->FontSize / 2}, ink(tint::text, .85f), hint.key);
    x += width + px(5);
  }
  if (hint.mouse) {
    drawMouse(list, {x, y - px(8)}, *hint.mouse, px(16));
    x += px(17);
  }
  drawText(list, font, {x, y - font->FontSize / 2}, ink(0xB4B9C0), hint.verb);
  return x + textWidth(font, hint.verb);
}

std::string savedText(const Atelier& atelier) {
  const Keeping& keeping = atelier.status().keeping;
  if (keeping.saving) return fmt::format("saving {:.0f} %", *keeping.saving * 100);
  if (keeping.readOnly) return "read-only: open elsewhere";
  if (!keeping.trouble.empty()) return "steps are not kept: " + keeping.trouble;
  if (!atelier.isModified() && !atelier.path().empty()) {
    if (atelier.savedAt() < 0) return "saved";
    const double ago = atelier.now() - atelier.savedAt();
    return ago < 60 ? fmt::format("saved {:.0f} s ago", ago)
                    : fmt::format("saved {:.0f} min ago", ago / 60);
  }
  if (!atelier.isModified()) return "";
  return keeping.kept ? "not saved, every step kept" : "not saved";
}

std::string factText(const Atelier& atelier, bool wide) {
  const ClayStatus& status = atelier.status();
  const auto triangles = (long long)atelier.patches().triangles();
  std::string text = wide || triangles < 1000 ? grouped(triangles) + " triangles"
                                              : fmt::format("{}k triangles", triangles / 1000);
  if (wide && status.last.op == "stroke") {
    const double dabs = double(std::max<std::int64_t>(status.last.dabs, 1));
    text +=
        fmt::format("   ·   dab {:.1f} ms", (status.last.msField + status.last.msSurface) / dabs);
  }
  const std::string saved = savedText(atelier);
  return saved.empty() ? text : text + "   ·   " + saved;
}

}  // namespace

void drawStatusLine(const PanelContext& context) {
  const Rect& at = context.layout.status;
  const Atelier& atelier = context.atelier;
  ImGui::SetNextWindowPos({float(at.low.x), float(at.low.y)});
  ImGui::SetNextWindowSize({float(at.width()), float(at.height())});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ink(tint::bar));
  ImGui::Begin("status", nullptr, kFixed | ImGuiWindowFlags_NoInputs);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float y = float(at.centre().y), gap = px(at.width() < px(1400) ? 16.f : 24.f);
  const std::string facts = factText(atelier, at.width() >= px(1400));
  const float end = float(at.high.x) - px(16) - textWidth(fonts().medium, facts);
  float x = px(16);
  const auto hints =
      atelier.gesture() == Gesture::none ? restingHints(atelier) : draggingHints(atelier.gesture());
  for (const Hint& hint : hints) {
    if (x + textWidth(fonts().medium, hint.verb) + px(70) > end) break;
    x = drawHint(list, hint, x, y) + gap;
  }
  drawText(list, fonts().medium, {end, y - fonts().medium->FontSize / 2}, ink(tint::dim), facts);
  list->AddLine({0, float(at.low.y)}, {float(at.high.x), float(at.low.y)}, ink(0xFFFFFF, .05f));
  ImGui::End();
  ImGui::PopStyleColor();
}

}  // namespace bozzetto::ui
