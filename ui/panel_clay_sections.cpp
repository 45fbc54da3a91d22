// Sections of the properties panel: the clay in numbers, what frames and dabs cost.
#include <fmt/format.h>

#include "ui/panels.hpp"
#include "ui/widgets.hpp"

namespace bozzetto::ui {
namespace {

std::string millimetres(const glm::dvec3& size) {
  return fmt::format("{:.4g} × {:.4g} × {:.4g}", size.x, size.y, size.z);
}

}  // namespace

void claySection(Atelier& atelier) {
  const ClayStatistics& counted = atelier.statistics();
  const ClayStatus& status = atelier.status();
  const double spacing = status.scale.spacing;
  const CellBounds& bounds = status.bounds;
  factLine("Triangles", grouped((long long)atelier.patches().triangles()));
  factLine("Mass", fmt::format("{:.6g} mm³", counted.field.mass), "Σ density × cell volume.");
  factLine("Volume", fmt::format("{:.6g} mm³", counted.volume), "Inside the surface.");
  factLine("Area", fmt::format("{:.6g} mm²", counted.area), "Of the surface.");
  if (!bounds.empty()) {
    factLine("Size", millimetres((bounds.high - bounds.low) * spacing) + " mm");
  }
  factLine("Pieces", grouped(counted.components), "Connected surfaces; a cavity counts as one.");
  factLine("Corners", grouped(counted.field.corners), "That hold clay.");
  factLine("Cubes", grouped(counted.cubes), "With at least one corner that holds clay.");
  factLine("Crossing", grouped(counted.crossingCubes), "Cubes that the surface crosses.");
  factLine("Edges", grouped(counted.edges), "That the surface crosses.");
  factLine("Memory", byteText(double(counted.field.bytes)), "Of the clay's blocks and nodes.");
  factLine("Cell", fmt::format("{:.5g} mm", spacing), "World units between corners.");
  factLine("Iso", fmt::format("{:.3g}", status.scale.iso), "Density at the surface.");
  double wanted = atelier.wantedSpacing.value_or(spacing);
  if (slider("New cell size", wanted, {spacing / 4, spacing * 4, "mm", 1, 3, true},
             "Finer or coarser clay, the same shape.")) {
    atelier.wantedSpacing = wanted;
  }
  const bool differs = std::abs(wanted / spacing - 1) > 1e-3;
  ImGui::BeginDisabled(!differs);
  if (button("Resample", {ImGui::GetContentRegionAvail().x, 0}, ButtonKind::plain,
             "Puts the clay on the new grid; can be undone.")) {
    atelier.wantedSpacing.reset();
    atelier.resample(wanted);
  }
  ImGui::EndDisabled();
}

void performanceSection(Atelier& atelier, const FrameFigures& figures) {
  const OperationReport& last = atelier.status().last;
  factLine("Last operation", last.op.empty() ? "none" : last.op);
  factLine("Dabs", grouped(last.dabs));
  factLine("Visited", grouped(last.visited), "Corners in the boxes of the dabs (Ferley §3.2).");
  factLine("Computed", grouped(last.computed), "Of these, in the tool's own box.");
  factLine("Dirty", grouped(last.dirty), "Corners that changed.");
  factLine("Treated", grouped(last.treated), "Cubes examined anew.");
  factLine("Field", fmt::format("{:.2f} ms", last.msField), "All dabs together.");
  factLine("Surface", fmt::format("{:.2f} ms", last.msSurface));
  factLine("History", fmt::format("{:.2f} ms", last.msHistory));
  const char* kinds[] = {"kept", "patched", "drawn", "refined"};
  factLine("Frame",
           fmt::format("{:.1f} ms, {}", figures.milliseconds, kinds[int(figures.viewport.clay)]));
  factLine("Clay drawn", fmt::format("{:.1f} ms", figures.viewport.milliseconds));
  factLine("Triangles drawn", grouped((long long)figures.viewport.triangles));
  factLine("Uploaded", byteText(double(figures.viewport.uploadedBytes)), "Since the frame before.");
  factLine("Patches sent", grouped((long long)figures.uploadedPatches), "In the last frame.");
}

}  // namespace bozzetto::ui
