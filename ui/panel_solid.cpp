// Solid mode: its tools in the column, what they do on the right.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "ui/panels.hpp"
#include "ui/solid_icons.hpp"
#include "ui/widgets.hpp"

namespace bozzetto::ui {
namespace {

float whole() { return ImGui::GetContentRegionAvail().x; }
float half() { return (whole() - px(8)) / 2; }

bool count(const char* label, int& value, const Slide& slide, const char* tip) {
  double wide = value;
  if (!slider(label, wide, slide, tip)) return false;
  value = int(std::lround(wide));
  return true;
}

bool press(Atelier& atelier, const char* label, float width, Command command,
           ButtonKind kind = ButtonKind::plain) {
  ImGui::BeginDisabled(!atelier.isPossible(command));
  const std::string tip(rowOf(command).tip);
  const bool clicked = button(label, {width, 0}, kind, tip.c_str());
  ImGui::EndDisabled();
  if (clicked) atelier.run(command);
  return clicked;
}

void solidCard(const SolidToolRow& row) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = whole();
  list->AddRectFilled(at, {at.x + width, at.y + px(66)}, ink(tint::card), px(9));
  list->AddRectFilled({at.x + px(7), at.y + px(7)}, {at.x + px(59), at.y + px(59)},
                      ink(tint::accent), px(8));
  drawSolidIcon(list, row.tool, {{at.x + px(33), at.y + px(33)}, px(14)},
                {ink(0xFFFFFF), ink(tint::onAccent)});
  drawText(list, fonts().display, {at.x + px(72), at.y + px(12)}, ink(0xF4F4F5),
           std::string(row.title));
  drawText(list, fonts().medium, {at.x + px(72), at.y + px(37)}, ink(tint::dim),
           fitted(fonts().medium, std::string(row.what), width - px(80)));
  ImGui::Dummy({width, px(66)});
  ImGui::Dummy({1, px(2)});
}

void toolOptions(Atelier& atelier) {
  SolidState& solid = atelier.solid;
  const SolidToolRow& row = rowOf(solid.tool);
  solidCard(row);
  const double cell = atelier.status().scale.spacing;
  if (row.grip == SolidGrip::brush || row.grip == SolidGrip::touch) {
    slider("Radius", solid.radius, {cell, 128 * cell, "mm", 1, 1, true}, "Of the brush.");
  }
  if (solid.tool == SolidTool::mass || solid.tool == SolidTool::stiffness) {
    slider("Factor", solid.factor, {1.1, 10, "×", 1, 1, true}, "In the middle of the brush.");
  }
  if (solid.tool == SolidTool::inflate) {
    slider("Amount", solid.amount, {0.05, 2, "%", 100, 0, true}, "Rest lengths grow by so much.");
  }
  if (solid.tool == SolidTool::extrude) {
    slider("Length", solid.length, {0, 128 * cell, "mm", 1, 1}, "0: as deep as the cell behind.");
  }
  if (solid.tool == SolidTool::sharp) {
    int what = int(solid.sharpens);
    if (choice("Tags a", what, {"Point", "Edge", "Face"}, "What is tagged as sharp.")) {
      solid.sharpens = Element(what);
    }
  }
  if (row.grip == SolidGrip::touch) {
    const auto touched = atelier.touched();
    factLine("Stiffness", touched ? fmt::format("{:.3g}", *touched) : "–", "1 as usual.");
  }
  if (const FeltHand* hand = atelier.feltHand()) {
    factLine("Force", fmt::format("{:.2f} N", glm::length(hand->force())),
             "That a device would make you feel.");
  }
  if (row.grip == SolidGrip::curve) {
    factLine("Points", grouped((long long)atelier.curve().points.size()),
             "Esc lets the curve go, Ctrl and a click takes a point out.");
  }
  if (solid.tool == SolidTool::rope || solid.tool == SolidTool::spline ||
      solid.tool == SolidTool::inflate) {
    count("Steps", solid.steps, {1, 200, "", 1, 0, true}, "Of physics, when the hand lets go.");
  }
}

void cellSliders(SolidState& solid) {
  count("Cells across", solid.cells.i, {1, 12, "", 1, 0}, "Along x.");
  count("Cells up", solid.cells.j, {1, 12, "", 1, 0}, "Along y.");
  count("Cells deep", solid.cells.k, {1, 12, "", 1, 0}, "Along z.");
}

void makeSection(Atelier& atelier) {
  SolidState& solid = atelier.solid;
  cellSliders(solid);
  slider("Edge", solid.edge, {1, 200, "mm", 1, 1, true}, "Of a cell of a new block.");
  press(atelier, "New block", half(), Command::solidBlock);
  ImGui::SameLine();
  press(atelier, "Wrap the clay", whole(), Command::wrap);
  count("Cells along the clay", solid.coarse, {1, 24, "", 1, 0}, "Of a solid made of the clay.");
  press(atelier, "From the clay", whole(), Command::solidFromClay);
}

void toClaySection(Atelier& atelier) {
  SolidState& solid = atelier.solid;
  count("Smoothness", solid.bakeLevels, {1, 4, "", 1, 0}, "Refinements before it becomes clay.");
  const bool wraps = atelier.solidShown()->solid->isWrap();
  if (wraps) {
    toggle("Keep the mass", solid.keepMass, "The surface moves until the mass is as before.");
    press(atelier, "Apply the wrap", whole(), Command::wrapApply, ButtonKind::plain);
  } else {
    press(atelier, "Bake into clay", whole(), Command::bake, ButtonKind::plain);
  }
  press(atelier, "Let it go", whole(), Command::solidDrop);
}

// A scale under the maps' names.
void mapScale(const SolidShown& shown) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = whole(), height = px(10);
  constexpr int kParts = 24;
  for (int n = 0; n < kParts; ++n) {
    const float x = at.x + width * float(n) / kParts, next = at.x + width * float(n + 1) / kParts;
    list->AddRectFilled({x, at.y}, {next, at.y + height}, ink(heat((n + .5) / kParts)));
  }
  const std::string low = fmt::format("{:.3g}", shown.low),
                    high = fmt::format("{:.3g}", shown.high);
  drawText(list, fonts().medium, {at.x, at.y + px(13)}, ink(tint::dim), low);
  drawText(list, fonts().medium, {at.x + width - textWidth(fonts().medium, high), at.y + px(13)},
           ink(tint::dim), high);
  ImGui::Dummy({width, px(29)});
}

