#include "ui/widgets.hpp"

#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "ui/icons.hpp"

namespace bozzetto::ui {
namespace {

float row() { return ImGui::GetContentRegionAvail().x; }

double toPart(double value, const Slide& slide) {
  if (slide.logarithmic) return std::log(value / slide.low) / std::log(slide.high / slide.low);
  return (value - slide.low) / (slide.high - slide.low);
}

double fromPart(double part, const Slide& slide) {
  part = std::clamp(part, 0.0, 1.0);
  if (slide.logarithmic) return slide.low * std::pow(slide.high / slide.low, part);
  return slide.low + part * (slide.high - slide.low);
}

std::string valueText(double value, const Slide& slide) {
  const std::string number = fmt::format("{:.{}f}", value * slide.typed, slide.digits);
  const bool negative = number[0] == '-';
  return (negative ? "−" + number.substr(1) : number) +
         (*slide.unit && slide.unit != std::string_view("°") ? " " : "") + slide.unit;
}

// The knob follows the pointer; arrow keys move it when it has the keyboard's focus.
bool dragged(double& value, const Slide& slide, float left, float width) {
  const double before = value;
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActive() && ImGui::IsMouseDown(0) &&
      (ImGui::IsMouseClicked(0) || io.MouseDelta.x != 0)) {
    value = fromPart((io.MousePos.x - left) / width, slide);
  } else if (ImGui::IsItemFocused()) {
    const double step = io.KeyShift ? .002 : .02;
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_LeftArrow))) {
      value = fromPart(toPart(value, slide) - step, slide);
    }
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_RightArrow))) {
      value = fromPart(toPart(value, slide) + step, slide);
    }
  }
  return value != before;
}

bool typed(ImGuiID id, const ImRect& box, const char* label, double& value, const Slide& slide) {
  double number = value * slide.typed;
  const std::string format = fmt::format("%.{}f", slide.digits);
  if (!ImGui::TempInputScalar(box, id, label, ImGuiDataType_Double, &number, format.c_str())) {
    return false;
  }
  value = std::clamp(number / slide.typed, slide.low, slide.high);
  return true;
}

}  // namespace

bool slider(const char* label, double& value, const Slide& slide, const char* tip) {
  ImGui::PushID(label);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = row();
  const ImGuiID id = ImGui::GetID("slider");
  bool changed = false;
  if (ImGui::TempInputIsActive(id)) {
    changed = typed(id, ImRect(at, {at.x + width, at.y + px(29)}), label, value, slide);
    ImGui::PopID();
    return changed;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {px(8), px(8)});
  ImGui::InvisibleButton("slider", {width, px(33)});
  ImGui::PopStyleVar();
  const bool hovered = ImGui::IsItemHovered(), active = ImGui::IsItemActive();
  if (ImGui::IsItemActivated() && ImGui::GetIO().KeyCtrl) {
    changed = typed(id, ImRect(at, {at.x + width, at.y + px(29)}), label, value, slide);
  } else {
    changed = dragged(value, slide, at.x, width);
  }
  drawText(list, fonts().regular, at, ink(tint::text, .92f), label);
  if (slide.pen) {
    const float x = at.x + textWidth(fonts().regular, label) + px(9);
    drawPen(list, {x, at.y + px(4)}, ink(tint::second));
  }
  const std::string text = valueText(value, slide);
  drawText(list, fonts().regular, {at.x + width - textWidth(fonts().regular, text), at.y},
           ink(hovered || active ? tint::text : tint::dim), text);
  const float y = at.y + px(25);
  const float knob = at.x + width * float(std::clamp(toPart(value, slide), 0.0, 1.0));
  list->AddRectFilled({at.x, y - px(2)}, {at.x + width, y + px(2)}, ink(0x121316), px(2));
  list->AddRectFilled({at.x, y - px(2)}, {knob, y + px(2)},
                      ink(active ? tint::accentHover : tint::accent), px(2));
  list->AddCircleFilled({knob, y}, px(7), ink(tint::panel), 32);
  list->AddCircleFilled({knob, y}, px(hovered || active ? 5.8f : 5.2f), ink(tint::knob), 32);
  tooltip(tip);
  ImGui::PopID();
  return changed;
}

bool toggle(const char* label, bool& on, const char* tip) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = row();
  const bool clicked = ImGui::InvisibleButton(label, {width, px(19)});
  if (clicked) on = !on;
  drawText(list, fonts().regular, at, ink(tint::text, .92f), label);
  const ImVec2 box{at.x + width - px(28), at.y + px(1)};
  const bool hovered = ImGui::IsItemHovered();
  list->AddRectFilled(
      box, {box.x + px(28), box.y + px(16)},
      on ? ink(hovered ? tint::accentHover : tint::accent) : ink(hovered ? 0x454B53 : 0x3A3F46),
      px(8));
  list->AddCircleFilled({box.x + px(on ? 20 : 8), box.y + px(8)}, px(5.6f),
                        ink(0xFFFFFF, on ? 1 : .75f), 24);
  tooltip(tip);
  return clicked;
}

