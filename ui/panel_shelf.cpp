// The drawer with shelves: tools that are sculptures, to be taken, kept, named and shared.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "ui/icons.hpp"
#include "ui/letters.hpp"
#include "ui/panels.hpp"
#include "ui/widgets.hpp"

namespace bozzetto::ui {
namespace {

using Form = ShelfDrawer::Form;
using Place = ToolEntry::Place;

const char* nameOf(Place place) {
  constexpr const char* names[] = {"this scene", "your library", "starter tool"};
  return names[int(place)];
}

bool escapes() { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)); }

void ask(ShelfDrawer& drawer, Form form) {
  drawer.form = drawer.form == form ? Form::none : form;
  drawer.formOpened = true;
}

void askAbout(ShelfDrawer& drawer, Form form, const ToolEntry& entry) {
  drawer.form = form;
  drawer.formOpened = true;
  drawer.about = entry;
  drawer.name = entry.name;
  drawer.tags.clear();
  for (const std::string& tag : entry.tags) drawer.tags += (drawer.tags.empty() ? "" : " ") + tag;
}

bool isMine(const ShelfDrawer& drawer, const std::string& name) {
  return std::ranges::any_of(drawer.cards, [&](const ShelfCard& card) {
    return card.entry.place == Place::user && card.entry.name == name;
  });
}

// A starter's name would mean this one in recordings: it gets another.
void putIntoLibrary(Atelier& atelier, const ToolEntry& entry) {
  ShelfDrawer& drawer = atelier.shelf;
  if (isMine(drawer, entry.name)) return askAbout(drawer, Form::replaceMine, entry);
  if (!isStarter(entry.name)) return atelier.keepForUser(entry, entry.name);
  askAbout(drawer, Form::nameMine, entry);
  drawer.name = freeName(drawer.cards, entry.name);
}

// What else can be done with a tool.
void cardItems(Atelier& atelier, const ToolEntry& entry) {
  ShelfDrawer& drawer = atelier.shelf;
  if (ImGui::MenuItem("Take it")) atelier.takeTool(entry);
  if (ImGui::MenuItem("Save as a file…")) {
    drawer.about = entry;
    atelier.dialog = Dialog::shareTool;
  }
  if (entry.place != Place::user && ImGui::MenuItem("Put into your library"))
    putIntoLibrary(atelier, entry);
  if (entry.place == Place::starter) return;
  ImGui::Separator();
  if (ImGui::MenuItem("Name and tags…")) askAbout(drawer, Form::rename, entry);
}

void cardMenu(Atelier& atelier, const ShelfCard& card) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(10), px(8)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {px(8), px(7)});
  if (ImGui::BeginPopupContextItem("more")) {
    const ToolEntry& entry = card.entry;
    if (card.trouble.empty()) cardItems(atelier, entry);
    if (entry.place != Place::starter && ImGui::MenuItem("Delete…"))
      askAbout(atelier.shelf, Form::remove, entry);
    if (escapes()) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
}

// A name means the scene's tool before others.
bool isInHand(const Atelier& atelier, const ShelfCard& card) {
  return atelier.sculpt.isFreeform() && atelier.sculpt.freeform->name == card.entry.name &&
         cardNamed(atelier.shelf.cards, card.entry.name) == &card;
}

std::string tipOf(const ShelfCard& card) {
  const ToolEntry& entry = card.entry;
  if (!card.trouble.empty()) return card.trouble + "\nRight click to delete it.";
  std::string text = entry.name + "  ·  " + nameOf(entry.place);
  for (const std::string& tag : entry.tags) text += (&tag == &entry.tags[0] ? "\n" : ", ") + tag;
  return text + "\nClick to take it, right click for more.";
}

void drawCross(ImDrawList* list, ImVec2 middle, float d, ImU32 colour) {
  list->AddLine({middle.x - d, middle.y - d}, {middle.x + d, middle.y + d}, colour, px(1.5f));
  list->AddLine({middle.x - d, middle.y + d}, {middle.x + d, middle.y - d}, colour, px(1.5f));
}

