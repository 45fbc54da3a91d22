#include "ui/solid_state.hpp"

#include <array>

namespace bozzetto::ui {
namespace {

using enum SolidTool;
using enum SolidReach;

constexpr std::array<SolidToolRow, kSolidToolCount> kTools{{
    {move, "Move a point", "Move the point", "", "a control point follows the hand",
     "Drags a control point of the lattice.", control, Element::point, SolidGrip::drag},
    {rope, "Rope", "Pull by a rope", "", "the solid is pulled and gives way",
     "A spring from the surface to the pointer; then physics.", surface, Element::face,
     SolidGrip::drag},
    {spline, "Curve", "Add a point to the curve", "Take the point out",
     "a curve through points; drag its controls",
     "Click points of the surface, then drag the controls of the curve through them.", surface,
     Element::face, SolidGrip::curve},
    {carve, "Carve a cell", "Carve the cell", "", "one control cell goes",
     "Removes the control cell under the pointer.", control, Element::cell, SolidGrip::click},
    {extrude, "Extrude", "Extrude the face", "", "a cell grows from a face",
     "A cell grows from the face under the pointer.", control, Element::face, SolidGrip::click},
    {join, "Join", "Join faces", "", "a cell between two faces",
     "Click one face, then another: a cell joins them.", control, Element::face, SolidGrip::click},
    {subdivide, "Subdivide", "Split the cell", "", "one cell becomes many",
     "Splits the cell under the pointer as refinement would.", control, Element::cell,
     SolidGrip::click},
    {sharp, "Sharp", "Make it sharp", "Make it smooth", "creases, corners, flat sides",
     "Tags a face, edge or point as sharp.", control, Element::face, SolidGrip::click},
    {mass, "Mass", "Heavier", "Lighter", "heavy clay lags, light clay leads", "A brush for mass.",
     surface, Element::face, SolidGrip::brush},
    {stiffness, "Stiffness", "Stiffer", "Softer", "stiff clay keeps its shape",
     "A brush for stiffness.", surface, Element::face, SolidGrip::brush},
    {inflate, "Inflate", "Inflate", "Deflate", "rest lengths grow; with Ctrl they shrink",
     "Swells the solid under the brush.", surface, Element::face, SolidGrip::brush},
    {trim, "Trim", "Take out", "Take in again", "clay without springs",
     "Refined cells under the brush take no part in the physics.", surface, Element::face,
     SolidGrip::brush},
    {probe, "Probe", "Touch it", "", "how stiff it is, and how it resists",
     "Touches the surface: tells the stiffness there, shows how it pushes back.", surface,
     Element::face, SolidGrip::touch},
}};

}  // namespace

std::span<const SolidToolRow, kSolidToolCount> solidToolTable() { return kTools; }
const SolidToolRow& rowOf(SolidTool tool) { return kTools[std::size_t(tool)]; }

}  // namespace bozzetto::ui
