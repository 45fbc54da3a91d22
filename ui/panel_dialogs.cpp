// Dialogs: choosing files by keyboard or pointer, and what to do with unsaved work.
#include <imgui.h>
#include <imgui_stdlib.h>

#include "ui/file_browser.hpp"
#include "ui/letters.hpp"
#include "ui/panels.hpp"
#include "ui/widgets.hpp"

namespace bozzetto::ui {
namespace {

namespace fs = std::filesystem;

struct Purpose {
  Dialog dialog;
  const char* title;
  const char* verb;
  const char* ending;  ///< given to a name without one; "" when files are read
  std::vector<std::string> endings;
};

const std::vector<std::string> kVolumes{".bzt", ".png", ".obj", ".ply",
                                        ".stl", ".off", ".glb", ".jsonl"};

const std::vector<Purpose>& purposes() {
  static const std::vector<Purpose> all{
      {Dialog::open, "Open a scene", "Open", "", {".bzt"}},
      {Dialog::saveAs, "Save the scene", "Save", ".bzt", {".bzt"}},
      {Dialog::import, "Import a mesh", "Import", "", {".obj", ".ply", ".stl", ".off", ".glb"}},
      {Dialog::exportMesh,
       "Export a mesh",
       "Export",
       ".ply",
       {".obj", ".ply", ".stl", ".glb", ".iv"}},
      {Dialog::picture, "Picture of the clay", "Save", ".png", {".png"}},
      {Dialog::windowPicture, "Picture of the window", "Save", ".png", {".png"}},
      {Dialog::turntable, "Turntable", "Save", ".png", {".png"}},
      {Dialog::reference, "Reference picture", "Add", "", {".png"}},
      {Dialog::matcap, "Matcap from a picture", "Use", "", {".png"}},
      {Dialog::record, "Save the recording", "Save", ".jsonl", {".jsonl"}},
      {Dialog::replay, "Replay a recording", "Replay", "", {".jsonl"}},
      {Dialog::shareTool, "Save the tool", "Save", ".bzt", {".bzt"}},
      {Dialog::keepFile, "Put a file on the shelf", "Keep", "", kVolumes},
      {Dialog::combine, "Combine with a file", "Combine", "", kVolumes},
  };
  return all;
}

const Purpose* purposeOf(Dialog dialog) {
  for (const Purpose& purpose : purposes())
    if (purpose.dialog == dialog) return &purpose;
  return nullptr;
}

// The file dialog while it is open, and what was chosen beside the file.
struct FileDialog {
  Dialog open = Dialog::none;
  FileBrowser browser;
  std::string name;
  int chosen = -1;
  bool askedToReplace = false, focusName = false, focusVerb = false;
  int cells = 192, frames = 36, width = 1920, height = 1080;
  double keep = 1;
  Combining how = Combining::unite;
};

std::string suggestedName(const Atelier& atelier, const Purpose& purpose) {
  if (*purpose.ending == 0) return "";
  if (purpose.dialog == Dialog::saveAs && !atelier.path().empty()) {
    return atelier.path().filename().string();
  }
  if (purpose.dialog == Dialog::shareTool) return atelier.shelf.about.value().name + purpose.ending;
  return atelier.title() + purpose.ending;
}

void begin(FileDialog& state, const Atelier& atelier, const Purpose& purpose) {
  // What is written goes beside the scene, wherever something was read last.
  fs::path folder = atelier.settings.folder;
  const bool writes = *purpose.ending != 0;
  if ((writes || folder.empty()) && !atelier.path().empty()) {
    folder = fs::absolute(atelier.path()).parent_path();
  }
  state.open = purpose.dialog;
  state.browser.open(folder, purpose.endings);
  state.name = suggestedName(atelier, purpose);
  state.chosen = -1;
  state.askedToReplace = false;
  state.focusName = true;
}

void perform(Atelier& atelier, const FileDialog& state, const fs::path& path) {
  atelier.dialog = Dialog::none;
  atelier.settings.folder = path.parent_path().string();
  switch (state.open) {
    case Dialog::open:
      return atelier.openScene(path);
    case Dialog::saveAs:
      return atelier.saveScene(path);
    case Dialog::import:
      return atelier.importMesh(path, state.cells);
    case Dialog::exportMesh:
      return atelier.exportMesh(path, state.keep);
    case Dialog::picture:
      return atelier.takePicture({path, state.width, state.height, 16, 1});
    case Dialog::turntable:
      return atelier.takePicture({path, state.width, state.height, 8, state.frames});
    case Dialog::windowPicture:
      atelier.windowPicture = path;
      return;
    case Dialog::reference:
      return atelier.addReference(path);
    case Dialog::matcap:
      return atelier.loadMatcap(path);
    case Dialog::record:
      return atelier.saveRecording(path);
    case Dialog::replay:
      return atelier.replay(path);
    case Dialog::shareTool:
      return atelier.shareTool(atelier.shelf.about.value(), path);
    case Dialog::keepFile:
      return atelier.keepFile(path);
    case Dialog::combine:
      return atelier.combineFile(path, state.how);
    default:
      return;
  }
}

// Enter, a double click or the button: goes into folders, asks before it replaces.
void accept(Atelier& atelier, FileDialog& state, const Purpose& purpose) {
  if (state.name.empty()) {
    atelier.say(Message::Kind::note, "Type or choose a name first");
    state.focusName = true;
    return;
  }
  fs::path path = state.browser.resolve(state.name);
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    state.browser.enter(path);
    state.name = suggestedName(atelier, purpose);
    state.chosen = -1;
    state.focusName = true;
    return;
  }
  const bool writes = *purpose.ending != 0;
  if (writes && path.extension().empty()) path += purpose.ending;
  if (!writes && !fs::exists(path, ignored)) {
    atelier.say(Message::Kind::error, path.filename().string() + ": no such file");
    return;
  }
  if (writes && fs::exists(path, ignored) && path != atelier.path() && !state.askedToReplace) {
    state.askedToReplace = state.focusVerb = true;
    return;
  }
  perform(atelier, state, path);
  ImGui::CloseCurrentPopup();
}

void entryLine(FileDialog& state, int n, bool& accepted) {
  const FileEntry& entry = state.browser.entries()[std::size_t(n)];
  ImGui::PushID(n);
  const std::string text = entry.folder ? entry.name + "/" : entry.name;
  if (ImGui::Selectable(
          lettered(text), state.chosen == n,
          ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups)) {
    state.chosen = n;
    state.name = text;
    state.askedToReplace = false;
    const bool key = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter)) ||
                     ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Space));
    accepted = key || ImGui::IsMouseDoubleClicked(0) || entry.folder;
  }
  if (!entry.folder) {
    const std::string size = byteText(double(entry.bytes));
    ImGui::SameLine(ImGui::GetWindowWidth() - textWidth(fonts().medium, size) - px(24));
    ImGui::PushFont(fonts().medium);
    ImGui::TextDisabled("%s", size.c_str());
    ImGui::PopFont();
  }
  ImGui::PopID();
}

