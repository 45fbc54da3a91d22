// Sections of the properties panel: how clay gives way, what stands in its way, what is held.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ui/icons.hpp"
#include "ui/panels.hpp"
#include "ui/widgets.hpp"

namespace bozzetto::ui {
namespace {

using clay::LayerKind;

struct LayerRow {
  LayerKind layer;
  const char* name;
  const char* tip;
};
constexpr std::array<LayerRow, 5> kLayers{{
    {LayerKind::displacement, "Displacement", "Clay moves with the tool, less the farther it is."},
    {LayerKind::conservation, "Conservation", "No room where tools are, no cell fuller than full."},
    {LayerKind::tension, "Surface tension", "No dust, no crumbs; clay parts at weak points."},
    {LayerKind::diffusion, "Diffusion", "Pushed matter walks out along the tool's normals."},
    {LayerKind::automaton, "Automaton", "Blocks of cells share what is too much."},
}};

const LayerRow& rowOf(LayerKind layer) {
  return *std::ranges::find(kLayers, layer, &LayerRow::layer);
}

bool runs(const clay::Settings& settings, LayerKind layer) {
  return std::ranges::find(settings.layers, layer) != settings.layers.end();
}

// Those of the order that run.
std::vector<LayerKind> running(const clay::Settings& settings,
                               const std::vector<LayerKind>& order) {
  std::vector<LayerKind> found;
  for (const LayerKind layer : order)
    if (runs(settings, layer)) found.push_back(layer);
  return found;
}

// A layer that is switched off keeps its place. Where others came in the meantime, of another
// document or tool, these come first.
void putInOrder(const clay::Settings& settings, std::vector<LayerKind>& order) {
  if (!order.empty() && running(settings, order) == settings.layers) return;
  order.clear();
  const auto add = [&](LayerKind layer) {
    if (std::ranges::find(order, layer) == order.end()) order.push_back(layer);
  };
  for (const LayerKind layer : settings.layers) add(layer);
  for (const LayerRow& row : kLayers) add(row.layer);
}

// A small arrow that moves a layer towards the start.
bool earlier(ImVec2 centre) {
  const float r = px(9);
  ImGui::SetCursorScreenPos({centre.x - r, centre.y - r});
  const bool clicked = hotArea("earlier", {2 * r, 2 * r});
  const ImU32 colour = ink(ImGui::IsItemHovered() ? tint::text : tint::faint);
  tooltip("Runs earlier.");
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->PathLineTo({centre.x - px(4), centre.y + px(2)});
  list->PathLineTo({centre.x, centre.y - px(2)});
  list->PathLineTo({centre.x + px(4), centre.y + px(2)});
  list->PathStroke(colour, 0, px(1.5f));
  return clicked;
}

// True when it runs otherwise now: off, on, or sooner.
bool layerLine(const clay::Settings& settings, std::vector<LayerKind>& order, LayerKind layer,
               bool& on) {
  const LayerRow& row = rowOf(layer);
  ImGui::PushID(row.name);
  const std::vector<LayerKind> now = running(settings, order);
  const auto at = std::ranges::find(now, layer);
  const auto number = at - now.begin();
  on = at != now.end();
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const std::string name = on ? fmt::format("{}  {}", number + 1, row.name) : row.name;
  bool changed = false;
  // The arrow lies on the line and takes its clicks first.
  if (on && number > 0) {
    if (earlier({start.x + width - px(44), start.y + px(9)})) {
      std::iter_swap(std::ranges::find(order, layer), std::ranges::find(order, *(at - 1)));
      changed = true;
    }
    ImGui::SetItemAllowOverlap();
    ImGui::SetCursorScreenPos(start);
  }
  changed |= toggle(name.c_str(), on, row.tip);
  ImGui::PopID();
  return changed;
}

void layerLines(SculptState& sculpt) {
  putInOrder(sculpt.clay, sculpt.layerOrder);
  const std::vector<LayerKind> rows = sculpt.layerOrder;
  for (const LayerKind layer : rows) {
    bool on = false;
    if (!layerLine(sculpt.clay, sculpt.layerOrder, layer, on)) continue;
    std::vector<LayerKind> wanted;
    for (const LayerKind each : sculpt.layerOrder)
      if (each == layer ? on : runs(sculpt.clay, each)) wanted.push_back(each);
    sculpt.clay.layers = std::move(wanted);
  }
}

void diffusion(clay::Settings& settings) {
  slider("Viscosity", settings.viscosity, {0, 16, "cells", 1, 1},
         "How far pushed matter spreads sideways.");
  slider("Longest walk", settings.walk, {0.1, 8, "×", 1, 1, true}, "In radii of the tool.");
  const std::array<std::array<double, 2>, 3> profiles{clay::kUniform, clay::kLinear,
                                                      clay::kGaussian};
  int profile = int(std::ranges::find(profiles, settings.profile) - profiles.begin());
  if (choice("Spreads", profile, {"Even", "Straight", "Bell"}, "How what spreads is shared out.")) {
    settings.profile = profiles[std::size_t(profile)];
  }
}

void automaton(clay::Settings& settings) {
  slider("Rate", settings.rate, {0, 1, "%", 100, 0}, "The share that a cell gives.");
  slider("Threshold", settings.threshold, {0.5, 2, "", 1, 2}, "What is more is given.");
  double sweeps = settings.sweeps;
  if (slider("Sweeps", sweeps, {1, 200, "", 1, 0, true}, "At most, at every step.")) {
    settings.sweeps = int(std::lround(sweeps));
  }
  int sharing = int(settings.sharing);
  if (choice("Blocks share", sharing, {"No more than needed", "As in the paper"},
             "How blocks share.")) {
    settings.sharing = clay::SharingRule(sharing);
  }
}

}  // namespace

void movingSection(Atelier& atelier) {
  clay::Settings& settings = atelier.sculpt.clay;
  slider("Stiffness", settings.stiffness, {0, 1, "%", 100, 0},
         "0 fluid: only what is near gives way; 100 dry: the piece follows.");
  layerLines(atelier.sculpt);
  int scheme = int(settings.scheme);
  if (choice("Scheme", scheme, {"Projected", "Paper", "In sweeps"},
             "Projected holds at today's sizes; the paper's is Dewaele and Cani to the letter; in "
             "sweeps: the same, but mirrored halves stay alike.")) {
    settings.scheme = clay::Scheme(scheme);
  }
  slider("Parting", settings.parting, {0, 4, "", 1, 1}, "How easily thin clay tears.");
  slider("Distance offset", settings.distanceOffset, {0, 64, "cells", 1, 0},
         "More: tools lead less far.");
  double crumb = settings.crumb;
  if (slider("Crumbs", crumb, {0, 64, "cells", 1, 0},
             "Smaller pieces are eaten; 0 lets them lie.")) {
    settings.crumb = int(std::lround(crumb));
  }
  if (runs(settings, LayerKind::diffusion)) diffusion(settings);
  if (runs(settings, LayerKind::automaton)) automaton(settings);
  double steps = atelier.relaxSteps;
  if (slider("Relax steps", steps, {1, 100, "", 1, 0, true}, "How often the layers run.")) {
    atelier.relaxSteps = int(std::lround(steps));
  }
  if (button("Relax", {ImGui::GetContentRegionAvail().x, 0}, ButtonKind::plain,
             "Runs the layers without a tool; one step to undo.")) {
    atelier.run(Command::relax);
  }
  if (!ImGui::IsAnyItemActive()) atelier.tellClay();
}

namespace {

std::string part(double change, double whole) {
  if (!(std::abs(whole) > 0)) return "0";
  return fmt::format("{:+.3g} ppm", 1e6 * change / whole);
}

}  // namespace

void ledgerSection(Atelier& atelier) {
  const ClayStatus& status = atelier.status();
  const OperationReport& last = status.last;
  const double mass = last.op.empty() ? atelier.statistics().field.mass : status.mass;
  factLine("Mass now", fmt::format("{:.8g} mm³", mass), "Σ density × cell volume, exact.");
  const double change = last.op.empty() ? 0 : last.massAfter - last.massBefore;
  factLine("Last change", fmt::format("{:+.4g} mm³", change), "By what was done last.");
  const MassLedger& ledger = status.ledger;
  const double before = mass - ledger.total();
  factLine("Before", fmt::format("{:.8g} mm³", std::abs(before) < 1e-9 * mass ? 0 : before),
           "What was there when the account began.");
  factLine("Added", fmt::format("{:.6g} mm³", ledger.added), "By strokes and shapes that give.");
  factLine("Removed", fmt::format("{:.6g} mm³", ledger.removed), "By those that take.");
  if (ledger.dropped > 0)
    factLine("Smoothed away", fmt::format("{:.4g} mm³", ledger.dropped), "Of what was removed.");
  factLine("Moved without loss", grouped((long long)ledger.moves),
           "Strokes that move clay, and relaxations.");
  factLine("Drift of these", part(ledger.drift, mass), "All together; 1 ppm is promised.");
}

void holdSection(Atelier& atelier) {
  double shown = atelier.options.look.holdTint;
  if (slider("Tint", shown, {0, 1, "%", 100, 0},
             "How much held clay is tinted, and what is painted stiff or soft.")) {
    atelier.options.look.holdTint = float(shown);
  }
  const float half = (ImGui::GetContentRegionAvail().x - px(8)) / 2;
  if (button("Hold the box", {half, 0}, ButtonKind::plain,
             "Holds all clay in the workspace box; the first click shows the box.")) {
    atelier.run(Command::holdBox);
  }
  ImGui::SameLine();
  if (button("Let all go", {half, 0}, ButtonKind::plain,
             "Nothing is held any more, nor painted stiff or soft.")) {
    atelier.run(Command::releaseHold);
  }
}

namespace {

const char* nameOf(Shape shape) {
  constexpr const char* names[] = {"Ball", "Box", "Cylinder", "Capsule", "Sculpture"};
  return names[int(shape)];
}

void supportLine(Atelier& atelier, std::size_t n, const clay::Support& support) {
  ImGui::PushID(int(n));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const bool chosen = atelier.chosenSupport == n;
  const std::string text = fmt::format("{} {}", nameOf(support.shape), n + 1);
  if (ImGui::Selectable(text.c_str(), chosen, 0, {width - px(30), 0})) {
    atelier.chosenSupport = chosen ? std::nullopt : std::optional(n);
  }
  tooltip("Choose it, then drag its knob in the view, or take it away with Delete.");
  ImGui::SameLine();
  ImGui::SetCursorScreenPos({at.x + width - px(22), at.y});
  if (hotArea("drop", {px(20), px(20)})) atelier.dropSupport(n);
  tooltip("Takes it away.");
  const ImVec2 middle{at.x + width - px(12), at.y + px(9)};
  const ImU32 colour = ink(ImGui::IsItemHovered() ? tint::text : tint::faint);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float d = px(4);
  list->AddLine({middle.x - d, middle.y - d}, {middle.x + d, middle.y + d}, colour, px(1.5f));
  list->AddLine({middle.x - d, middle.y + d}, {middle.x + d, middle.y - d}, colour, px(1.5f));
  ImGui::PopID();
}

// How large it is, where it stands and how it is turned; done when the pointer lets go.
void placeOf(Atelier& atelier, std::size_t n) {
  clay::Support support = atelier.status().clay.supports[n];
  const double cell = atelier.status().scale.spacing;
  const char* sizes[] = {"Half width", "Half height", "Half depth"};
  const char* places[] = {"At x", "At y", "At z"};
  bool changed = false;
  for (int axis = 0; axis < 3; ++axis) {
    changed |= slider(sizes[axis], support.radii[axis], {cell, 256 * cell, "mm", 1, 1, true},
                      "Of the support.");
  }
  for (int axis = 0; axis < 3; ++axis) {
    const double around = 256 * cell * std::round(support.centre[axis] / (256 * cell));
    changed |= slider(places[axis], support.centre[axis],
                      {around - 256 * cell, around + 256 * cell, "mm", 1, 1},
                      "Of its middle. Drag the knob in the view; with Ctrl nearer and farther.");
  }
  changed |= turnSliders(support.rotation, "Of the support. Shift and the knob turn it by hand.");
  if (changed) atelier.moveSupport(n, support);
  const bool held = changed || ImGui::IsAnyItemActive() || atelier.gesture() == Gesture::support;
  if (!held) atelier.settleSupport();
}

}  // namespace

void supportSection(Atelier& atelier) {
  const auto& supports = atelier.status().clay.supports;
  for (std::size_t n = 0; n < supports.size(); ++n) supportLine(atelier, n, supports[n]);
  if (atelier.chosenSupport && *atelier.chosenSupport < supports.size())
    placeOf(atelier, *atelier.chosenSupport);
  const float half = (ImGui::GetContentRegionAvail().x - px(8)) / 2;
  if (button("Table", {half, 0}, ButtonKind::plain, "A board under the clay, as wide as it.")) {
    atelier.run(Command::placeTable);
  }
  ImGui::SameLine();
  if (button("The tool", {half, 0}, ButtonKind::plain,
             "A support like the tool in your hand, at the middle of the view; with its key: under "
             "the pointer.")) {
    atelier.placeToolAsSupport(atelier.view.target);
  }
}

void drawSupportKnobs(const PanelContext& context) {
  const Atelier& atelier = context.atelier;
  ImDrawList* list = ImGui::GetBackgroundDrawList();
  const auto& supports = atelier.status().clay.supports;
  for (std::size_t n = 0; n < supports.size(); ++n) {
    const glm::dvec2 at =
        atelier.corner() + pixelOf(atelier.view, atelier.extent(), supports[n].centre);
    if (!context.layout.viewport.contains(at)) continue;
    const ImVec2 centre{float(at.x), float(at.y)};
    const bool chosen = atelier.chosenSupport == n;
    list->AddCircleFilled(centre, px(7), ink(tint::bar, .8f), 24);
    list->AddCircleFilled(centre, px(chosen ? 5.f : 4.f), ink(chosen ? tint::second : tint::icon),
                          24);
  }
}

}  // namespace bozzetto::ui
