// What solid mode draws over the clay: lattice, wires, what the tool would take, the curve.
#include <glm/geometric.hpp>

#include "bozzetto/solid/tools.hpp"
#include "ui/atelier.hpp"

namespace bozzetto::ui {
namespace {

Polyline lineOf(std::vector<glm::dvec3> points, Ink colour, float width) {
  Polyline line;
  line.points = std::move(points);
  line.ink = colour;
  line.width = width;
  return line;
}

constexpr Ink kLattice{.373f, .722f, .788f, .9f};
constexpr Ink kAround{.373f, .722f, .788f, .35f};  // of a wrap: the clay is what one looks at
constexpr Ink kWires{.09f, .11f, .14f, .38f};
constexpr Ink kChosen{.941f, .541f, .365f, 1}, kFaint{.941f, .541f, .365f, .45f};
constexpr Ink kForce{.98f, .86f, .42f, 1};

std::vector<glm::dvec3> inCells(std::vector<glm::dvec3> places, double spacing) {
  for (glm::dvec3& place : places) place /= spacing;
  return places;
}

}  // namespace

void Atelier::addSolid(Overlays& overlays) const {
  if (mode_ != WorkMode::solid || !solidShown_) return;
  const double spacing = status_.scale.spacing;
  const Lattice& control = solidShown_->control();
  const Topology& topology = solidShown_->topology;
  if (solid.wires && solid.surface) {
    for (const auto& wire : solidShown_->wires) {
      Polyline line = lineOf({wire[0] / spacing, wire[1] / spacing}, kWires, 1);
      line.hidden = 0;
      overlays.lines.push_back(std::move(line));
    }
  }
  if (solid.lattice) {
    const Ink ink = solidShown_->solid->isWrap() ? kAround : kLattice;
    for (const auto& [a, b] : topology.edges)
      overlays.lines.push_back(
          lineOf({control.points[a] / spacing, control.points[b] / spacing}, ink, 1.3f));
    for (const auto& [a, b] : control.sharpEdges)
      overlays.lines.push_back(
          lineOf({control.points[a] / spacing, control.points[b] / spacing}, kChosen, 2.2f));
  }
  addSolidHit(overlays);
  if (solid.tool == SolidTool::spline) addCurve(overlays);
  addForce(overlays);
}

// From the tool, with a head that faces the viewer.
void Atelier::addForce(Overlays& overlays) const {
  const glm::dvec3 force = feltArrow();
  const double length = glm::length(force), spacing = status_.scale.spacing;
  if (!(length > 0)) return;
  const bool touches = rowOf(solid.tool).grip == SolidGrip::touch;
  const glm::dvec3 from = touches ? solidHit_.place : felt_->tool(), to = from + force;
  const glm::dvec3 across = glm::cross(force, view.back());
  const double wide = glm::length(across);
  std::vector<std::vector<glm::dvec3>> strokes{{from, to}};
  if (wide > 1e-3 * length) {
    const glm::dvec3 back = to - 0.28 * force, side = across * (0.13 * length / wide);
    strokes.push_back({back + side, to, back - side});
  }
  for (auto& stroke : strokes) {
    overlays.lines.push_back(lineOf(inCells(std::move(stroke), spacing), kForce, 3));
    overlays.lines.back().hidden = 1;
  }
}

// Through its points, and between its controls.
void Atelier::addCurve(Overlays& overlays) const {
  constexpr int kCuts = 16;
  const auto controls = curveControls();
  if (controls.size() < 2) return;
  const double spacing = status_.scale.spacing;
  overlays.lines.push_back(lineOf(inCells(controls, spacing), kFaint, 1.2f));
  overlays.lines.push_back(lineOf(inCells(splineCurve(controls, kCuts), spacing), kChosen, 2.4f));
  for (Polyline& line : std::span(overlays.lines).last(2)) line.hidden = .7f;
}

// What the tool would take.
void Atelier::addSolidHit(Overlays& overlays) const {
  if (solidHit_.element == kNoId || !hover_.inside) return;
  const double spacing = status_.scale.spacing;
  const Lattice& control = solidShown_->control();
  const Topology& topology = solidShown_->topology;
  const SolidToolRow& row = rowOf(solid.tool);
  const auto edge = [&](Id n) {
    const auto& [a, b] = topology.edges[n];
    overlays.lines.push_back(
        lineOf({control.points[a] / spacing, control.points[b] / spacing}, kChosen, 3));
  };
  if (row.reach == SolidReach::control) {
    if (solidElement() == Element::cell)
      for (const Id n : topology.cellEdges[solidHit_.element]) edge(n);
    if (solidElement() == Element::face)
      for (const Id n : topology.faceEdges[solidHit_.element]) edge(n);
    if (solidElement() == Element::edge) edge(solidHit_.element);
  }
  if (gesture_ == Gesture::solid && row.grip == SolidGrip::drag)
    overlays.lines.push_back(lineOf({solidHit_.place / spacing, dragged_ / spacing}, kChosen, 2));
  if (row.grip != SolidGrip::brush) return;
  RingCursor ring;
  ring.centre = solidHit_.place / spacing;
  ring.normal = view.back();
  ring.radius = solid.radius / spacing;
  ring.on = RingCursor::On::air;
  overlays.rings.push_back(ring);
}

}  // namespace bozzetto::ui
