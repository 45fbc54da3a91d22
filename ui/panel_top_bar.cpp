// Name, menus, document, symmetry and speed.
#include <fmt/format.h>

#include "ui/icons.hpp"
#include "ui/letters.hpp"
#include "ui/panels.hpp"
#include "ui/widgets.hpp"

namespace bozzetto::ui {
namespace {

void fileMenu(Atelier& atelier) {
  for (const Command c : {Command::newBall, Command::newBlock, Command::newEmpty}) {
    menuLine(atelier, c);
  }
  ImGui::Separator();
  menuLine(atelier, Command::open);
  if (ImGui::BeginMenu("Open recent", !atelier.settings.recent.empty())) {
    const auto recent = atelier.settings.recent;
    for (const std::string& path : recent) {
      if (ImGui::MenuItem(lettered(path))) {
        atelier.ifSaved([&atelier, path] { atelier.openScene(path); });
      }
    }
    ImGui::EndMenu();
  }
  menuLine(atelier, Command::save);
  menuLine(atelier, Command::saveAs);
  menuLine(atelier, Command::saveNumbered);
  ImGui::Separator();
  for (const Command c : {Command::importMesh, Command::exportMesh}) menuLine(atelier, c);
  ImGui::Separator();
  for (const Command c : {Command::screenshot, Command::screenshotWindow, Command::turntable}) {
    menuLine(atelier, c);
  }
  ImGui::Separator();
  for (const Command c : {Command::reference, Command::loadMatcap}) menuLine(atelier, c);
  ImGui::Separator();
  menuLine(atelier, Command::quit);
}

void editMenu(Atelier& atelier) {
  for (const Command c : {Command::undo, Command::redo, Command::undoView, Command::redoView}) {
    menuLine(atelier, c);
  }
  ImGui::Separator();
  for (const Command c : {Command::record, Command::replay}) menuLine(atelier, c);
}

void groupMenu(Atelier& atelier, CommandGroup group) {
  for (const CommandRow& row : commandTable())
    if (row.group == group) menuLine(atelier, row.command);
}

void toolsMenu(Atelier& atelier) {
  groupMenu(atelier, CommandGroup::tool);
  ImGui::Separator();
  groupMenu(atelier, CommandGroup::stroke);
  ImGui::Separator();
  groupMenu(atelier, CommandGroup::move);
}

void menus(Atelier& atelier) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(10), px(8)});
  const auto menu = [&](const char* name, auto fill) {
    if (!ImGui::BeginMenu(name)) return;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {px(8), px(5)});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {px(8), px(7)});
    fill();
    ImGui::PopStyleVar(2);
    ImGui::EndMenu();
  };
  menu("File", [&] { fileMenu(atelier); });
  menu("Edit", [&] { editMenu(atelier); });
  menu("View", [&] { groupMenu(atelier, CommandGroup::view); });
  menu("Tools", [&] { toolsMenu(atelier); });
  menu("Clay", [&] { groupMenu(atelier, CommandGroup::matter); });
  menu("Solid", [&] { groupMenu(atelier, CommandGroup::solid); });
  menu("Help", [&] { menuLine(atelier, Command::showHelp); });
  ImGui::PopStyleVar();
}

// A pill that ends at `right`; its left end.
float speedPill(const PanelContext& context, float right, float middle) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const double ms = context.figures.viewport.milliseconds;
  const Quality quality = context.figures.viewport.quality;
  const std::string text =
      fmt::format("{:.0f} ms  ·  {}", ms, context.atelier.options.quality ? "fixed" : "Auto");
  const float width = textWidth(fonts().medium, text) + px(38);
  const ImVec2 at{right - width, middle - px(13)};
  ImGui::SetCursorScreenPos(at);
  hotArea("speed", {width, px(26)});
  tooltip(fmt::format("The last frame took {:.1f} ms. Quality step {} of 4, chosen by itself.", ms,
                      int(quality)));
  list->AddRectFilled(at, {right, at.y + px(26)}, ink(tint::raised), px(13));
  list->AddCircleFilled({at.x + px(15), middle}, px(3.5f), ink(ms < 40 ? tint::ok : tint::accent));
  drawText(list, fonts().medium, {at.x + px(26), middle - fonts().medium->FontSize / 2},
           ink(tint::text, .85f), text);
  return at.x;
}