void toolCard(const PanelContext& context, const ShelfCard& card, float side) {
  Atelier& atelier = context.atelier;
  const bool usable = card.trouble.empty();
  if (hotArea("tool", {side, side + px(18)})) {
    usable ? atelier.takeTool(card.entry) : atelier.say(Message::Kind::error, card.trouble);
  }
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high{low.x + side, low.y + side};
  const bool hovered = ImGui::IsItemHovered(), chosen = isInHand(atelier, card);
  tooltip(tipOf(card));
  cardMenu(atelier, card);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(low, high, ink(hovered ? tint::hover : tint::card), px(8));
  const auto picture = context.pictures.tools.find(card.pictureId);
  if (picture != context.pictures.tools.end() && picture->second) {
    list->AddImageRounded(picture->second, low, high, {0, 0}, {1, 1},
                          ink(0xFFFFFF, hovered ? 1.f : .93f), px(8));
  } else {
    const ImVec2 middle{(low.x + high.x) / 2, (low.y + high.y) / 2};
    drawIcon(list, Icon::shelf, {middle, px(10)}, {ink(tint::faint), ink(tint::faint)});
    if (!usable) drawCross(list, middle, px(16), ink(tint::dim));
  }
  if (chosen) {
    const float d = px(1);
    list->AddRect({low.x - d, low.y - d}, {high.x + d, high.y + d}, ink(tint::accent), px(9), 0,
                  px(2));
  }
  const std::string name = fitted(fonts().medium, card.entry.name, side);
  drawText(list, fonts().medium,
           {low.x + (side - textWidth(fonts().medium, name)) / 2, high.y + px(3)},
           ink(!usable   ? tint::faint
               : chosen  ? tint::strong
               : hovered ? tint::text
                         : tint::dim),
           name);
}

void cards(const PanelContext& context) {
  const ShelfDrawer& drawer = context.atelier.shelf;
  constexpr int kColumns = 3;
  const float gap = px(8);
  const float side =
      std::floor((ImGui::GetContentRegionAvail().x - gap * (kColumns - 1)) / kColumns);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, px(6)});
  int shown = 0;
  for (std::size_t n = 0; n < drawer.cards.size(); ++n) {
    if (!drawer.shows(drawer.cards[n])) continue;
    if (shown++ % kColumns != 0) ImGui::SameLine();
    ImGui::PushID(int(n));
    toolCard(context, drawer.cards[n], side);
    ImGui::PopID();
  }
  ImGui::PopStyleVar();
  if (shown > 0) return;
  const bool own = drawer.place && *drawer.place != Place::starter && drawer.query.empty();
  ImGui::PushStyleColor(ImGuiCol_Text, ink(tint::dim));
  ImGui::TextWrapped("%s", own ? "Nothing here yet. Keep the clay you have as a tool, or drop a "
                                 "file on the shelf."
                               : "No tool is called so.");
  ImGui::PopStyleColor();
}

bool field(const char* id, const char* hint, std::string& text, ShelfDrawer& drawer) {
  if (std::exchange(drawer.formOpened, false)) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  lettered(text);
  return ImGui::InputTextWithHint(id, hint, &text, ImGuiInputTextFlags_EnterReturnsTrue);
}

// Where nothing is given the field keeps the keyboard: letters are no shortcuts there.
bool isGiven(ShelfDrawer& drawer, const std::string& text, bool done) {
  if (done && text.empty()) drawer.formOpened = true;
  return done && !text.empty();
}

void keepNow(Atelier& atelier) {
  ShelfDrawer& drawer = atelier.shelf;
  atelier.keepClay(drawer.name, tagsOf(drawer.tags), drawer.part,
                   drawer.patch ? std::optional(PatchSource{}) : std::nullopt);
  drawer.form = Form::none;
}

std::string lassoHelp(const Atelier& atelier) {
  const std::string chord = atelier.keymap.chordText(Command::lasso);
  if (atelier.lasso()) return "The part in the lasso is kept; " + chord + " draws another.";
  return atelier.drawsLasso() ? "Draw round the part." : chord + ", then draw round the part.";
}

std::string helpFor(const Atelier& atelier) {
  switch (atelier.shelf.part) {
    case ShelfDrawer::Part::insideBox:
      return "Drag the box's handles around the part.";
    case ShelfDrawer::Part::insideLasso:
      return lassoHelp(atelier);
    case ShelfDrawer::Part::toolInHand:
      return "With its action, strength, stroke and placement.";
    case ShelfDrawer::Part::allClay:
      break;
  }
  return "";
}

void choosePart(Atelier& atelier) {
  int part = int(atelier.shelf.part);
  if (choice("##part", part, {"All clay", "In the box", "In a lasso", "Tool in hand"},
             "What is kept: clay as a tool that does what yours does now, or your tool as it is, "
             "a ball or box too.")) {
    atelier.choosePart(ShelfDrawer::Part(part));
  }
  const std::string help = helpFor(atelier);
  if (help.empty()) return;
  ImGui::PushStyleColor(ImGuiCol_Text, ink(tint::dim));
  ImGui::TextWrapped("%s", help.c_str());
  ImGui::PopStyleColor();
}