bool hasExtras(Dialog dialog) {
  return dialog == Dialog::import || dialog == Dialog::exportMesh || dialog == Dialog::picture ||
         dialog == Dialog::turntable || dialog == Dialog::combine;
}

bool fileList(FileDialog& state) {
  bool accepted = false;
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ink(tint::well));
  const float below = ImGui::GetFrameHeightWithSpacing() * (hasExtras(state.open) ? 2.f : 1.f);
  ImGui::BeginChild("files", {0, -below}, false, ImGuiWindowFlags_NavFlattened);
  ImGui::SetCursorPosY(px(7));
  ImGui::Indent(px(8));
  ImGuiListClipper clipper;
  clipper.Begin(int(state.browser.entries().size()));
  while (clipper.Step()) {
    for (int n = clipper.DisplayStart; n < clipper.DisplayEnd; ++n) {
      if (std::size_t(n) < state.browser.entries().size()) entryLine(state, n, accepted);
    }
  }
  if (state.browser.entries().empty()) {
    const std::string& trouble = state.browser.trouble();
    ImGui::TextDisabled("%s", trouble.empty() ? "Nothing here" : trouble.c_str());
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
  return accepted;
}

void howToCombine(Combining& how) {
  constexpr std::array<std::pair<const char*, Combining>, 3> kWays{
      {{"Unite", Combining::unite},
       {"Subtract", Combining::subtract},
       {"Intersect", Combining::intersect}}};
  for (const auto& [label, way] : kWays) {
    if (ImGui::RadioButton(label, how == way)) how = way;
    ImGui::SameLine();
  }
  ImGui::NewLine();
}

