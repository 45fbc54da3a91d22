#include "ui/widgets.hpp"

#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "ui/icons.hpp"
#include "ui/letters.hpp"

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

// The knob's area and the field that stands in for it are one item.
constexpr const char* kSlider = "##slider";

bool typed(const ImRect& box, double& value, const Slide& slide) {
  const ImGuiID id = ImGui::GetID(kSlider);
  double number = value * slide.typed;
  const std::string format = fmt::format("%.{}f", slide.digits);
  if (!ImGui::TempInputScalar(box, id, kSlider, ImGuiDataType_Double, &number, format.c_str())) {
    return false;
  }
  value = std::clamp(number / slide.typed, slide.low, slide.high);
  return true;
}

// A click that the field takes too: ImGui ends the program over any other.
bool wantsTyping(ImGuiID id, const ImRect& box) {
  const ImGuiIO& io = ImGui::GetIO();
  return io.KeyCtrl && ImGui::IsMouseClicked(0) && box.Contains(io.MousePos) &&
         ImGui::GetCurrentContext()->HoveredId == id;
}

}  // namespace

bool hotArea(const char* id, ImVec2 size) {
  return ImGui::InvisibleButton(id, {std::max(size.x, 1.f), std::max(size.y, 1.f)});
}

bool slider(const char* label, double& value, const Slide& slide, const char* tip) {
  ImGui::PushID(label);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = row();
  const ImGuiID id = ImGui::GetID(kSlider);
  const ImRect box(at, {at.x + width, at.y + px(29)});
  bool changed = false;
  if (ImGui::TempInputIsActive(id)) {
    changed = typed(box, value, slide);
    ImGui::PopID();
    return changed;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {px(8), px(8)});
  hotArea(kSlider, {width, px(33)});
  ImGui::PopStyleVar();
  const bool hovered = ImGui::IsItemHovered(), active = ImGui::IsItemActive();
  if (wantsTyping(id, box)) {
    changed = typed(box, value, slide);
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

bool turnSliders(glm::dquat& rotation, const char* tip) {
  glm::dvec3 angles = glm::degrees(glm::eulerAngles(rotation));
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(angles[axis]) < 1e-6) angles[axis] = 0;  // and no −0
  const char* names[] = {"Turn about x", "Turn about y", "Turn about z"};
  bool turned = false;
  for (int axis = 0; axis < 3; ++axis) {
    const double most = axis == 1 ? 90 : 180;
    turned |= slider(names[axis], angles[axis], {-most, most, "°", 1, 0}, tip);
  }
  if (turned) rotation = glm::normalize(glm::dquat(glm::radians(angles)));
  return turned;
}

bool toggle(const char* label, bool& on, const char* tip) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = row();
  const bool clicked = hotArea(label, {width, px(19)});
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
  if (hotArea(title, {width, px(19)})) {
    open = !open;
    storage->SetBool(id, open);
  }
  const bool hovered = ImGui::IsItemHovered();
  drawText(list, fonts().semiBold, at, ink(tint::strong), title);
  drawChevron(list, {at.x + width - px(5), at.y + px(9)}, open,
              ink(hovered ? tint::text : tint::faint));
  return open;
}

namespace {

int perRow(std::initializer_list<Choice> names, float width) {
  float widest = 0;
  for (const Choice& each : names) widest = std::max(widest, textWidth(fonts().medium, each.name));
  const int count = int(names.size());
  const int fit = std::clamp(int(width / (widest + px(8))), 1, count);
  const int rows = (count + fit - 1) / fit;
  return (count + rows - 1) / rows;
}

// True when it was chosen.
bool choiceCell(const Choice& choice, bool on, ImVec2 size, const char* tip) {
  const bool possible = *choice.whyNot == 0;
  const bool clicked = hotArea("cell", size) && possible;
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const bool hovered = possible && ImGui::IsItemHovered();
  ImDrawList* list = ImGui::GetWindowDrawList();
  if (on || hovered) {
    list->AddRectFilled({low.x + px(2), low.y + px(2)}, {high.x - px(2), high.y - px(2)},
                        on ? ink(0x3A3E45) : ink(tint::raised), px(5));
  }
  const float width = textWidth(fonts().medium, choice.name);
  drawText(list, fonts().medium,
           {(low.x + high.x - width) / 2, (low.y + high.y - fonts().medium->FontSize) / 2},
           possible ? ink(on ? tint::strong : tint::dim) : ink(tint::faint, .6f), choice.name);
  tooltip(possible ? tip : choice.whyNot);
  return clicked;
}

}  // namespace

bool choice(const char* label, int& chosen, std::initializer_list<Choice> names, const char* tip) {
  ImGui::PushID(label);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float width = row(), height = px(26);
  if (label[0] != '#') {
    drawText(list, fonts().regular, ImGui::GetCursorScreenPos(), ink(tint::text, .92f), label);
    ImGui::Dummy({width, px(14)});
  }
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const int count = int(names.size()), across = perRow(names, width);
  const float rows = float((count + across - 1) / across);
  list->AddRectFilled(at, {at.x + width, at.y + height * rows}, ink(tint::well), px(6));
  const int before = chosen;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  for (int n = 0; n < count; ++n) {
    if (n % across != 0) ImGui::SameLine(0, 0);
    ImGui::PushID(n);
    if (choiceCell(names.begin()[n], before == n, {width / float(across), height}, tip)) chosen = n;
    ImGui::PopID();
  }
  ImGui::PopStyleVar();
  ImGui::Dummy({width, 0});
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

namespace {

bool crossButton(ImVec2 middle) {
  const float r = px(12), d = px(5);
  ImGui::SetCursorScreenPos({middle.x - r, middle.y - r});
  const bool clicked = hotArea("close", {2 * r, 2 * r});
  const ImU32 colour = ink(ImGui::IsItemHovered() ? tint::text : tint::faint);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddLine({middle.x - d, middle.y - d}, {middle.x + d, middle.y + d}, colour, px(1.5f));
  list->AddLine({middle.x - d, middle.y + d}, {middle.x + d, middle.y - d}, colour, px(1.5f));
  return clicked;
}

}  // namespace

bool beginModal(const char* title, ImVec2 size, bool* open) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, 0, {.5f, .5f});
  ImGui::SetNextWindowSize(
      {std::min(size.x, screen.x - px(40)), std::min(size.y, screen.y - px(40))});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, px(10));
  ImGui::OpenPopup(title);
  const bool there =
      ImGui::BeginPopupModal(title, nullptr, kFixed & ~ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::PopStyleVar();
  if (!there) return false;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = row();
  drawText(ImGui::GetWindowDrawList(), fonts().semiBold, at, ink(tint::strong), title);
  if (open != nullptr && crossButton({at.x + width - px(6), at.y + px(9)})) *open = false;
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy({width, px(22)});
  return true;
}

bool swatch(const char* id, Colour colour, float side, bool chosen) {
  const bool clicked = hotArea(id, {side, side});
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
  ImGui::TextUnformatted(lettered(text));
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
