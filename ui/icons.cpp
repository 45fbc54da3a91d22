#include "ui/icons.hpp"

#include <cmath>
#include <numbers>

#include "ui/theme.hpp"

namespace bozzetto::ui {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

// Draws on a unit square.
struct Sketch {
  ImDrawList* list;
  IconPlace place;
  float width;

  ImVec2 at(ImVec2 p) const {
    return {place.centre.x + p.x * place.radius, place.centre.y + p.y * place.radius};
  }
  void line(ImVec2 a, ImVec2 b, ImU32 colour) const { list->AddLine(at(a), at(b), colour, width); }
  void curve(ImVec2 a, ImVec2 b, ImVec2 c, ImVec2 d, ImU32 colour) const {
    list->AddBezierCubic(at(a), at(b), at(c), at(d), colour, width, 24);
  }
  void circle(ImVec2 centre, float radius, ImU32 colour) const {
    list->AddCircle(at(centre), radius * place.radius, colour, 32, width);
  }
  /// Ground with a hump of this height in the middle, a dent when below 0.
  void ground(float height, ImU32 colour) const {
    const float y = .62f, top = y - height;
    curve({-1, y}, {-.62f, y}, {-.55f, top}, {0, top}, colour);
    curve({0, top}, {.55f, top}, {.62f, y}, {1, y}, colour);
  }
};

void drawBrush(const Sketch& sketch, const IconInks& inks) {
  sketch.curve({-.9f, .85f}, {-.3f, .9f}, {-.5f, .3f}, {-.15f, .2f}, inks.action);
  sketch.curve({-.9f, .85f}, {-.55f, .6f}, {-.6f, 0}, {-.2f, -.05f}, inks.action);
  sketch.line({-.15f, .22f}, {.72f, -.82f}, inks.clay);
  sketch.line({-.22f, -.04f}, {.48f, -.92f}, inks.clay);
  sketch.curve({.48f, -.92f}, {.62f, -1.05f}, {.85f, -.95f}, {.72f, -.82f}, inks.clay);
}

void drawSmooth(const Sketch& sketch, const IconInks& inks) {
  sketch.curve({-1, .1f}, {-.7f, -.75f}, {-.45f, .8f}, {-.1f, .05f}, inks.clay);
  sketch.curve({-.1f, .05f}, {.15f, -.28f}, {.5f, .12f}, {1, .05f}, inks.action);
  sketch.line({-1, .68f}, {1, .68f}, inks.clay);
}

void drawErase(const Sketch& sketch, const IconInks& inks) {
  sketch.line({-1, .62f}, {-.5f, .62f}, inks.clay);
  sketch.line({.5f, .62f}, {1, .62f}, inks.clay);
  const ImVec2 corners[] = {{-.5f, -.35f}, {.5f, -.35f}, {.5f, .62f}, {-.5f, .62f}};
  for (int n = 0; n < 4; ++n) sketch.line(corners[n], corners[(n + 1) % 4], inks.action);
  sketch.line({-.22f, -.08f}, {.22f, .36f}, inks.action);
  sketch.line({.22f, -.08f}, {-.22f, .36f}, inks.action);
}

void drawSpray(const Sketch& sketch, const IconInks& inks) {
  sketch.ground(.35f, inks.clay);
  const ImVec2 drops[] = {{-.45f, -.55f}, {0, -.8f}, {.45f, -.55f}, {-.22f, -.2f}, {.22f, -.2f}};
  for (const ImVec2& drop : drops) {
    sketch.list->AddCircleFilled(sketch.at(drop), .1f * sketch.place.radius, inks.action, 12);
  }
}

void drawHold(const Sketch& sketch, const IconInks& inks) {
  const float r = .78f * sketch.place.radius;
  sketch.circle({0, 0}, .78f, inks.clay);
  sketch.list->PathArcTo(sketch.place.centre, r, -kPi / 2, kPi / 2, 24);
  sketch.list->PathFillConvex(inks.action);
}

void drawStiffen(const Sketch& sketch, const IconInks& inks) {
  // A bar that stays straight.
  sketch.line({-.95f, -.3f}, {.95f, -.3f}, inks.clay);
  sketch.line({-.95f, .3f}, {.95f, .3f}, inks.clay);
  sketch.line({-.95f, -.3f}, {-.95f, .3f}, inks.clay);
  sketch.line({.95f, -.3f}, {.95f, .3f}, inks.clay);
  for (const float x : {-.5f, 0.f, .5f}) sketch.line({x, -.3f}, {x, .3f}, inks.action);
}

void drawSoften(const Sketch& sketch, const IconInks& inks) {
  // A bar that hangs through.
  sketch.curve({-.95f, -.45f}, {-.4f, .45f}, {.4f, .45f}, {.95f, -.45f}, inks.clay);
  sketch.curve({-.95f, .05f}, {-.4f, .95f}, {.4f, .95f}, {.95f, .05f}, inks.clay);
  sketch.line({-.95f, -.45f}, {-.95f, .05f}, inks.clay);
  sketch.line({.95f, -.45f}, {.95f, .05f}, inks.clay);
  sketch.line({0, -.85f}, {0, -.15f}, inks.action);
}

void drawPush(const Sketch& sketch, const IconInks& inks) {
  // A dent between two rims.
  sketch.curve({-1, .5f}, {-.7f, .5f}, {-.75f, .05f}, {-.5f, .1f}, inks.clay);
  sketch.curve({-.5f, .1f}, {-.25f, .15f}, {-.3f, .75f}, {0, .75f}, inks.clay);
  sketch.curve({0, .75f}, {.3f, .75f}, {.25f, .15f}, {.5f, .1f}, inks.clay);
  sketch.curve({.5f, .1f}, {.75f, .05f}, {.7f, .5f}, {1, .5f}, inks.clay);
  sketch.line({0, -.95f}, {0, .25f}, inks.action);
  sketch.line({-.25f, 0}, {0, .27f}, inks.action);
  sketch.line({.25f, 0}, {0, .27f}, inks.action);
}

void drawGrip(const Sketch& sketch, const IconInks& inks) {
  sketch.curve({-1, .65f}, {-.2f, .65f}, {-.4f, -.2f}, {.30f, -.42f}, inks.clay);
  sketch.curve({1, .65f}, {.3f, .65f}, {.45f, .25f}, {.30f, -.42f}, inks.clay);
  sketch.line({.38f, -.5f}, {.82f, -.92f}, inks.action);
  sketch.line({.48f, -.95f}, {.84f, -.94f}, inks.action);
  sketch.line({.84f, -.94f}, {.84f, -.58f}, inks.action);
}

void drawSwell(const Sketch& sketch, const IconInks& inks) {
  sketch.ground(.62f, inks.clay);
  const ImVec2 from[] = {{-.42f, -.18f}, {0, -.3f}, {.42f, -.18f}};
  const ImVec2 to[] = {{-.72f, -.55f}, {0, -.8f}, {.72f, -.55f}};
  for (int n = 0; n < 3; ++n) sketch.line(from[n], to[n], inks.action);
}

// A stamp's handle over the print it left between two rims.
void drawStamp(const Sketch& sketch, const IconInks& inks) {
  sketch.curve({-1, .72f}, {-.8f, .72f}, {-.75f, .4f}, {-.55f, .42f}, inks.clay);
  sketch.line({-.55f, .42f}, {-.45f, .8f}, inks.clay);
  sketch.line({-.45f, .8f}, {.45f, .8f}, inks.clay);
  sketch.line({.45f, .8f}, {.55f, .42f}, inks.clay);
  sketch.curve({.55f, .42f}, {.75f, .4f}, {.8f, .72f}, {1, .72f}, inks.clay);
  sketch.circle({0, -.68f}, .22f, inks.action);
  sketch.line({0, -.46f}, {0, .05f}, inks.action);
  sketch.line({-.42f, .05f}, {.42f, .05f}, inks.action);
  sketch.line({-.42f, .05f}, {-.42f, .38f}, inks.action);
  sketch.line({.42f, .05f}, {.42f, .38f}, inks.action);
  sketch.line({-.42f, .38f}, {.42f, .38f}, inks.action);
}

// Two boards, something standing on each.
void drawShelf(const Sketch& sketch, const IconInks& inks) {
  sketch.line({-.95f, -.02f}, {.95f, -.02f}, inks.clay);
  sketch.line({-.95f, .85f}, {.95f, .85f}, inks.clay);
  sketch.circle({-.45f, -.42f}, .36f, inks.action);
  sketch.line({.25f, -.06f}, {.25f, -.8f}, inks.clay);
  sketch.line({.25f, -.8f}, {.7f, -.8f}, inks.clay);
  sketch.line({.7f, -.8f}, {.7f, -.06f}, inks.clay);
  sketch.line({-.75f, .8f}, {-.45f, .25f}, inks.clay);
  sketch.line({-.45f, .25f}, {-.15f, .8f}, inks.clay);
  sketch.circle({.45f, .5f}, .3f, inks.action);
}

}  // namespace

