// Signs drawn with lines: a profile of clay in one ink, what the tool does to it in the other.
#pragma once
#include <imgui.h>

#include "ui/sculpt_state.hpp"

namespace bozzetto::ui {

/// Where and how large: the sign fills a square of half side `radius`.
struct IconPlace {
  ImVec2 centre;
  float radius;
};
struct IconInks {
  ImU32 clay, action;
};
void drawIcon(ImDrawList* list, Icon icon, const IconPlace& place, const IconInks& inks);

enum class MousePart { left, right, middle, wheel };
/// A mouse, `height` tall, its pressed part in accent; at its upper left corner.
void drawMouse(ImDrawList* list, ImVec2 at, MousePart part, float height);
/// The width of that mouse.
float mouseWidth(float height);

/// A bent arrow, to the left for undo.
enum class Turn { undo, redo };
void drawTurn(ImDrawList* list, ImVec2 centre, Turn turn, ImU32 colour);
void drawChevron(ImDrawList* list, ImVec2 centre, bool open, ImU32 colour);
/// A line of steps with a branch.
void drawTree(ImDrawList* list, ImVec2 centre, ImU32 colour);
/// Two rounds that overlap: this against that.
void drawCompare(ImDrawList* list, ImVec2 centre, ImU32 colour);
void drawMirror(ImDrawList* list, ImVec2 centre, ImU32 colour);
/// A small pen: what pressure drives.
void drawPen(ImDrawList* list, ImVec2 at, ImU32 colour);

}  // namespace bozzetto::ui
