// The panel on the right: the tool in hand first, then how it is used, then all that is looked at.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <array>
#include <cctype>
#include <cmath>
#include <glm/geometric.hpp>

#include "ui/icons.hpp"
#include "ui/panels.hpp"
#include "ui/widgets.hpp"

namespace bozzetto::ui {
namespace {

std::string shapeName(const SculptState& sculpt) {
  constexpr const char* names[] = {"Ball", "Box", "Cylinder", "Capsule"};
  return sculpt.isFreeform() ? sculpt.freeform->name : names[int(sculpt.shape)];
}

void toolCard(const SculptState& sculpt, const ToolRow& row) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  list->AddRectFilled(at, {at.x + width, at.y + px(66)}, ink(tint::card), px(9));
  list->AddRectFilled({at.x + px(7), at.y + px(7)}, {at.x + px(59), at.y + px(59)},
                      ink(tint::accent), px(8));
  std::string title(row.title), what(row.what);
  if (sculpt.recall) {
    drawTurn(list, {at.x + px(33), at.y + px(33)}, Turn::undo, ink(0xFFFFFF));
    title = "Bring back";
    what = fmt::format("clay as of step {}", *sculpt.recall);
  } else {
    drawIcon(list, row.icon, {{at.x + px(33), at.y + px(33)}, px(14)},
             {ink(0xFFFFFF), ink(tint::onAccent)});
  }
  drawText(list, fonts().display, {at.x + px(72), at.y + px(12)}, ink(0xF4F4F5), title);
  drawText(
      list, fonts().medium, {at.x + px(72), at.y + px(37)}, ink(tint::dim),
      fitted(fonts().medium, fmt::format("{}  ·  {}", shapeName(sculpt), what), width - px(80)));
  ImGui::Dummy({width, px(66)});
}

// From the limit of influence through the core to the other side.
double falloffAt(Profile profile, double u) {
  u = std::abs(u);
  if (profile == Profile::wyvill) {
    const double s = u * u;
    return 1 - 4.0 / 9 * s * s * s + 17.0 / 9 * s * s - 22.0 / 9 * s;
  }
  if (u < 0.7) return 1;
  const double t = (u - 0.7) / 0.3;
  return 1 - t * t * (3 - 2 * t);
}

void falloffPlot(Profile profile) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = px(52);
  list->AddRectFilled(at, {at.x + width, at.y + height}, ink(0x141518), px(6));
  for (int n = 1; n < 4; ++n) {
    const float x = at.x + width * float(n) / 4;
    list->AddLine({x, at.y + px(5)}, {x, at.y + height - px(5)}, ink(0xFFFFFF, .04f));
  }
  constexpr int kSteps = 64;
  ImVec2 points[kSteps + 1];
  const float base = at.y + height - px(7);
  for (int n = 0; n <= kSteps; ++n) {
    const double u = 2.0 * n / kSteps - 1;
    points[n] = {at.x + px(10) + (width - px(20)) * float(n) / kSteps,
                 base - (height - px(15)) * float(falloffAt(profile, u))};
  }
  // Without fringes, which would show as seams between the strips.
  const ImDrawListFlags flags = list->Flags;
  list->Flags &= ~ImDrawListFlags_AntiAliasedFill;
  for (int n = 0; n < kSteps; ++n) {
    const ImVec2 strip[] = {points[n], points[n + 1], {points[n + 1].x, base}, {points[n].x, base}};
    list->AddConvexPolyFilled(strip, 4, ink(tint::accent, .30f));
  }
  list->Flags = flags;
  list->AddPolyline(points, kSteps + 1, ink(0xF19A6F), 0, px(2));
  ImGui::Dummy({width, height});
}

void falloff(SculptState& sculpt) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const std::string name = sculpt.profile == Profile::wyvill ? "Soft" : "Firm";
  if (hotArea("falloff", {width, px(19)})) {
    sculpt.profile = sculpt.profile == Profile::wyvill ? Profile::box : Profile::wyvill;
  }
  tooltip("How the tool fades from its middle to its limit. Click for the other.");
  drawText(list, fonts().regular, at, ink(tint::text, .92f), "Falloff");
  drawText(list, fonts().regular, {at.x + width - textWidth(fonts().regular, name), at.y},
           ink(ImGui::IsItemHovered() ? tint::text : tint::dim), name);
  falloffPlot(sculpt.profile);
}

// The tool from the shelf as a volume: the next click says where.
void combineButtons(Atelier& atelier) {
  constexpr std::array<std::pair<const char*, Command>, 3> kButtons{
      {{"Unite", Command::uniteTool},
       {"Subtract", Command::subtractTool},
       {"Intersect", Command::intersectTool}}};
  const float width = (ImGui::GetContentRegionAvail().x - 2 * px(8)) / 3;
  for (const auto& [label, command] : kButtons) {
    if (command != Command::uniteTool) ImGui::SameLine();
    const std::string tip(rowOf(command).tip);
    if (button(label, {width, 0}, ButtonKind::plain, tip.c_str())) atelier.run(command);
  }
}

}  // namespace