void drawIcon(ImDrawList* list, Icon icon, const IconPlace& place, const IconInks& inks) {
  const Sketch sketch{list, place, px(1.6f)};
  switch (icon) {
    case Icon::add:
      sketch.ground(.75f, inks.clay);
      sketch.line({-.27f, -.62f}, {.27f, -.62f}, inks.action);
      sketch.line({0, -.89f}, {0, -.35f}, inks.action);
      break;
    case Icon::carve:
      sketch.ground(-.42f, inks.clay);
      sketch.circle({0, -.12f}, .42f, inks.action);
      sketch.line({-.2f, -.12f}, {.2f, -.12f}, inks.action);
      break;
    case Icon::erase:
      drawErase(sketch, inks);
      break;
    case Icon::smooth:
      drawSmooth(sketch, inks);
      break;
    case Icon::paint:
      drawBrush(sketch, inks);
      break;
    case Icon::softPaint:
      drawSpray(sketch, inks);
      break;
    case Icon::stamp:
      drawStamp(sketch, inks);
      break;
    case Icon::shelf:
      drawShelf(sketch, inks);
      break;
    case Icon::hold:
      drawHold(sketch, inks);
      break;
    case Icon::stiffen:
      drawStiffen(sketch, inks);
      break;
    case Icon::soften:
      drawSoften(sketch, inks);
      break;
    case Icon::push:
      drawPush(sketch, inks);
      break;
    case Icon::grip:
      drawGrip(sketch, inks);
      break;
    case Icon::swell:
      drawSwell(sketch, inks);
      break;
  }
}