void keepForm(Atelier& atelier) {
  ShelfDrawer& drawer = atelier.shelf;
  bool done = field("##name", "Name", drawer.name, drawer);
  done |= field("##tags", "Tags", drawer.tags, drawer);
  choosePart(atelier);
  if (drawer.part != ShelfDrawer::Part::toolInHand) {
    toggle("Without its plane", drawer.patch,
           "Only what stands on the plane under most of it; that side meets the clay.");
  }
  const float width = ImGui::GetContentRegionAvail().x;
  done |= button("Keep", {width, 0}, ButtonKind::accent, "Puts it on this scene's shelf.");
  if (!isGiven(drawer, drawer.name, done)) return;
  if (drawer.part == ShelfDrawer::Part::insideLasso && !atelier.lasso())
    return atelier.choosePart(drawer.part);
  const ShelfCard* taken = cardNamed(drawer.cards, drawer.name);
  if (taken == nullptr) return keepNow(atelier);
  drawer.about = taken->entry;
  drawer.form = Form::replace;
}

enum class Answer { none, replace, both, cancel };

// What has the name, and what becomes of it.
Answer replaceQuestion(ShelfDrawer& drawer, const std::string& text) {
  ImGui::TextWrapped("%s", text.c_str());
  const float whole = ImGui::GetContentRegionAvail().x, half = (whole - px(8)) / 2;
  Answer answer = Answer::none;
  if (button("Keep both", {half, 0}, ButtonKind::accent, "The new one gets a name of its own.")) {
    answer = Answer::both;
  }
  ImGui::SameLine();
  if (button("Replace", {half, 0}, ButtonKind::plain, "The old one is gone for good.")) {
    answer = Answer::replace;
  }
  if (button("Cancel", {whole, 0}, ButtonKind::plain, "Nothing is kept.")) answer = Answer::cancel;
  if (answer != Answer::none) drawer.form = Form::none;
  return answer;
}

void replaceForm(Atelier& atelier) {
  ShelfDrawer& drawer = atelier.shelf;
  const std::string name = "“" + drawer.name + "”";
  const bool replaces = drawer.about->place == Place::document;
  const std::string text =
      replaces
          ? name + " is on this scene's shelf already."
          : name + " is a " +
                (drawer.about->place == Place::user ? "tool of your library" : "starter tool") +
                " already; in this scene the new one would hide it.";
  const Answer answer = replaceQuestion(drawer, text);
  if (answer == Answer::cancel) return ask(drawer, Form::keep);
  if (answer == Answer::none) return;
  if (answer == Answer::both) drawer.name = freeName(drawer.cards, drawer.name);
  keepNow(atelier);
}

// Among the user's own tools.
void replaceMineForm(Atelier& atelier) {
  ShelfDrawer& drawer = atelier.shelf;
  const Answer answer =
      replaceQuestion(drawer, "“" + drawer.about->name + "” is in your library already.");
  if (answer == Answer::none || answer == Answer::cancel) return;
  const std::string& name = drawer.about->name;
  atelier.keepForUser(*drawer.about, answer == Answer::both ? freeName(drawer.cards, name) : name);
}

// Of a starter's copy.
void nameMineForm(Atelier& atelier) {
  ShelfDrawer& drawer = atelier.shelf;
  bool done = field("##name", "Name", drawer.name, drawer);
  ImGui::TextWrapped("Starters keep their names: yours needs another.");
  const float width = ImGui::GetContentRegionAvail().x;
  done |= button("Put into your library", {width, 0}, ButtonKind::accent, "Under that name.");
  if (!isGiven(drawer, drawer.name, done)) return;
  if (isMine(drawer, drawer.name) || isStarter(drawer.name))
    return atelier.say(Message::Kind::error,
                       drawer.name + ": a tool is called so. Another name is needed");
  atelier.keepForUser(*drawer.about, drawer.name);
  drawer.form = Form::none;
}

void lettersForm(Atelier& atelier) {
  ShelfDrawer& drawer = atelier.shelf;
  bool done = field("##text", "Letters", drawer.text, drawer);
  slider("Letter size", drawer.letterSize, {2, 128, "mm", 1, 1, true}, "Of a capital letter.");
  slider("Letter depth", drawer.letterDepth, {0.5, 64, "mm", 1, 1, true},
         "How far they stand out.");
  const float width = ImGui::GetContentRegionAvail().x;
  done |= button("Keep", {width, 0}, ButtonKind::accent, "Puts the letters on the shelf.");
  if (!isGiven(drawer, drawer.text, done)) return;
  atelier.keepLetters(drawer.text, drawer.letterSize, drawer.letterDepth);
  drawer.form = Form::none;
}

void renameForm(Atelier& atelier) {
  ShelfDrawer& drawer = atelier.shelf;
  bool done = field("##name", "Name", drawer.name, drawer);
  done |= field("##tags", "Tags", drawer.tags, drawer);
  const float width = ImGui::GetContentRegionAvail().x;
  done |= button("Rename", {width, 0}, ButtonKind::accent, "Gives it that name and these tags.");
  if (!isGiven(drawer, drawer.name, done)) return;
  atelier.renameTool(*drawer.about, drawer.name, tagsOf(drawer.tags));
  drawer.form = Form::none;
}

