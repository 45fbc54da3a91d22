// Signs of the tools that work on solids: a cell in one ink, what becomes of it in the other.
#pragma once
#include "ui/icons.hpp"
#include "ui/solid_state.hpp"

namespace bozzetto::ui {

void drawSolidIcon(ImDrawList* list, SolidTool tool, const IconPlace& place, const IconInks& inks);
/// A cell: solid mode itself.
void drawSolidMode(ImDrawList* list, const IconPlace& place, const IconInks& inks);

}  // namespace bozzetto::ui