void toolSection(Atelier& atelier) {
  SculptState& sculpt = atelier.sculpt;
  const ToolRow& row = rowOf(sculpt.action);
  toolCard(sculpt, row);
  ImGui::Dummy({1, px(2)});
  const double cell = atelier.status().scale.spacing;
  Slide size{kSmallestToolCells * cell, 128 * cell, "mm", 1, sculpt.size < 10 ? 2 : 1, true};
  size.pen = sculpt.pressureSize;
  const auto key = [&](Command command) { return atelier.keymap.chordText(command); };
  const std::string sizeTip =
      fmt::format("The tool's limit of influence. {} drags it, {} and {} step it.",
                  key(Command::dragSize), key(Command::smaller), key(Command::larger));
  slider("Size", sculpt.size, size, sizeTip.c_str());
  if (row.usesStrength || sculpt.recall) {
    Slide strength{0.01, 1, "%", 100, 0};
    strength.pen = sculpt.pressureStrength;
    const Strengths says = strengthsOf(sculpt.recall ? ActionKind::add : sculpt.action);
    slider(says.name.data(),
           sculpt.recall ? sculpt.recallStrength : sculpt.strengthOf(sculpt.action), strength,
           fmt::format("{} {} drags it.", says.what, key(Command::dragStrength)).c_str());
  }
  if (!movesClay(sculpt.action)) {
    slider("Spacing", sculpt.spacing, {0.05, 8, "%", 100, 0, true},
           "Between dabs, as part of the tool's smallest radius.");
  }
  if (row.action == ActionKind::stamp) stampSection(atelier);
  if (!sculpt.isFreeform()) {
    if (!movesClay(sculpt.action)) falloff(sculpt);
    return;
  }
  if (row.usesColour) {
    toggle("Its own colours", sculpt.ownColours, "The clay gets the colours of the sculpture.");
  }
  combineButtons(atelier);
  if (button("Back to a ball", {ImGui::GetContentRegionAvail().x, 0}, ButtonKind::plain,
             "Lets go of the tool from the shelf (Shift+Q).")) {
    sculpt.drop();
  }
}

// Which point of a sculpture lies on strokes, and which side of it meets the clay.
void standSection(Atelier& atelier) {
  Freeform& tool = *atelier.sculpt.freeform;
  glm::dvec3 pivot = tool.pivot();
  const char* names[] = {"Pivot right", "Pivot up", "Pivot front"};
  bool moved = false;
  for (int axis = 0; axis < 3; ++axis) {
    moved |= slider(names[axis], pivot[axis], {-2, 2, "%", 100, 0},
                    "What lies on strokes: 0 is the tool's middle, 100 % its side.");
  }
  if (moved) tool.setPivot(pivot);
  constexpr std::array<glm::dvec3, 6> kSides{
      {{0, 0, -1}, {0, 0, 1}, {-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}}};
  int side = -1;
  for (int n = 0; n < 6; ++n)
    if (glm::distance(tool.sculpture->contact(), kSides[std::size_t(n)]) < 1e-6) side = n;
  if (choice("Touches with its", side, {"Back", "Front", "Left", "Right", "Bottom", "Top"},
             "The side that meets the clay.")) {
    tool.setContact(kSides[std::size_t(side)]);
  }
  Heading heading = headingOf(tool.sculpture->contact());
  bool turned = slider("Touches to the right", heading.right, {-180, 180, "°", 1, 0},
                       "Of its back, where tools touch as a rule.");
  turned |= slider("Touches upward", heading.up, {-90, 90, "°", 1, 0}, "Of its back.");
  if (turned) tool.setContact(directionOf(heading));
  const float half = (ImGui::GetContentRegionAvail().x - px(8)) / 2;
  if (button("Put back", {half, 0}, ButtonKind::plain, "Pivot and contact as it was kept with.")) {
    tool.standAsKept();
  }
  ImGui::SameLine();
  if (button("Keep so", {half, 0}, ButtonKind::plain,
             "The tool on this scene's shelf has them from now on.")) {
    atelier.keepStand();
  }
}