void removeForm(Atelier& atelier) {
  ShelfDrawer& drawer = atelier.shelf;
  ImGui::TextWrapped("Delete “%s”? This cannot be undone.", drawer.about->name.c_str());
  const float half = (ImGui::GetContentRegionAvail().x - px(8)) / 2;
  if (button("Delete", {half, 0}, ButtonKind::accent, "It is gone for good.")) {
    atelier.dropTool(*drawer.about);
    drawer.form = Form::none;
  }
  ImGui::SameLine();
  if (button("Keep it", {half, 0})) drawer.form = Form::none;
}

void form(Atelier& atelier) {
  switch (atelier.shelf.form) {
    case Form::keep:
      return keepForm(atelier);
    case Form::replace:
      return replaceForm(atelier);
    case Form::replaceMine:
      return replaceMineForm(atelier);
    case Form::nameMine:
      return nameMineForm(atelier);
    case Form::letters:
      return lettersForm(atelier);
    case Form::rename:
      return renameForm(atelier);
    case Form::remove:
      return removeForm(atelier);
    case Form::none:
      return;
  }
}

float heightOf(const ShelfDrawer& drawer) {
  constexpr float kLine = 34;
  switch (drawer.form) {
    case Form::keep:
      return px(6 * kLine + (drawer.part != ShelfDrawer::Part::allClay ? 44.f : 4.f));
    case Form::replace:
    case Form::replaceMine:
      return px(5 * kLine + 4);
    case Form::letters:
      return px(2 * kLine + 92);
    case Form::nameMine:
      return px(3 * kLine + 24);
    case Form::rename:
      return px(3 * kLine + 4);
    case Form::remove:
      return px(2 * kLine + 12);
    case Form::none:
      return 0;
  }
  return 0;
}

void buttons(Atelier& atelier) {
  const float third = (ImGui::GetContentRegionAvail().x - 2 * px(8)) / 3;
  if (button("Keep…", {third, 0}, ButtonKind::plain,
             "The clay, or its part in a box, becomes a tool that does what yours does now.")) {
    ask(atelier.shelf, Form::keep);
    atelier.shelf.name = freeName(atelier.shelf.cards, "tool");
    atelier.shelf.tags.clear();
    if (atelier.shelf.form == Form::keep) atelier.choosePart(atelier.shelf.part);
  }
  ImGui::SameLine();
  if (button("Letters…", {third, 0}, ButtonKind::plain, "A text becomes a tool.")) {
    ask(atelier.shelf, Form::letters);
  }
  ImGui::SameLine();
  if (button("File…", {third, 0}, ButtonKind::plain,
             "A tool, scene, mesh or recording; a grey picture becomes a relief. Files can also "
             "be dropped here.")) {
    atelier.dialog = Dialog::keepFile;
  }
}

void heading(Atelier& atelier) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  drawText(list, fonts().display, at, ink(0xF4F4F5), "Shelf");
  ImGui::SetCursorScreenPos({at.x + width - px(20), at.y});
  if (hotArea("close", {px(22), px(22)})) atelier.run(Command::shelf);
  const ImU32 colour = ink(ImGui::IsItemHovered() ? tint::text : tint::faint);
  tooltip(atelier.keymap, Command::shelf);
  const ImVec2 middle{at.x + width - px(9), at.y + px(11)};
  drawCross(list, middle, px(4.5f), colour);
  ImGui::SetCursorScreenPos({at.x, at.y + px(30)});
}

}  // namespace

void drawShelf(const PanelContext& context) {
  Atelier& atelier = context.atelier;
  ShelfDrawer& drawer = atelier.shelf;
  if (context.layout.shelf == Drawer::closed) return;
  const Rect& at = context.layout.drawer;
  ImGui::SetNextWindowPos({float(at.low.x), float(at.low.y)});
  ImGui::SetNextWindowSize({float(at.width()), float(at.height())});
  ImGui::Begin("shelf", nullptr, kFixed);
  heading(atelier);
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##find", "Search names and tags", &drawer.query);
  lettered(drawer.query);
  int place = drawer.place ? int(*drawer.place) + 1 : 0;
  if (choice("##place", place, {"All", "Scene", "Yours", "Starters"}, "Whose tools are shown.")) {
    drawer.place.reset();
    if (place > 0) drawer.place = Place(place - 1);
  }
  ImGui::BeginChild("cards", {0, -(px(42) + heightOf(drawer))});
  cards(context);
  ImGui::EndChild();
  form(atelier);
  if (escapes()) drawer.form = Form::none;
  buttons(atelier);
  ImGui::End();
}

}  // namespace bozzetto::ui