void showSection(Atelier& atelier) {
  SolidState& solid = atelier.solid;
  toggle("Control lattice", solid.lattice, "Points and edges that tools take.");
  if (toggle("Smooth surface", solid.surface, "The refined solid.")) atelier.tellSolid();
  toggle("Refined edges", solid.wires, "The refined solid's wireframe.");
  int map = int(solid.map);
  if (choice("Colours", map, {"Plain", "Stiffness", "Mass", "Strain"}, "What its colours say.")) {
    solid.map = SolidMap(map);
    atelier.tellSolid();
  }
  if (solid.map != SolidMap::none) mapScale(*atelier.solidShown());
}

// The numbers among the settings as sliders.
struct SettingSlider {
  const char* label;
  double SolidSettings::*value;
  Slide slide;
  const char* tip;
};
constexpr std::array<SettingSlider, kSolidNumbers.size()> kSliders{{
    {"Time step", &SolidSettings::timeStep, {0.01, 4, "", 1, 2, true}, "Of one step of physics."},
    {"Damping", &SolidSettings::damping, {0, 8, "", 1, 2}, "How soon it comes to rest."},
    {"Stiffness",
     &SolidSettings::stiffness,
     {0.01, 20, "", 1, 2, true},
     "Of the springs along edges."},
    {"Bending", &SolidSettings::angular, {0, 5, "", 1, 2}, "Of the springs at corners."},
    {"Rope", &SolidSettings::ropeStrength, {0.1, 100, "", 1, 1, true}, "How strongly ropes pull."},
    {"Creep",
     &SolidSettings::creep,
     {0, 2, "", 1, 2},
     "How fast the rest shape follows, like clay."},
}};

