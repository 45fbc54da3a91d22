// Sections of the properties panel: what a stamp leaves, how dabs stand.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/panels.hpp"
#include "ui/widgets.hpp"

namespace bozzetto::ui {
namespace {

// Where def(d) is drawn, from the tool's core outward.
struct Plot {
  ImVec2 at, size;
  double curveEnd, end;  // d of the curve's end, and at the right
  float zero() const { return at.y + size.y * .5f; }
  float perUnit() const { return (size.x - px(16)) / float(end); }
  ImVec2 place(double d, double value) const {
    return {at.x + px(8) + perUnit() * float(d),
            zero() - size.y * .42f * float(std::clamp(value, -1.0, 1.0))};
  }
};

// What the clay loses inside, what rises round it.
void drawCurve(const StampCurve& curve, const Plot& plot) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  constexpr int kSteps = 96;
  ImVec2 points[kSteps + 1];
  for (int n = 0; n <= kSteps; ++n) {
    const double d = plot.end * n / kSteps;
    points[n] = plot.place(d, curve(d));
  }
  const float zero = plot.zero();
  const ImDrawListFlags flags = list->Flags;
  list->Flags &= ~ImDrawListFlags_AntiAliasedFill;  // strips would show seams
  for (int n = 0; n < kSteps; ++n) {
    const ImVec2 strip[] = {points[n], points[n + 1], {points[n + 1].x, zero}, {points[n].x, zero}};
    const bool rises = points[n].y < zero;
    list->AddConvexPolyFilled(strip, 4, ink(rises ? tint::accent : tint::second, .28f));
  }
  list->Flags = flags;
  list->AddPolyline(points, kSteps + 1, ink(0xF19A6F), 0, px(2));
}

// The crest and the end of the fall; the one that is nearer is dragged.
void dragHandles(StampOptions& stamp, const StampOptions& fits, const Plot& plot) {
  const std::array<ImVec2, 2> handles{plot.place(plot.curveEnd - fits.fall, fits.height),
                                      plot.place(plot.curveEnd, 0)};
  const ImVec2 pointer = ImGui::GetIO().MousePos, by = ImGui::GetIO().MouseDelta;
  const auto farness = [&](const ImVec2& p) {
    return std::hypot(p.x - pointer.x, p.y - pointer.y);
  };
  int* dragged = ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("curve"));
  if (ImGui::IsItemActivated()) *dragged = farness(handles[1]) < farness(handles[0]) ? 1 : 0;
  const bool moves = ImGui::IsItemActive() && (by.x != 0 || by.y != 0);
  if (moves && *dragged == 0) {  // from where they are drawn
    stamp.rise = std::clamp(fits.rise + by.x / plot.perUnit(), 0.01, 1.0);
    stamp.height = std::clamp(fits.height - by.y / (plot.size.y * .42), 0.0, 1.0);
  } else if (moves) {
    stamp.fall = std::clamp(fits.fall + by.x / plot.perUnit(), 0.01, 2.0);
  }
  for (const ImVec2& handle : handles) {
    ImGui::GetWindowDrawList()->AddCircleFilled(handle, px(5), ink(tint::panel), 24);
    ImGui::GetWindowDrawList()->AddCircleFilled(handle, px(3.6f), ink(tint::knob), 24);
  }
}

void stampPlot(StampOptions& stamp, double iso) {
  const StampOptions fits = clamped(stamp, iso);
  const StampCurve curve(fits, iso);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const Plot plot{ImGui::GetCursorScreenPos(),
                  {ImGui::GetContentRegionAvail().x, px(96)},
                  curve.end(),
                  std::max(curve.end() * 1.15, 1.2)};
  const ImVec2 at = plot.at, size = plot.size;
  list->AddRectFilled(at, {at.x + size.x, at.y + size.y}, ink(0x141518), px(6));
  list->AddLine({at.x + px(8), plot.zero()}, {at.x + size.x - px(8), plot.zero()},
                ink(0xFFFFFF, .10f));
  const float surface = plot.place(curve.surface(), 0).x;
  list->AddLine({surface, at.y + px(6)}, {surface, at.y + size.y - px(6)}, ink(0xFFFFFF, .10f));
  drawCurve(curve, plot);
  drawText(list, fonts().medium, {at.x + px(10), at.y + px(7)}, ink(tint::faint), "inside");
  drawText(list, fonts().medium, {surface + px(7), at.y + size.y - px(20)}, ink(tint::faint),
           "surface");
  hotArea("curve", size);
  if (!ImGui::IsItemActive())
    tooltip(
        "What the clay gains or loses, from the tool's core to beyond its surface. Drag the "
        "crest, or the end of the fall.");
  dragHandles(stamp, fits, plot);
}

}  // namespace

void stampSection(Atelier& atelier) {
  StampOptions& stamp = atelier.sculpt.stamp;
  stampPlot(stamp, atelier.status().scale.iso);
  ImGui::BeginDisabled(stamp.conserving);  // then it is found
  slider("Crest", stamp.height, {0, 1, "%", 100, 0}, "How high the clay rises round the print.");
  ImGui::EndDisabled();
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
  // What was asked for stays, for the other profile, or a higher crest, may have a curve for it.
  const StampOptions fits = clamped(stamp, atelier.status().scale.iso);
  if (fits != stamp)
    factLine(
        "Fits",
        fmt::format("{:.0f} % · {:.0f} % · {:.2f}", 100 * fits.rise, 100 * fits.fall, fits.slope),
        "There is no curve for the rise, fall and slope that are asked for: these act, and "
        "are drawn.");
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
  ImGui::BeginDisabled(placement.anchored);
  slider("Scatter", jitter.position, {0, 3, "%", 100, 0}, "Off the line, in tool radii.");
  slider("Vary size", jitter.size, {0, 1, "%", 100, 0}, "Dabs are up to so much smaller.");
  slider("Vary turn", jitter.rotation, {0, 180, "°", 1, 0}, "Dabs are turned up to so much.");
  slider("Roll", placement.roll, {-2, 2, "×", 1, 2}, "Turns as it goes; 1 rolls without sliding.");
  ImGui::EndDisabled();
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
