// Painted stiffness on its way to the window: a tint of the surface's vertices.
#pragma once
#include <cstdint>
#include <vector>

#include "bozzetto/clay/stiffness.hpp"
#include "bozzetto/render/unpack.hpp"

namespace bozzetto::ui {

/// At each vertex, of the nearest corner: −127 soft … 127 stiff; empty where all is 0.
std::vector<std::int8_t> stiffnessOn(const UnpackedPatch& patch, const clay::Stiffness& stiffness);

/// Where two differ, and a cell round it; in cells. O(blocks painted).
CellBounds differenceOf(const clay::Stiffness& a, const clay::Stiffness& b);

bool meet(const CellBounds& a, const CellBounds& b);

}  // namespace bozzetto::ui