// Sliders change a copy; it becomes one operation when the hand lets go.
void physicsSection(Atelier& atelier) {
  const SolidSettings now = atelier.solidShown()->solid->settings;
  SolidSettings s = atelier.solid.settings.value_or(now);
  const SolidSettings before = s;
  int solver = int(s.solver);
  if (choice("Solver", solver, {"Standard", "Live", "Explicit", "Implicit"},
             "Standard and live are ours; explicit and implicit are the paper's.")) {
    s.solver = Solver(solver);
  }
  count("Refinement", s.levels, {1, 3, "", 1, 0}, "Between control and mass points.");
  for (const SettingSlider& row : kSliders) slider(row.label, s.*row.value, row.slide, row.tip);
  if (!(s == before)) atelier.solid.settings = s;
  if (atelier.solid.settings && !ImGui::IsAnyItemActive()) {
    const SolidSettings wanted = *std::exchange(atelier.solid.settings, std::nullopt);
    if (!(wanted == now)) atelier.applySolid(operationOf(wanted));
  }
  press(atelier, "Let it move", half(), Command::solidRun);
  ImGui::SameLine();
  press(atelier, "Take as rest", whole(), Command::solidRest);
  if (button("Only in the box", {half(), 0}, ButtonKind::plain,
             "Only points inside the workspace box move; without the box all do.")) {
    atelier.solidWindow();
  }
}

void numberSection(const Atelier& atelier) {
  const SolidShown& shown = *atelier.solidShown();
  factLine("Kind", shown.solid->isWrap() ? "Wrap of the clay" : "Solid of its own");
  factLine("Control points", grouped((long long)shown.control().points.size()));
  factLine("Control cells", grouped((long long)shown.control().cells.size()));
  factLine("Shown cells", grouped((long long)shown.refinedCells), "After refinement.");
  factLine("Shown points", grouped((long long)shown.refinedPoints));
  if (const auto& ran = shown.ran) {
    factLine("Steps", fmt::format("{} of {:.2g} ms", ran->steps, ran->msStep),
             "Of the last physics, and what each took.");
    factLine("Iterations", fmt::format("{:.1f}", ran->iterations), "Of the solver, a step.");
    factLine("Energy", fmt::format("{:.4g}", ran->energy), "Of all springs, at the end.");
    if (ran->rolledBack > 0) factLine("Taken back", grouped(ran->rolledBack), "Steps.");
  }
  const OperationReport& last = atelier.status().last;
  factLine("Last tool", fmt::format("{:.1f} ms", last.msField), "The whole operation.");
}

void toolCell(Atelier& atelier, const SolidToolRow& row, ImVec2 at) {
  const float side = toolPx(44);
  const Command command = Command(int(Command::solidMove) + int(row.tool));
  ImGui::SetCursorScreenPos(at);
  ImGui::PushID(int(row.tool));
  if (hotArea("tool", {side, side})) atelier.run(command);
  const bool hovered = ImGui::IsItemHovered(), chosen = atelier.solid.tool == row.tool;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 high{at.x + side, at.y + side};
  if (chosen || hovered) {
    list->AddRectFilled(at, high,
                        ink(!chosen   ? tint::hover
                            : hovered ? tint::accentHover
                                      : tint::accent),
                        px(9));
  }
  drawSolidIcon(
      list, row.tool, {{at.x + side / 2, at.y + side / 2}, toolPx(12.5f)},
      {chosen ? ink(0xFFFFFF) : ink(tint::icon), chosen ? ink(tint::onAccent) : ink(tint::accent)});
  tooltip(atelier.keymap, command);
  ImGui::PopID();
}

}  // namespace

