// The sixteen tools on solids. Each is one step of history; probing is none.
#include "bozzetto/field/sampler.hpp"
#include "sculptor/run_solid.hpp"
#include "sculptor/timer.hpp"

namespace bozzetto {
namespace {

Id nearestOf(const Solid& solid, Element element, const glm::dvec3& at,
             PickFrom from = PickFrom::everywhere) {
  return nearest(solid.control, Topology(solid.control), element, at, from);
}

void tell(const RunReport& report, const Telling& telling) {
  telling.report.physics = report;
  if (report.rolledBack == 0) return;
  telling.progress.note(fmt::format(
      "{}: {} of {} steps taken back: the solid would have exploded or turned inside out",
      telling.report.op, report.rolledBack, report.steps));
}

Solid worked(const Solid& solid, const SolidCarveOperation& tool, const Telling&) {
  return carved(solid, nearestOf(solid, Element::cell, tool.at));
}
Solid worked(const Solid& solid, const SolidExtrudeOperation& tool, const Telling&) {
  return extruded(solid, nearestOf(solid, Element::face, tool.at, PickFrom::boundary), tool.length);
}
Solid worked(const Solid& solid, const SolidJoinOperation& tool, const Telling& telling) {
  std::string warning;
  Solid result = joined(solid, nearestOf(solid, Element::face, tool.at, PickFrom::boundary),
                        nearestOf(solid, Element::face, tool.to, PickFrom::boundary), &warning);
  if (!warning.empty()) telling.progress.note(warning);
  return result;
}
Solid worked(const Solid& solid, const SolidSubdivideOperation& tool, const Telling&) {
  return subdivided(solid, nearestOf(solid, Element::cell, tool.at));
}
Solid worked(const Solid& solid, const SolidSharpOperation& tool, const Telling&) {
  const Id n = nearestOf(solid, tool.element, tool.at, PickFrom::boundary);
  return sharpened(solid, tool.element, n, tool.sharp);
}
Solid worked(const Solid& solid, const SolidPullOperation& tool, const Telling& telling) {
  RunReport report;
  const double strength = tool.strength.value_or(solid.settings.ropeStrength);
  Solid result = pulled(solid, tool.ropes, strength, tool.steps, &report);
  tell(report, telling);
  return result;
}
Solid worked(const Solid& solid, const SolidRunOperation& tool, const Telling& telling) {
  RunReport report;
  Solid result = pulled(solid, {}, 0, tool.steps, &report);
  tell(report, telling);
  return result;
}
Solid worked(const Solid& solid, const SolidSplineOperation& tool, const Telling& telling) {
  RunReport report;
  Solid result = splined(solid, tool.points, tool.drags, tool.steps, &report);
  tell(report, telling);
  return result;
}
Solid worked(const Solid& solid, const SolidPaintOperation& tool, const Telling&) {
  return painted(solid, tool.matter, tool.at, tool.radius, tool.factor);
}
Solid worked(const Solid& solid, const SolidInflateOperation& tool, const Telling& telling) {
  RunReport report;
  const Solid grown = inflated(solid, tool.at, tool.radius, tool.amount);
  Solid result = pulled(grown, {}, 0, tool.steps, &report);
  tell(report, telling);
  return result;
}
Solid worked(const Solid& solid, const SolidTrimOperation& tool, const Telling&) {
  return trimmed(solid, tool.at, tool.radius, tool.part);
}
Solid worked(const Solid& solid, const SolidWindowOperation& tool, const Telling&) {
  return windowed(solid, tool.box);
}
Solid worked(const Solid& solid, const SolidRestOperation&, const Telling&) {
  return atRest(solid);
}
Solid worked(const Solid& solid, const SolidSettingsOperation& tool, const Telling&) {
  Solid result = solid;
  SolidSettings& s = result.settings;
  s.solver = tool.solver.value_or(s.solver);
  for (const SolidNumber& number : kSolidNumbers)
    s.*number.value = (tool.*number.wanted).value_or(s.*number.value);
  // Mass points of another level are others: what they were is forgotten.
  if (tool.levels && *tool.levels != s.levels) {
    s.levels = *tool.levels;
    result.matter = {{}, {}, {}, {}, {}, result.matter.fixed, result.matter.velocity};
  }
  requireValid(s);
  return result;
}

template <class Tool, int Side>
void runTool(const Tool& tool, Workbench<Side>& bench, const Telling& telling) {
  Solid result;
  {
    const Timer timer(telling.report.msField);
    result = worked(solidOf(bench, telling.report.op.c_str()), tool, telling);
  }
  keepSolid(bench, std::move(result), telling.report);
}

}  // namespace

template <int Side>
void run(const SolidFromClayOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  const Field<Side>& field = bench.field();
  FieldSampler<Side> sampler(field);
  keepSolid(
      bench,
      newSolid(coarseBlock(clayBox(field), operation.cells,
                           [&](const glm::dvec3& middle) {
                             const auto place = cellPoint({0, 0, 0}, middle / field.scale.spacing);
                             return sampler.value(place) >= field.scale.iso;
                           })),
      telling.report);
}

template <int Side>
void run(const SolidProbeOperation& operation, Workbench<Side>& bench, const Telling& telling) {
  const Solid& solid = solidOf(bench, "solid_probe");
  telling.progress.note(fmt::format("solid_probe: stiffness {:.6g}",
                                    probedStiffness(solid, operation.at, operation.radius)));
}

#define BOZZETTO_SOLID_TOOL(Kind)                                                   \
  template <int Side>                                                               \
  void run(const Kind& operation, Workbench<Side>& bench, const Telling& telling) { \
    runTool(operation, bench, telling);                                             \
  }                                                                                 \
  BOZZETTO_RUNS(Kind)

BOZZETTO_SOLID_TOOL(SolidCarveOperation);
BOZZETTO_SOLID_TOOL(SolidExtrudeOperation);
BOZZETTO_SOLID_TOOL(SolidJoinOperation);
BOZZETTO_SOLID_TOOL(SolidSubdivideOperation);
BOZZETTO_SOLID_TOOL(SolidSharpOperation);
BOZZETTO_SOLID_TOOL(SolidPullOperation);
BOZZETTO_SOLID_TOOL(SolidRunOperation);
BOZZETTO_SOLID_TOOL(SolidSplineOperation);
BOZZETTO_SOLID_TOOL(SolidPaintOperation);
BOZZETTO_SOLID_TOOL(SolidInflateOperation);
BOZZETTO_SOLID_TOOL(SolidTrimOperation);
BOZZETTO_SOLID_TOOL(SolidWindowOperation);
BOZZETTO_SOLID_TOOL(SolidRestOperation);
BOZZETTO_SOLID_TOOL(SolidSettingsOperation);
BOZZETTO_RUNS(SolidFromClayOperation);
BOZZETTO_RUNS(SolidProbeOperation);

}  // namespace bozzetto
