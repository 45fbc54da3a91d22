#include "ui/solid_state.hpp"

#include <array>

namespace bozzetto::ui {
namespace {

using enum SolidTool;

constexpr std::array<SolidToolRow, kSolidToolCount> kTools{{
    {move, "Move a point", "Move the point", "", "a control point follows the hand",
     "Drags a control point of the lattice.", Element::point, SolidGrip::drag},
    {rope, "Rope", "Pull by a rope", "", "the solid is pulled and gives way",
     "A spring from the surface to the pointer; then physics.", Element::face, SolidGrip::drag},
    {carve, "Carve a cell", "Carve the cell", "", "one control cell goes",
     "Removes the control cell under the pointer.", Element::cell, SolidGrip::click},
    {extrude, "Extrude", "Extrude the face", "", "a cell grows from a face",
     "A cell grows from the face under the pointer.", Element::face, SolidGrip::click},
    {join, "Join", "Join faces", "", "a cell between two faces",
     "Click one face, then another: a cell joins them.", Element::face, SolidGrip::click},
    {subdivide, "Subdivide", "Split the cell", "", "one cell becomes many",
     "Splits the cell under the pointer as refinement would.", Element::cell, SolidGrip::click},
    {sharp, "Sharp", "Make it sharp", "Make it smooth", "creases, corners, flat sides",
     "Tags a face, edge or point as sharp.", Element::face, SolidGrip::click},
    {mass, "Mass", "Heavier", "Lighter", "heavy clay lags, light clay leads", "A brush for mass.",
     Element::face, SolidGrip::brush},
    {stiffness, "Stiffness", "Stiffer", "Softer", "stiff clay keeps its shape",
     "A brush for stiffness.", Element::face, SolidGrip::brush},
    {inflate, "Inflate", "Inflate", "Deflate", "rest lengths grow; with Ctrl they shrink",
     "Swells the solid under the brush.", Element::face, SolidGrip::brush},
    {trim, "Trim", "Take out", "Take in again", "clay without springs",
     "Refined cells under the brush take no part in the physics.", Element::face, SolidGrip::brush},
    {probe, "Probe", "Feel", "", "tells the stiffness there", "Tells the mean stiffness there.",
     Element::face, SolidGrip::click},
}};

}  // namespace

std::span<const SolidToolRow, kSolidToolCount> solidToolTable() { return kTools; }
const SolidToolRow& rowOf(SolidTool tool) { return kTools[std::size_t(tool)]; }

}  // namespace bozzetto::ui