void solidTools(Atelier& atelier, float left, float& top) {
  for (const SolidToolRow& row : solidToolTable()) {
    const bool starts =
        row.tool == SolidTool::carve || row.tool == SolidTool::mass || row.tool == SolidTool::probe;
    if (starts) {
      const float x = left - px(8);
      ImGui::GetWindowDrawList()->AddLine({x + px(18), top + px(3)}, {x + px(42), top + px(3)},
                                          ink(0xFFFFFF, .08f));
      top += toolPx(9);
    }
    toolCell(atelier, row, {left, top});
    top += toolPx(48);
  }
}

void solidSections(Atelier& atelier) {
  toolOptions(atelier);
  const bool there = atelier.solidShown() != nullptr;
  if (section("Make", !there)) makeSection(atelier);
  if (!there) return;
  if (section("Back to clay")) toClaySection(atelier);
  if (section("Show")) showSection(atelier);
  if (section("Physics", false)) physicsSection(atelier);
  if (section("Numbers", false)) numberSection(atelier);
}

// Where a curve can be taken.
void drawCurve(const PanelContext& context) {
  const Atelier& atelier = context.atelier;
  ImDrawList* list = ImGui::GetBackgroundDrawList();
  const auto controls = atelier.curveControls();
  for (std::size_t n = 0; n < controls.size(); ++n) {
    const glm::dvec2 at = atelier.corner() + pixelOf(atelier.view, atelier.extent(), controls[n]);
    if (!context.layout.viewport.contains(at)) continue;
    const ImVec2 centre{float(at.x), float(at.y)};
    list->AddCircleFilled(centre, px(6), ink(tint::accent), 20);
    list->AddCircle(centre, px(6), ink(atelier.curve().isDragged(n) ? 0xFFFFFF : tint::onAccent),
                    20, px(1.6f));
  }
}

// The tool behind the pointer, and how strongly it is held.
void drawFelt(const PanelContext& context, const FeltHand& hand) {
  const Atelier& atelier = context.atelier;
  ImDrawList* list = ImGui::GetBackgroundDrawList();
  const glm::dvec2 at = atelier.corner() + pixelOf(atelier.view, atelier.extent(), hand.tool());
  if (!context.layout.viewport.contains(at)) return;
  const ImVec2 centre{float(at.x), float(at.y)};
  list->AddCircleFilled(centre, px(5), ink(0xFADB6B), 20);
  list->AddCircle(centre, px(5), ink(tint::onAccent), 20, px(1.4f));
  drawText(list, fonts().semiBold, {centre.x + px(12), centre.y - px(8)}, ink(0xFADB6B),
           fmt::format("{:.2f} N", glm::length(hand.force())));
}

// Points that can be taken, over everything.
void drawSolidPoints(const PanelContext& context) {
  const Atelier& atelier = context.atelier;
  if (atelier.mode() != WorkMode::solid || !atelier.solidShown()) return;
  if (atelier.solid.tool == SolidTool::spline) drawCurve(context);
  if (atelier.feltHand()) drawFelt(context, *atelier.feltHand());
  if (!atelier.solid.lattice) return;
  ImDrawList* list = ImGui::GetBackgroundDrawList();
  const auto& points = atelier.solidShown()->control().points;
  const bool takes = atelier.solidElement() == Element::point;
  for (std::size_t n = 0; n < points.size(); ++n) {
    const glm::dvec2 at = atelier.corner() + pixelOf(atelier.view, atelier.extent(), points[n]);
    if (!context.layout.viewport.contains(at)) continue;
    const bool chosen = takes && atelier.solidHit().element == n;
    list->AddCircleFilled({float(at.x), float(at.y)},
                          px(chosen  ? 6.f
                             : takes ? 3.2f
                                     : 2.f),
                          ink(chosen ? tint::accentHover : tint::second, chosen ? 1 : .9f), 16);
  }
}

}  // namespace bozzetto::ui
