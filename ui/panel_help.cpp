// All keys in one window, each of which can be changed there.
#include "ui/panels.hpp"
#include "ui/widgets.hpp"

namespace bozzetto::ui {
namespace {

struct MouseRow {
  const char* button;
  const char* blender;
  const char* zbrush;
};
constexpr MouseRow kMouse[] = {
    {"Left button", "the tool, on clay or in the air", "the tool on clay; orbit beside it"},
    {"Ctrl + left", "the tool's opposite", "holds clay, so that other tools leave it"},
    {"Alt + left", "orbit", "the tool's opposite"},
    {"Shift + left", "smooths", "smooths"},
    {"Right button", "size up and down, strength left and right",
     "orbit; with Alt pan, with Ctrl zoom"},
    {"Middle button", "orbit; with Shift pan, with Ctrl zoom",
     "orbit; with Shift pan, with Ctrl zoom"},
    {"Wheel", "zoom to the pointer; with Shift size, with Ctrl the depth in the air",
     "zoom to the pointer; with Shift size, with Ctrl the depth in the air"},
};

void mouseTable(KeyProfile profile) {
  for (const MouseRow& row : kMouse) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(row.button);
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, ink(tint::dim));
    ImGui::TextWrapped("%s", profile == KeyProfile::blender ? row.blender : row.zbrush);
    ImGui::PopStyleColor();
  }
}

void keyRow(Atelier& atelier, const CommandRow& row) {
  ImGui::TableNextRow();
  ImGui::PushID(int(row.command));
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(row.title.data(), row.title.data() + row.title.size());
  tooltip(std::string(row.tip));
  ImGui::TableNextColumn();
  const bool waits = atelier.rebinding == row.command;
  const std::string keys = toText(atelier.keymap.chords(row.command));
  const std::string text = waits ? "press a key, Esc: none" : keys.empty() ? "–" : keys;
  if (atelier.keymap.isChanged(row.command)) {
    ImGui::PushStyleColor(ImGuiCol_Text, ink(tint::second));
  } else {
    ImGui::PushStyleColor(ImGuiCol_Text, ink(waits ? tint::accentHover : tint::text));
  }
  if (ImGui::Selectable(text.c_str(), waits)) atelier.rebinding = row.command;
  ImGui::PopStyleColor();
  tooltip("Click, then press the new key.");
  ImGui::PopID();
}

void keyTables(Atelier& atelier) {
  CommandGroup group = CommandGroup::help;
  for (const CommandRow& row : commandTable()) {
    if (row.group != group) {
      group = row.group;
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::PushFont(fonts().semiBold);
      ImGui::PushStyleColor(ImGuiCol_Text, ink(tint::strong));
      const std::string_view name = toText(group);
      ImGui::TextUnformatted(name.data(), name.data() + name.size());
      ImGui::PopStyleColor();
      ImGui::PopFont();
      ImGui::TableNextColumn();
    }
    keyRow(atelier, row);
  }
}

}  // namespace

void drawHelp(const PanelContext& context) {
  Atelier& atelier = context.atelier;
  if (atelier.dialog != Dialog::help) return;
  bool open = true;
  if (!beginModal("Keys and help", {px(720), px(620)}, &open)) return;
  int profile = int(atelier.keymap.profile());
  if (choice("##profile", profile, {"Like Blender", "Like ZBrush"}, "Two sets of keys.")) {
    atelier.setProfile(KeyProfile(profile));
  }
  ImGui::BeginChild("keys", {0, -px(40)});
  if (ImGui::BeginTable("table", 2, ImGuiTableFlags_RowBg)) {
    mouseTable(atelier.keymap.profile());
    keyTables(atelier);
    ImGui::EndTable();
  }
  ImGui::EndChild();
  if (button("All keys as they were", {px(200), 0})) atelier.keymap.resetToDefaults();
  ImGui::SameLine(0, px(16));
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("Click a key to change it.");
  ImGui::SameLine(ImGui::GetWindowWidth() - px(134));
  const bool escape = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)) &&
                      !atelier.rebinding && !atelier.justRebound;
  atelier.justRebound = false;
  if (button("Close", {px(120), 0}, ButtonKind::accent) || escape || !open) {
    atelier.dialog = Dialog::none;
    atelier.rebinding.reset();
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace bozzetto::ui