float mouseWidth(float height) { return height * .68f; }

void drawMouse(ImDrawList* list, ImVec2 at, MousePart part, float height) {
  const float w = mouseWidth(height), r = w * .48f, split = at.y + height * .42f;
  const float middle = at.x + w / 2;
  const ImU32 line = ink(tint::dim), pressed = ink(tint::accent);
  if (part == MousePart::left) {
    list->PathLineTo({middle, at.y});
    list->PathLineTo({middle, split});
    list->PathLineTo({at.x, split});
    list->PathArcTo({at.x + r, at.y + r}, r, kPi, 1.5f * kPi, 8);
    list->PathFillConvex(pressed);
  } else if (part == MousePart::right) {
    list->PathLineTo({middle, split});
    list->PathLineTo({middle, at.y});
    list->PathArcTo({at.x + w - r, at.y + r}, r, 1.5f * kPi, 2 * kPi, 8);
    list->PathLineTo({at.x + w, split});
    list->PathFillConvex(pressed);
  }
  list->AddRect(at, {at.x + w, at.y + height}, line, r, 0, px(1.2f));
  list->AddLine({at.x, split}, {at.x + w, split}, line, px(1));
  if (part == MousePart::middle || part == MousePart::wheel) {
    list->AddRectFilled({at.x + w * .36f, at.y + height * .10f},
                        {at.x + w * .64f, at.y + height * .36f}, pressed, px(2));
  } else {
    list->AddLine({middle, at.y}, {middle, split}, line, px(1));
  }
}

