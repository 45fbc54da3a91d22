// What each overlay looks like in lines, dots and fills.
#pragma once
#include "bozzetto/render/overlays.hpp"
#include "render/ink_sheet.hpp"

namespace bozzetto {

/// Under tools and cursor: grid and box; the working plane.
void drawSurroundings(const Overlays& overlays, const glm::dvec3& towardsEye, InkSheet& sheet);
void drawPlane(const WorkingPlane& plane, InkSheet& sheet);
/// Over them: rings in the air, lines, lights, handles.
void drawMarks(const Overlays& overlays, InkSheet& sheet);

}  // namespace bozzetto
