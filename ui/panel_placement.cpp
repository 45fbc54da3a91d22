// Sections of the properties panel: what a stamp leaves, how dabs stand.
#include <algorithm>
#include <cmath>

#include "ui/panels.hpp"
#include "ui/widgets.hpp"

namespace bozzetto::ui {
namespace {

// def(d) from the tool's core outward: what the clay loses inside, what rises round it.
void stampPlot(const StampOptions& options, double iso) {
  const StampCurve curve(clamped(options, iso), iso);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = px(96);
  list->AddRectFilled(at, {at.x + width, at.y + height}, ink(0x141518), px(6));
  const double end = std::max(curve.end() * 1.15, 1.2);
  const float zero = at.y + height * .5f;
  const auto place = [&](double d) {
    return ImVec2(at.x + px(8) + (width - px(16)) * float(d / end),
                  zero - height * .42f * float(std::clamp(curve(d), -1.0, 1.0)));
  };
  list->AddLine({at.x + px(8), zero}, {at.x + width - px(8), zero}, ink(0xFFFFFF, .10f));
  const float surface = place(curve.surface()).x;
  list->AddLine({surface, at.y + px(6)}, {surface, at.y + height - px(6)}, ink(0xFFFFFF, .10f));
  constexpr int kSteps = 96;
  ImVec2 points[kSteps + 1];
  for (int n = 0; n <= kSteps; ++n) points[n] = place(end * n / kSteps);
  const ImDrawListFlags flags = list->Flags;
  list->Flags &= ~ImDrawListFlags_AntiAliasedFill;  // strips would show seams
  for (int n = 0; n < kSteps; ++n) {
    const ImVec2 strip[] = {points[n], points[n + 1], {points[n + 1].x, zero}, {points[n].x, zero}};
    const bool rises = points[n].y < zero;
    list->AddConvexPolyFilled(strip, 4, ink(rises ? tint::accent : tint::second, .28f));
  }
  list->Flags = flags;
  list->AddPolyline(points, kSteps + 1, ink(0xF19A6F), 0, px(2));
  drawText(list, fonts().medium, {at.x + px(10), at.y + px(7)}, ink(tint::faint), "inside");
  drawText(list, fonts().medium, {surface + px(7), at.y + height - px(20)}, ink(tint::faint),
           "surface");
  ImGui::Dummy({width, height});
  tooltip("What the clay gains or loses, from the tool's core to beyond its surface.");
}

}  // namespace

void stampSection(Atelier& atelier) {
  StampOptions& stamp = atelier.sculpt.stamp;
  stampPlot(stamp, atelier.status().scale.iso);
  slider("Crest", stamp.height, {0, 1, "%", 100, 0}, "How high the clay rises round the print.");
  slider("Rise", stamp.rise, {0.01, 1, "%", 100, 0},
         "From the print's rim to the crest, of the tool's radius.");
  slider("Fall", stamp.fall, {0.01, 2, "%", 100, 0},
         "From the crest to where the clay is as before, of the tool's radius.");
  slider("Slope", stamp.slope, {0, 6, "", 1, 2}, "How steep the clay stands at the rim.");
  int profile = int(stamp.profile);
  if (choice("Measured", profile, {"by potential", "by radius"},
             "What rise and fall are measured by: the tool's potential, as Ferley has it, or the "
             "distance in parts of its radius.")) {
    stamp.profile = StampProfile(profile);
  }
  toggle("Keeps the mass", stamp.conserving, "What rises weighs what the print takes.");
  // Sliders may ask for more than there is a curve for.
  const StampOptions fits = clamped(stamp, atelier.status().scale.iso);
  if (!ImGui::IsAnyItemActive()) stamp = fits;
}

void placementSection(Atelier& atelier) {
  Placement& placement = atelier.sculpt.placement;
  Jitter& jitter = placement.jitter;
  toggle("Face the surface", placement.toNormal,
         "Every dab turns the tool's contact side to the clay.");
  toggle("Follow the stroke", placement.alongStroke, "Every dab turns the tool along the stroke.");
  toggle(
      "One print, dragged", placement.anchored,
      "Press where it stands; drag gives its size and, if it follows the stroke, its direction.");
  slider("Scatter", jitter.position, {0, 3, "%", 100, 0}, "Off the line, in tool radii.");
  slider("Vary size", jitter.size, {0, 1, "%", 100, 0}, "Dabs are up to so much smaller.");
  slider("Vary turn", jitter.rotation, {0, 180, "°", 1, 0}, "Dabs are turned up to so much.");
  slider("Roll", placement.roll, {-2, 2, "×", 1, 2}, "Turns as it goes; 1 rolls without sliding.");
  const double cell = atelier.status().scale.spacing;
  slider("Grid", placement.grid, {0, 64 * cell, "mm", 1, 1}, "Dabs stand on multiples of this.");
  const char* names[] = {"Copies right", "Copies up", "Copies back"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double count = placement.copies[axis];
    if (slider(names[axis], count, {1, 12, "×", 1, 0}, "An array of prints, along an axis.")) {
      placement.copies[axis] = int(std::lround(count));
      if (placement.copyStep == glm::dvec3(0)) {
        placement.copyStep = glm::dvec3(2 * atelier.sculpt.size);
      }
    }
  }
  double step = std::max({placement.copyStep.x, placement.copyStep.y, placement.copyStep.z});
  const int copies = placement.copies[0] * placement.copies[1] * placement.copies[2];
  if (copies > 1 && slider("Between copies", step, {cell, 128 * cell, "mm", 1, 1, true},
                           "From one to the next.")) {
    placement.copyStep = glm::dvec3(step);
  }
  const float half = (ImGui::GetContentRegionAvail().x - px(8)) / 2;
  if (button("Other chance", {half, 0}, ButtonKind::plain, "Scatters and varies anew.")) {
    ++jitter.seed;
  }
  ImGui::SameLine();
  if (button("Plain", {half, 0}, ButtonKind::plain, "As the line goes, nothing else.")) {
    placement = {};
  }
}

}  // namespace bozzetto::ui