void drawTurn(ImDrawList* list, ImVec2 centre, Turn turn, ImU32 colour) {
  const float s = turn == Turn::undo ? -1.f : 1.f, u = px(1);
  const auto at = [&](float x, float y) { return ImVec2(centre.x + x * s * u, centre.y + y * u); };
  list->PathLineTo(at(-5, 5));
  list->PathBezierCubicCurveTo(at(-9, -1), at(-4, -5), at(5, -4), 14);
  list->PathStroke(colour, 0, px(1.7f));
  list->PathLineTo(at(1.5f, -8));
  list->PathLineTo(at(6, -4));
  list->PathLineTo(at(2, .5f));
  list->PathStroke(colour, 0, px(1.7f));
}

void drawChevron(ImDrawList* list, ImVec2 centre, bool open, ImU32 colour) {
  const float a = px(4), b = px(2);
  if (open) {
    list->PathLineTo({centre.x - a, centre.y - b});
    list->PathLineTo({centre.x, centre.y + b});
    list->PathLineTo({centre.x + a, centre.y - b});
  } else {
    list->PathLineTo({centre.x - b, centre.y - a});
    list->PathLineTo({centre.x + b, centre.y});
    list->PathLineTo({centre.x - b, centre.y + a});
  }
  list->PathStroke(colour, 0, px(1.5f));
}

void drawTree(ImDrawList* list, ImVec2 centre, ImU32 colour) {
  const float x = centre.x - px(4), branch = centre.x + px(5), r = px(2.4f), w = px(1.5f);
  const float top = centre.y - px(8), bottom = centre.y + px(8);
  list->AddLine({x, top + r}, {x, bottom - r}, colour, w);
  list->PathLineTo({x, bottom - px(5)});
  list->PathBezierCubicCurveTo({x, centre.y}, {branch, centre.y + px(3)},
                               {branch, centre.y - px(1.5f)});
  list->PathStroke(colour, 0, w);
  for (const ImVec2 at : {ImVec2(x, top), ImVec2(x, bottom), ImVec2(branch, centre.y - px(4))}) {
    list->AddCircleFilled(at, r, colour, 16);
  }
}

void drawCompare(ImDrawList* list, ImVec2 centre, ImU32 colour) {
  list->AddCircle({centre.x - px(2.6f), centre.y}, px(4.6f), colour, 24, px(1.4f));
  list->AddCircleFilled({centre.x + px(2.6f), centre.y}, px(4.6f), (colour & 0xFFFFFF) | 0x70000000,
                        24);
  list->AddCircle({centre.x + px(2.6f), centre.y}, px(4.6f), colour, 24, px(1.4f));
}

void drawMirror(ImDrawList* list, ImVec2 centre, ImU32 colour) {
  const float u = px(1);
  const auto at = [&](float x, float y) { return ImVec2(centre.x + x * u, centre.y + y * u); };
  list->AddLine(at(0, -7), at(0, 7), colour, px(1.2f));
  list->AddTriangleFilled(at(-3, -4), at(-3, 5), at(-9, 5), colour);
  list->AddTriangle(at(3, -4), at(3, 5), at(9, 5), colour, px(1.2f));
}

void drawPen(ImDrawList* list, ImVec2 at, ImU32 colour) {
  list->AddLine({at.x, at.y + px(9)}, {at.x + px(7), at.y + px(1)}, colour, px(1.5f));
  list->AddCircleFilled({at.x, at.y + px(9)}, px(1.3f), colour);
}

}  // namespace bozzetto::ui