std::string mirrorText(const Symmetry& symmetry) {
  std::string axes;
  for (const Axis axis : kAxes)
    if (symmetry.mirror[std::size_t(index(axis))]) axes += "XYZ"[index(axis)];
  std::string text = "Mirror " + (axes.empty() ? "off" : axes);
  if (symmetry.radialCount > 1) text += fmt::format(" · {}×", symmetry.radialCount);
  return text;
}

float mirrorPill(Atelier& atelier, float right, float middle) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const Symmetry& symmetry = atelier.sculpt.symmetry;
  const bool on = symmetry.mirror != std::array<bool, 3>{} || symmetry.radialCount > 1;
  const std::string text = mirrorText(symmetry);
  const float width = textWidth(fonts().medium, text) + px(44);
  const ImVec2 at{right - width, middle - px(13)};
  ImGui::SetCursorScreenPos(at);
  if (hotArea("mirror", {width, px(26)})) atelier.run(Command::mirrorX);
  const bool hovered = ImGui::IsItemHovered();
  tooltip(atelier.keymap, Command::mirrorX);
  list->AddRectFilled(
      at, {right, at.y + px(26)},
      on ? ink(tint::second, hovered ? .3f : .2f) : ink(hovered ? tint::hover : tint::raised),
      px(13));
  const ImU32 sign = on ? ink(tint::second) : ink(tint::faint);
  drawMirror(list, {at.x + px(18), middle}, sign);
  drawText(list, fonts().medium, {at.x + px(34), middle - fonts().medium->FontSize / 2},
           on ? ink(0xA8E2EC) : ink(tint::dim), text);
  return at.x;
}

void documentName(const Atelier& atelier, float left, float right, float middle) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const std::string text = fitted(fonts().semiBold, atelier.title(), right - left - px(40));
  const float width = textWidth(fonts().semiBold, text);
  const float x = (left + right - width) / 2;
  drawText(list, fonts().semiBold, {x, middle - fonts().semiBold->FontSize / 2}, ink(tint::strong),
           text);
  if (atelier.isModified()) {
    list->AddCircleFilled({x + width + px(11), middle + px(1)}, px(3), ink(tint::accent));
  }
}

void wordMark(ImDrawList* list, ImTextureID ball, float middle) {
  if (ball) {
    list->AddImageRounded(ball, {px(11), middle - px(11)}, {px(33), middle + px(11)}, {0, 1},
                          {1, 0}, ~0u, px(11));
  } else {
    list->AddCircleFilled({px(22), middle}, px(10), ink(Colour{}), 32);
  }
  drawText(list, fonts().display, {px(44), middle - fonts().display->FontSize / 2 - .5f},
           ink(0xF4EFEA), "bozzetto");
}

}  // namespace

void menuLine(Atelier& atelier, Command command) {
  const CommandRow& row = rowOf(command);
  const std::string key = atelier.keymap.chordText(command);
  const std::string title(row.title);
  if (ImGui::MenuItem(title.c_str(), key.c_str(), atelier.isChecked(command),
                      atelier.isPossible(command))) {
    atelier.run(command);
  }
  tooltip(std::string(row.tip));
}

void drawTopBar(const PanelContext& context) {
  const Rect& at = context.layout.topBar;
  ImGui::SetNextWindowPos({float(at.low.x), float(at.low.y)});
  ImGui::SetNextWindowSize({float(at.width()), float(at.height())});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ink(tint::bar));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  // All of it is the menu bar, as high as the window.
  const float high = float(at.height());
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {px(4), (high - fonts().regular->FontSize) / 2});
  ImGui::Begin("top", nullptr, kFixed | ImGuiWindowFlags_MenuBar);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled({0, float(at.high.y) - 1}, {float(at.high.x), float(at.high.y)},
                      ink(tint::seam));
  const float middle = float(at.centre().y);
  if (ImGui::BeginMenuBar()) {
    wordMark(list, context.pictures.balls[0], middle);
    ImGui::SetCursorScreenPos({px(134), float(at.low.y)});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {px(20), px(8)});
    menus(context.atelier);
    ImGui::PopStyleVar();
    const float menusEnd = ImGui::GetItemRectMax().x;
    float left = speedPill(context, float(at.high.x) - px(14), middle);
    left = mirrorPill(context.atelier, left - px(8), middle);
    documentName(context.atelier, menusEnd, left, middle);
    ImGui::EndMenuBar();
  }
  ImGui::PopStyleVar(2);
  ImGui::End();
  ImGui::PopStyleColor();
}

}  // namespace bozzetto::ui