bool section(const char* title, bool openAtFirst) {
  ImGuiStorage* storage = ImGui::GetStateStorage();
  const ImGuiID id = ImGui::GetID(title);
  bool open = storage->GetBool(id, openAtFirst);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float left = ImGui::GetWindowPos().x, width = row();
  list->AddLine({left, start.y + px(3)}, {left + ImGui::GetWindowWidth(), start.y + px(3)},
                ink(0xFFFFFF, .055f));
  ImGui::Dummy({1, px(5)});
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton(title, {width, px(19)})) {
    open = !open;
    storage->SetBool(id, open);
  }
  const bool hovered = ImGui::IsItemHovered();
  drawText(list, fonts().semiBold, at, ink(tint::strong), title);
  drawChevron(list, {at.x + width - px(5), at.y + px(9)}, open,
              ink(hovered ? tint::text : tint::faint));
  return open;
}

bool choice(const char* id, int& chosen, std::initializer_list<const char*> names,
            const char* tip) {
  ImGui::PushID(id);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = row(), cell = width / float(names.size()), height = px(26);
  list->AddRectFilled(at, {at.x + width, at.y + height}, ink(tint::well), px(6));
  const int before = chosen;
  int n = 0;
  for (const char* name : names) {
    if (n > 0) ImGui::SameLine(0, 0);
    ImGui::PushID(n);
    if (ImGui::InvisibleButton("cell", {cell, height})) chosen = n;
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const bool on = chosen == n, hovered = ImGui::IsItemHovered();
    if (on || hovered) {
      list->AddRectFilled({low.x + px(2), low.y + px(2)}, {high.x - px(2), high.y - px(2)},
                          on ? ink(0x3A3E45) : ink(tint::raised), px(5));
    }
    const float w = textWidth(fonts().medium, name);
    drawText(list, fonts().medium,
             {(low.x + high.x - w) / 2, (low.y + high.y - fonts().medium->FontSize) / 2},
             ink(on ? tint::strong : tint::dim), name);
    tooltip(tip);
    ImGui::PopID();
    ++n;
  }
  ImGui::PopID();
  return chosen != before;
}

bool button(const char* label, ImVec2 size, ButtonKind kind, const char* tip) {
  const bool accent = kind == ButtonKind::accent;
  if (accent) {
    ImGui::PushStyleColor(ImGuiCol_Button, ink(tint::accent));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ink(tint::accentHover));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, ink(tint::accentHover));
    ImGui::PushStyleColor(ImGuiCol_Text, ink(0xFFFFFF));
  }
  const bool clicked = ImGui::Button(label, size);
  if (accent) ImGui::PopStyleColor(4);
  tooltip(tip);
  return clicked;
}

bool swatch(const char* id, Colour colour, float side, bool chosen) {
  const bool clicked = ImGui::InvisibleButton(id, {side, side});
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(low, high, ink(colour), px(6));
  const bool hovered = ImGui::IsItemHovered();
  if (chosen || hovered) {
    const float d = px(1.5f);
    list->AddRect({low.x - d, low.y - d}, {high.x + d, high.y + d},
                  ink(0xFFFFFF, chosen ? .9f : .35f), px(7), 0, px(1.6f));
  }
  tooltip(toText(colour));
  return clicked;
}

void factLine(const char* label, const std::string& value, const char* tip) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = row();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, px(4)});
  ImGui::Dummy({width, px(19)});
  ImGui::PopStyleVar();
  tooltip(tip);
  drawText(list, fonts().regular, at, ink(tint::text, .92f), label);
  drawText(list, fonts().regular, {at.x + width - textWidth(fonts().regular, value), at.y},
           ink(tint::dim), value);
}

void tooltip(const std::string& text) {
  if (text.empty() || !ImGui::IsItemHovered() || ImGui::IsMouseDown(0)) return;
  if (ImGui::GetCurrentContext()->HoveredIdTimer < .45f) return;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(10), px(7)});
  ImGui::BeginTooltip();
  ImGui::PushFont(fonts().medium);
  ImGui::PushTextWrapPos(px(260));
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

void tooltip(const Keymap& keymap, Command command) {
  const CommandRow& row = rowOf(command);
  const std::string key = keymap.chordText(command);
  tooltip(std::string(row.title) + (key.empty() ? "" : "  (" + key + ")") + "\n" +
          std::string(row.tip));
}

std::string grouped(long long number) {
  std::string digits = std::to_string(std::abs(number));
  for (int at = int(digits.size()) - 3; at > 0; at -= 3) digits.insert(std::size_t(at), " ");
  return (number < 0 ? "−" : "") + digits;
}

std::string byteText(double bytes) {
  constexpr const char* units[] = {"B", "kB", "MB", "GB", "TB"};
  int unit = 0;
  while (bytes >= 1000 && unit < 4) {
    bytes /= 1000;
    ++unit;
  }
  return fmt::format("{:.{}f} {}", bytes, bytes < 10 && unit > 0 ? 1 : 0, units[unit]);
}

}  // namespace bozzetto::ui
