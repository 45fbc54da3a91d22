#include "ui/solid_icons.hpp"

#include <initializer_list>

#include "ui/theme.hpp"

namespace bozzetto::ui {
namespace {

// Draws on a unit square.
struct Pencil {
  ImDrawList* list;
  IconPlace place;

  ImVec2 at(ImVec2 p) const {
    return {place.centre.x + p.x * place.radius, place.centre.y + p.y * place.radius};
  }
  void path(std::initializer_list<ImVec2> points, ImU32 colour, bool closed = false) const {
    for (const ImVec2& point : points) list->PathLineTo(at(point));
    list->PathStroke(colour, closed ? ImDrawFlags_Closed : 0, px(1.6f));
  }
  void dot(ImVec2 centre, float radius, ImU32 colour) const {
    list->AddCircleFilled(at(centre), radius * place.radius, colour, 16);
  }
  void ring(ImVec2 centre, float radius, ImU32 colour) const {
    list->AddCircle(at(centre), radius * place.radius, colour, 24, px(1.6f));
  }
  void fill(std::initializer_list<ImVec2> points, ImU32 colour) const {
    for (const ImVec2& point : points) list->PathLineTo(at(point));
    list->PathFillConvex(colour);
  }
  /// A cell seen from a corner.
  void cell(ImU32 colour) const {
    path({{0, -.85f}, {.75f, -.42f}, {.75f, .42f}, {0, .85f}, {-.75f, .42f}, {-.75f, -.42f}},
         colour, true);
    path({{-.75f, -.42f}, {0, 0}, {.75f, -.42f}}, colour);
    path({{0, 0}, {0, .85f}}, colour);
  }
  void square(ImU32 colour) const {
    path({{-.6f, -.3f}, {.6f, -.3f}, {.6f, .8f}, {-.6f, .8f}}, colour, true);
  }
};

// What is done to a ball of clay.
void drawBrush(const Pencil& pencil, SolidTool tool, const IconInks& inks) {
  pencil.ring({0, .15f}, .68f, inks.clay);
  switch (tool) {
    case SolidTool::mass:
      pencil.path({{0, -.1f}, {0, .55f}}, inks.action);
      pencil.path({{-.25f, .3f}, {0, .58f}, {.25f, .3f}}, inks.action);
      return;
    case SolidTool::stiffness:
      pencil.path({{-.45f, .15f}, {-.3f, -.1f}, {-.1f, .4f}, {.1f, -.1f}, {.3f, .4f}, {.45f, .15f}},
                  inks.action);
      return;
    case SolidTool::inflate:
      pencil.path({{0, -.2f}, {0, -.95f}}, inks.action);
      pencil.path({{-.25f, -.7f}, {0, -.97f}, {.25f, -.7f}}, inks.action);
      return;
    case SolidTool::trim:
      pencil.path({{-.48f, -.33f}, {.48f, .63f}}, inks.action);
      return;
    default:
      pencil.dot({0, .15f}, .2f, inks.action);
      pencil.path({{0, -.05f}, {0, -.95f}}, inks.action);
      return;
  }
}

// Geometry and topology; the others are brushes on a ball.
void drawShape(const Pencil& pencil, SolidTool tool, const IconInks& inks) {
  switch (tool) {
    case SolidTool::move:
      pencil.path({{-.8f, .8f}, {-.8f, -.2f}, {.35f, -.45f}, {.3f, .8f}}, inks.clay, true);
      pencil.dot({.35f, -.45f}, .22f, inks.action);
      pencil.path({{.5f, -.6f}, {.85f, -.9f}}, inks.action);
      return;
    case SolidTool::rope:
      pencil.path({{-.85f, .8f}, {-.5f, .1f}, {.1f, .1f}, {.45f, .8f}}, inks.clay, true);
      pencil.path({{-.2f, .1f}, {0, -.25f}, {.3f, -.2f}, {.45f, -.55f}, {.8f, -.55f}}, inks.action);
      pencil.dot({-.2f, .1f}, .16f, inks.action);
      return;
    case SolidTool::spline:
      pencil.path({{-.9f, .5f},
                   {-.72f, .02f},
                   {-.45f, -.2f},
                   {-.1f, -.12f},
                   {.2f, .12f},
                   {.5f, .1f},
                   {.75f, -.2f},
                   {.9f, -.65f}},
                  inks.clay);
      for (const ImVec2 dot : {ImVec2(-.9f, .5f), ImVec2(.05f, 0), ImVec2(.9f, -.65f)})
        pencil.dot(dot, .17f, inks.action);
      return;
    case SolidTool::carve:
      pencil.cell(inks.clay);
      pencil.fill({{0, 0}, {.75f, -.42f}, {.75f, .42f}, {0, .85f}}, inks.action);
      return;
    case SolidTool::extrude:
      pencil.square(inks.clay);
      pencil.path({{-.6f, -.3f}, {-.6f, -.9f}, {.6f, -.9f}, {.6f, -.3f}}, inks.action);
      return;
    case SolidTool::join:
      pencil.path({{-.95f, -.5f}, {-.4f, -.5f}, {-.4f, .5f}, {-.95f, .5f}}, inks.clay, true);
      pencil.path({{.95f, -.5f}, {.4f, -.5f}, {.4f, .5f}, {.95f, .5f}}, inks.clay, true);
      pencil.path({{-.4f, -.28f}, {.4f, -.28f}}, inks.action);
      pencil.path({{-.4f, .28f}, {.4f, .28f}}, inks.action);
      return;
    case SolidTool::subdivide:
      pencil.path({{-.8f, -.8f}, {.8f, -.8f}, {.8f, .8f}, {-.8f, .8f}}, inks.clay, true);
      pencil.path({{0, -.8f}, {0, .8f}}, inks.action);
      pencil.path({{-.8f, 0}, {.8f, 0}}, inks.action);
      return;
    case SolidTool::sharp:
      pencil.path({{-.9f, .7f}, {0, -.7f}, {.9f, .7f}}, inks.clay);
      pencil.path({{-.28f, -.27f}, {0, -.7f}, {.28f, -.27f}}, inks.action);
      pencil.dot({0, -.7f}, .16f, inks.action);
      return;
    default:
      return drawBrush(pencil, tool, inks);
  }
}

}  // namespace

void drawSolidIcon(ImDrawList* list, SolidTool tool, const IconPlace& place, const IconInks& inks) {
  drawShape({list, place}, tool, inks);
}

void drawSolidMode(ImDrawList* list, const IconPlace& place, const IconInks& inks) {
  const Pencil pencil{list, place};
  pencil.cell(inks.clay);
  for (const ImVec2 corner : {ImVec2(0, -.85f), ImVec2(.75f, .42f), ImVec2(-.75f, .42f)})
    pencil.dot(corner, .17f, inks.action);
}

}  // namespace bozzetto::ui
