// Work that came back: of a scene that was not saved when its program ended, and work that never
// had a name.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include "ui/letters.hpp"
#include "ui/panels.hpp"
#include "ui/widgets.hpp"

namespace bozzetto::ui {
namespace {

std::string timeText(std::int64_t milliseconds) {
  const auto seconds = static_cast<std::time_t>(milliseconds / 1000);
  return fmt::format("{:%A, %d %B %Y, %H:%M}", fmt::localtime(seconds));
}

std::string stepsText(std::size_t steps) {
  return steps == 1 ? "1 step" : fmt::format("{} steps", steps);
}

// False when it is not open.
bool beginDialog(const char* title, float width) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(20), px(18)});
  const bool open = beginModal(title, {px(width), 0});
  ImGui::PopStyleVar();
  return open;
}

void picture(ImTextureID texture, ImVec2 size) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImGui::Dummy(size);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 high{low.x + size.x, low.y + size.y};
  list->AddRectFilled(low, high, ink(0x26292E), px(8));
  if (texture) list->AddImageRounded(texture, low, high, {0, 1}, {1, 0}, ~0u, px(8));
  list->AddRect(low, high, ink(0xFFFFFF, .08f), px(8));
}

void paragraph(const std::string& text, unsigned colour = tint::text) {
  ImGui::PushStyleColor(ImGuiCol_Text, ink(colour));
  ImGui::PushTextWrapPos();
  ImGui::TextUnformatted(lettered(text));
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

void aboutRecovered(const Atelier& atelier) {
  const SessionFindings& findings = atelier.document().findings;
  const std::string name = atelier.path().filename().string();
  ImGui::PushFont(fonts().display);
  paragraph(name, tint::strong);
  ImGui::PopFont();
  const char* were = findings.unsavedSteps == 1 ? " that was" : " that were";
  paragraph(stepsText(findings.unsavedSteps) + were + " not saved came back.");
  if (findings.time > 0) paragraph("Last worked on " + timeText(findings.time), tint::dim);
  paragraph("Whatever you choose, nothing is lost: both states stay in the history.", tint::dim);
}

void recoveredDialog(const PanelContext& context) {
  Atelier& atelier = context.atelier;
  if (!beginDialog("Work that was not saved", 560)) return;
  picture(context.pictures.document, {px(200), px(150)});
  ImGui::SameLine(0, px(18));
  ImGui::BeginGroup();
  aboutRecovered(atelier);
  ImGui::EndGroup();
  ImGui::Dummy({1, px(6)});
  const bool canGoBack = atelier.document().canGoBack;
  const float room = ImGui::GetContentRegionAvail().x;
  const ImVec2 size{canGoBack ? (room - px(8)) / 2 : room, px(32)};
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  bool goOn = button("Go on with it", size, ButtonKind::accent,
                     "As it was after the last step. Save when you like.");
  bool back = false;
  if (canGoBack) {
    ImGui::SameLine();
    back = button("Back to the saved file", size, ButtonKind::plain,
                  "A step like any other: the history leads back here.");
  }
  goOn |= ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  if (goOn || back) {
    ImGui::CloseCurrentPopup();
    atelier.answerRecovered(back);
  }
  ImGui::EndPopup();
}

// One document. True when the dialog is over.
bool leftLine(const PanelContext& context, const LeftDocument& left, bool& sure) {
  Atelier& atelier = context.atelier;
  const auto found = context.pictures.left.find(left.path);
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  picture(found == context.pictures.left.end() ? nullptr : found->second, {px(116), px(92)});
  const ImVec2 after = ImGui::GetCursorScreenPos();
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float x = at.x + px(132);
  drawText(list, fonts().semiBold, {x, at.y + px(6)}, ink(tint::strong), "Untitled");
  drawText(list, fonts().medium, {x, at.y + px(27)}, ink(tint::dim),
           stepsText(left.glance.steps) + "  ·  " + timeText(left.glance.time));
  ImGui::SetCursorScreenPos({x, at.y + px(56)});
  const bool open = button("Open", {px(92), px(30)}, ButtonKind::accent);
  ImGui::SameLine();
  const char* words = sure ? "Really discard it" : "Discard…";
  const bool discard =
      button(words, {px(sure ? 150 : 92), px(30)}, ButtonKind::plain, "Takes it away for good.");
  if (open) atelier.openLeftBehind(left.path);
  if (discard && sure) atelier.discardLeftBehind(left.path);
  if (discard) sure = !sure;
  list->AddLine({at.x, after.y + px(2)}, {at.x + width, after.y + px(2)}, ink(0xFFFFFF, .06f));
  ImGui::SetCursorScreenPos({after.x, after.y + px(10)});
  return open;
}

void leftBehindDialog(const PanelContext& context) {
  static std::filesystem::path sureOf;  // what was asked about
  Atelier& atelier = context.atelier;
  if (!beginDialog("Left behind", 520)) return;
  paragraph("Work without a name was not saved when its window ended.");
  ImGui::Dummy({1, px(4)});
  const auto all = atelier.leftBehind();
  const float room = ImGui::GetIO().DisplaySize.y - px(220);
  const float height = std::min(px(115) * float(all.size()), room);
  ImGui::BeginChild("left", {0, height}, false, ImGuiWindowFlags_NavFlattened);
  bool over = false;
  for (const LeftDocument& left : all) {
    ImGui::PushID(left.path.c_str());
    bool sure = sureOf == left.path;
    over |= leftLine(context, left, sure);
    if (sure) sureOf = left.path;
    if (!sure && sureOf == left.path) sureOf.clear();
    ImGui::PopID();
  }
  ImGui::EndChild();
  const bool later = button("Later", {ImGui::GetContentRegionAvail().x, px(32)}, ButtonKind::plain,
                            "They are offered again at the next start.") ||
                     ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  if (later) atelier.dialog = Dialog::none;
  if (later || over || atelier.dialog != Dialog::leftBehind) {
    ImGui::CloseCurrentPopup();
    sureOf.clear();
  }
  ImGui::EndPopup();
}

}  // namespace

void drawRecovery(const PanelContext& context) {
  if (context.atelier.dialog == Dialog::recovered) recoveredDialog(context);
  if (context.atelier.dialog == Dialog::leftBehind) leftBehindDialog(context);
}

}  // namespace bozzetto::ui