void extras(FileDialog& state) {
  ImGui::PushItemWidth(px(110));
  switch (state.open) {
    case Dialog::import:
      ImGui::InputInt("cells along the longest side", &state.cells, 16, 64);
      state.cells = std::clamp(state.cells, 8, 2048);
      break;
    case Dialog::combine:
      howToCombine(state.how);
      break;
    case Dialog::exportMesh: {
      int part = int(state.keep * 100 + .5);
      ImGui::InputInt("% of the triangles", &part, 5, 25);
      state.keep = std::clamp(part, 1, 100) / 100.0;
      break;
    }
    case Dialog::turntable:
      ImGui::InputInt("pictures", &state.frames, 1, 12);
      state.frames = std::clamp(state.frames, 2, 720);
      ImGui::SameLine();
      [[fallthrough]];
    case Dialog::picture:
      ImGui::InputInt("×", &state.width, 0);
      ImGui::SameLine();
      ImGui::InputInt("pixels", &state.height, 0);
      state.width = std::clamp(state.width, 16, 16384);
      state.height = std::clamp(state.height, 16, 16384);
      break;
    default:
      break;
  }
  ImGui::PopItemWidth();
}

// A whole character: UTF-8 goes on while the top bits are 10.
void dropFirst(std::string& text) {
  do {
    text.erase(0, 1);
  } while (!text.empty() && (static_cast<unsigned char>(text[0]) & 0xC0) == 0x80);
}

void folderLine(FileDialog& state) {
  if (button("Up", {px(56), 0}, ButtonKind::plain, "The folder around this one (Backspace).")) {
    state.browser.up();
  }
  ImGui::SameLine();
  if (button("Home", {px(64), 0})) {
    if (const char* home = std::getenv("HOME")) state.browser.enter(home);
  }
  ImGui::SameLine();
  const std::string folder = state.browser.folder().string();
  const float room = ImGui::GetContentRegionAvail().x;
  std::string text = folder;
  while (text.size() > 4 && textWidth(fonts().regular, "…" + text) > room) dropFirst(text);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted((text == folder ? text : "…" + text).c_str());
}

void fileDialog(Atelier& atelier, FileDialog& state, const Purpose& purpose) {
  if (state.open != atelier.dialog) begin(state, atelier, purpose);
  bool open = true;
  if (!beginModal(purpose.title, {px(640), px(480)}, &open)) return;
  folderLine(state);
  bool accepted = fileList(state);
  extras(state);
  if (std::exchange(state.focusName, false)) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-px(196));
  if (ImGui::InputTextWithHint(
          "##name", "Name, or a path", &state.name,
          ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll)) {
    accepted = true;
  }
  lettered(state.name);
  const bool typing = ImGui::IsItemActive();
  if (ImGui::IsItemEdited()) {
    state.askedToReplace = false;
    state.chosen = state.name.empty() ? -1 : state.browser.find(state.name);
  }
  ImGui::SameLine();
  if (std::exchange(state.focusVerb, false)) ImGui::SetKeyboardFocusHere();
  const char* verb = state.askedToReplace ? "Replace it" : purpose.verb;
  if (button(verb, {px(96), 0}, ButtonKind::accent)) accepted = true;
  ImGui::SameLine();
  const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
  bool leave = button("Cancel", {px(84), 0}) || !open;
  leave |= pressed(ImGuiKey_Escape);
  if (!typing && pressed(ImGuiKey_Backspace)) state.browser.up();
  if (accepted) accept(atelier, state, purpose);
  if (leave) {
    atelier.dialog = Dialog::none;
    ImGui::CloseCurrentPopup();
  }
  if (atelier.dialog == Dialog::none) state.open = Dialog::none;
  ImGui::EndPopup();
}

void unsavedDialog(Atelier& atelier) {
  if (!beginModal("Unsaved work", {px(420), 0})) return;
  ImGui::PushTextWrapPos();
  const std::string text = "“" + atelier.title() + "” has changes that are not saved.";
  ImGui::TextUnformatted(lettered(text));
  ImGui::PopTextWrapPos();
  ImGui::Dummy({1, px(4)});
  const ImVec2 size{(ImGui::GetContentRegionAvail().x - px(16)) / 3, 0};
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  const bool save = button("Save", size, ButtonKind::accent);
  ImGui::SameLine();
  const bool discard = button("Don't save", size);
  ImGui::SameLine();
  const bool stay =
      button("Cancel", size) || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  if (save || discard || stay) ImGui::CloseCurrentPopup();
  if (save || discard) atelier.answerUnsaved(save);
  if (stay) atelier.dialog = Dialog::none;
  ImGui::EndPopup();
}

}  // namespace

void drawDialogs(const PanelContext& context) {
  static FileDialog state;
  Atelier& atelier = context.atelier;
  if (const Purpose* purpose = purposeOf(atelier.dialog)) {
    fileDialog(atelier, state, *purpose);
  } else if (atelier.dialog == Dialog::unsaved) {
    unsavedDialog(atelier);
  }
}

}  // namespace bozzetto::ui