void shapeSection(Atelier& atelier) {
  SculptState& sculpt = atelier.sculpt;
  int shape = int(sculpt.shape);
  if (choice("##shape", shape, {"Ball", "Box", "Cylinder", "Capsule"}, "The tool's shape.")) {
    sculpt.drop();
    sculpt.shape = Shape(shape);
  }
  const char* names[] = {"Width", "Height", "Depth"};
  for (int axis = 0; axis < 3; ++axis) {
    slider(names[axis], sculpt.proportions[axis], {0.1, 1, "%", 100, 0},
           "Of the size, along the tool's own axis.");
  }
  int alignment = int(sculpt.alignment);
  if (choice("Stands along", alignment, {"World", "Surface", "View"},
             "Which way the tool's long side points: up, out of the clay, or at you.")) {
    sculpt.alignment = Alignment(alignment);
  }
  const std::string tip =
      fmt::format("How the tool is turned against what it stands along. {} drags it.",
                  atelier.keymap.chordText(Command::dragRotation));
  turnSliders(sculpt.rotation, tip.c_str());
  slider("Lift", sculpt.depth, {-1, 1, "%", 100, 0},
         "The tool's middle over the surface, as part of its size.");
  if (button("Straighten", {ImGui::GetContentRegionAvail().x, 0}, ButtonKind::plain,
             "Forgets how the tool was turned.")) {
    sculpt.rotation = {1, 0, 0, 0};
  }
}

// Half a colour is none: the old one stays. #rgb is read when Enter says that it is whole.
void colourText(Colour& colour) {
  std::string text = toText(colour);
  const bool entered = ImGui::InputText(
      "##hex", &text, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  std::erase_if(text, [](char c) { return std::isxdigit(static_cast<unsigned char>(c)) == 0; });
  if (entered && text.size() == 3) text = {text[0], text[0], text[1], text[1], text[2], text[2]};
  if (text.size() == 6) colour = parseColour("#" + text);
}

void colourSection(Atelier& atelier) {
  SculptState& sculpt = atelier.sculpt;
  const float gap = px(6), side = (ImGui::GetContentRegionAvail().x - 6 * gap) / 7;
  int n = 0;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  for (const Colour colour : clayColours()) {
    if (n % 7 != 0) ImGui::SameLine();
    ImGui::PushID(n++);
    if (swatch("swatch", colour, side, colour == sculpt.colour)) sculpt.colour = colour;
    ImGui::PopID();
  }
  ImGui::PopStyleVar();
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - px(84) - ImGui::GetFrameHeight() -
                          gap);
  colourText(sculpt.colour);
  ImGui::SameLine(0, gap);
  float rgb[3] = {float(sculpt.colour.r) / 255, float(sculpt.colour.g) / 255,
                  float(sculpt.colour.b) / 255};
  if (ImGui::ColorEdit3("##colour", rgb, ImGuiColorEditFlags_NoInputs)) {
    const auto byte = [](float v) { return std::uint8_t(std::lround(v * 255)); };
    sculpt.colour = {byte(rgb[0]), byte(rgb[1]), byte(rgb[2])};
  }
  ImGui::SameLine();
  if (button("Pick", {ImGui::GetContentRegionAvail().x, 0}, ButtonKind::plain,
             "Takes a colour from the clay (E).")) {
    atelier.run(Command::eyedropper);
  }
}

namespace {

// What clay that moves meets.
void surroundings(Atelier& atelier) {
  if (section("Held clay", false)) holdSection(atelier);
  if (section("Supports", false)) supportSection(atelier);
}

}  // namespace

void drawProperties(const PanelContext& context) {
  Atelier& atelier = context.atelier;
  const Rect& at = context.layout.properties;
  ImGui::SetNextWindowPos({float(at.low.x), float(at.low.y)});
  ImGui::SetNextWindowSize({float(at.width()), float(at.height())});
  const ImGuiWindowFlags flags = kFixed & ~ImGuiWindowFlags_NoScrollbar;
  ImGui::Begin("properties", nullptr, flags);
  const bool solid = atelier.mode() == WorkMode::solid;
  const ActionKind action = atelier.sculpt.action;
  const bool meets = !solid && (movesClay(action) || action == ActionKind::hold);
  if (solid) {
    solidSections(atelier);
  } else {
    toolSection(atelier);
    if (movesClay(action) && section("How clay gives way")) movingSection(atelier);
    if (meets) surroundings(atelier);
    if (meets && section("Mass", false)) ledgerSection(atelier);
  }
  atelier.standOpen = !solid && atelier.sculpt.isFreeform() && section("Pivot and contact", false);
  if (atelier.standOpen) standSection(atelier);
  if (section("Look")) lookSection(atelier, context.pictures);
  if (section("Colour")) colourSection(atelier);
  if (!solid && section("Tool", false)) shapeSection(atelier);
  if (!solid && section("Placement", false)) placementSection(atelier);
  if (!solid && section("Stroke", false)) strokeSection(atelier);
  if (!solid && section("Symmetry", false)) symmetrySection(atelier);
  atelier.lightsOpen = section("Lights", false);
  if (atelier.lightsOpen) lightSection(atelier);
  if (section("View", false)) viewSection(atelier);
  if (section("References", false)) referenceSection(atelier);
  if (!solid && !meets) surroundings(atelier);
  if (!meets && section("Mass", false)) ledgerSection(atelier);
  if (section("Clay")) claySection(atelier);
  if (section("Performance", false)) performanceSection(atelier, context.figures);
  ImGui::End();
}

}  // namespace bozzetto::ui
