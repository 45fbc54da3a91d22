// What lies over the clay: labels, shades at the panels' edges, axis ball, messages, progress.
#include <fmt/format.h>

#include <cmath>

#include "ui/panels.hpp"
#include "ui/widgets.hpp"

namespace bozzetto::ui {
namespace {

ImVec2 corner(glm::dvec2 at) { return {float(at.x), float(at.y)}; }

void shades(ImDrawList* list, const Rect& at) {
  const ImU32 none = ink(0, 0), top = ink(0, .28f), side = ink(0, .22f);
  const ImVec2 low = corner(at.low), high = corner(at.high);
  list->AddRectFilledMultiColor(low, {high.x, low.y + px(10)}, top, top, none, none);
  list->AddRectFilledMultiColor(low, {low.x + px(8), high.y}, side, none, none, side);
  list->AddRectFilledMultiColor({high.x - px(8), low.y}, high, none, side, side, none);
}

// The viewport's own pixels: what lies over it covers them. The top bar draws its own.
void seams(ImDrawList* list, const Rect& at) {
  const ImVec2 low = corner(at.low), high = corner(at.high);
  list->AddRectFilled(low, {low.x + 1, high.y}, ink(tint::seam));
  list->AddRectFilled({high.x - 1, low.y}, high, ink(tint::seam));
}

std::string viewName(const ViewState& view) {
  const glm::dvec3 back = view.back();
  const char* names[3][2] = {{"Left", "Right"}, {"Bottom", "Top"}, {"Back", "Front"}};
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(back[axis]) > 1 - 1e-9) return names[axis][back[axis] > 0];
  return "";
}

void label(ImDrawList* list, const Atelier& atelier, const Rect& at) {
  const bool parallel = atelier.view.projection == Projection::orthographic;
  const std::string side = viewName(atelier.view);
  const std::string title =
      (parallel ? "Parallel" : "Perspective") + (side.empty() ? "" : "  ·  " + side);
  const ImVec2 low = corner(at.low);
  drawText(list, fonts().semiBold, {low.x + px(18), low.y + px(15)}, ink(0xFFFFFF, .86f), title);
  std::string look = "Studio";
  for (const LookCard& card : kLookCards)
    if (isShown(card, atelier.options.look)) look = "Studio " + std::string(card.name);
  look[7 < look.size() ? 7 : 0] = char(std::tolower(look[7 < look.size() ? 7 : 0]));
  drawText(list, fonts().medium, {low.x + px(18), low.y + px(36)}, ink(0xFFFFFF, .45f),
           fmt::format("{}  ·  cell {:.4g} mm", look, atelier.status().scale.spacing));
}

// The steadied pointer on its rope.
void rope(ImDrawList* list, const Atelier& atelier) {
  if (!atelier.strokeMaker()) return;
  const auto end = atelier.strokeMaker()->ropeEnd();
  if (!end) return;
  const ImVec2 a = corner(atelier.corner() + *end);
  const ImVec2 b = corner(atelier.corner() + atelier.pointerAt());
  list->AddLine(a, b, ink(tint::second, .7f), px(1.4f));
  list->AddCircleFilled(a, px(3), ink(tint::second), 16);
}

// While size or strength is dragged the number stands at the pointer.
void dragValue(ImDrawList* list, const Atelier& atelier) {
  std::string text;
  const SculptState& sculpt = atelier.sculpt;
  const std::string size = fmt::format("{:.3g} mm", sculpt.size);
  const std::string strength = fmt::format("{:.0f} %", 100 * sculpt.strengthOf(sculpt.action));
  switch (atelier.gesture()) {
    case Gesture::size:
      text = size;
      break;
    case Gesture::strength:
      text = strength;
      break;
    case Gesture::sizeAndStrength:
      text = size + "  ·  " + strength;
      break;
    default:
      return;
  }
  const ImVec2 at = corner(atelier.corner() + atelier.pointerAt());
  const float width = textWidth(fonts().semiBold, text);
  const ImVec2 low{at.x + px(18), at.y - px(30)};
  list->AddRectFilled(low, {low.x + width + px(16), low.y + px(24)}, ink(tint::bar, .9f), px(6));
  drawText(list, fonts().semiBold, {low.x + px(8), low.y + px(5)}, ink(tint::strong), text);
}

}  // namespace

bool isShown(const LookCard& card, const Look& look) {
  return card.mode == look.mode && (look.mode != Mode::matcap || card.matcap == look.matcap);
}

void drawViewportMarks(const PanelContext& context) {
  ImDrawList* list = ImGui::GetBackgroundDrawList();
  const Rect& at = context.layout.viewport;
  if (context.layout.panels) {
    shades(list, at);
    seams(list, at);
  }
  label(list, context.atelier, at);
  drawSupportKnobs(context);
  drawSolidPoints(context);
  rope(list, context.atelier);
  dragValue(list, context.atelier);
}

void drawAxisBall(const PanelContext& context) {
  Atelier& atelier = context.atelier;
  const Rect& at = context.layout.viewport;
  const ImVec2 centre{float(at.high.x) - px(52), float(at.low.y) + px(54)};
  const float reach = px(27), whole = reach + px(13);
  ImGui::SetNextWindowPos({centre.x - whole, centre.y - whole});
  ImGui::SetNextWindowSize({2 * whole, 2 * whole});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::Begin("axes", nullptr, kFixed | ImGuiWindowFlags_NoBackground);
  ImGui::PopStyleVar();
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddCircleFilled(centre, whole, ink(0, .18f), 48);
  constexpr unsigned colours[] = {tint::axisX, tint::axisY, tint::axisZ};
  const Camera camera = cameraOf(atelier.view, 1);
  for (const AxisEnd& end : axisEnds(camera)) {
    const ImVec2 tip{centre.x + float(end.at.x) * reach, centre.y + float(end.at.y) * reach};
    ImGui::SetCursorScreenPos({tip.x - px(9), tip.y - px(9)});
    ImGui::PushID(end.axis * 2 + int(end.positive));
    if (hotArea("end", {px(18), px(18)})) {
      const Camera seen = lookingFrom(end, camera);
      atelier.lookFrom(seen.yaw, seen.pitch);
    }
    const bool hovered = ImGui::IsItemHovered();
    ImGui::PopID();
    const unsigned colour = colours[end.axis];
    if (end.positive) {
      const std::string name(1, "XYZ"[end.axis]);
      list->AddLine(centre, tip, ink(colour), px(2));
      list->AddCircleFilled(tip, px(hovered ? 9.f : 8.f), ink(colour), 24);
      drawText(list, fonts().medium,
               {tip.x - textWidth(fonts().medium, name) / 2, tip.y - fonts().medium->FontSize / 2},
               ink(0x17181B), name);
    } else {
      list->AddCircleFilled(tip, px(5.5f), ink(hovered ? tint::hover : 0x2A2D32), 24);
      list->AddCircle(tip, px(5.5f), ink(colour, .65f), 24, px(1.3f));
    }
  }
  ImGui::End();
}

namespace {

// What is over at once needs no box.
constexpr double kShortWork = 0.3;
struct Since {
  const LongJob* job = nullptr;
  double time = 0;
};

}  // namespace

void drawMessages(const PanelContext& context) {
  const Rect& at = context.layout.viewport;
  ImDrawList* list = ImGui::GetForegroundDrawList();
  float y = float(at.low.y) + px(66);
  for (const Message& message : context.atelier.messages()) {
    const bool bad = message.kind == Message::Kind::error;
    const float most = float(at.width()) - px(120);
    const std::string text = fitted(fonts().regular, message.text, most);
    const float width = textWidth(fonts().regular, text) + px(36);
    const float x = float(at.low.x) + px(18);
    list->AddRectFilled({x, y}, {x + width, y + px(32)}, ink(0x222529, .96f), px(8));
    list->AddRectFilled({x, y}, {x + px(4), y + px(32)}, ink(bad ? tint::axisX : tint::ok), px(2));
    drawText(list, fonts().regular, {x + px(18), y + px(8)}, ink(tint::text), text);
    y += px(38);
  }
}

void drawProgress(const PanelContext& context) {
  const auto job = context.atelier.job();
  static Since begun;
  if (begun.job != job.get()) begun = {job.get(), context.atelier.now()};
  if (!job || context.atelier.now() - begun.time < kShortWork) return;
  const std::size_t waiting = context.atelier.jobsWaiting();
  const std::string more = waiting == 0 ? "" : fmt::format(" (and {} more)", waiting);
  const Rect& at = context.layout.viewport;
  const float width = px(340), height = px(84);
  ImGui::SetNextWindowPos({float(at.centre().x) - width / 2, float(at.high.y) - height - px(96)});
  ImGui::SetNextWindowSize({width, height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, px(10));
  ImGui::Begin("progress", nullptr, kFixed);
  ImGui::PopStyleVar();
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 start = ImGui::GetCursorScreenPos();
  drawText(list, fonts().semiBold, start, ink(tint::strong),
           fitted(fonts().semiBold, job->title() + more, width - px(110)));
  ImGui::SetCursorScreenPos({start.x + width - px(28 + 72), start.y - px(4)});
  if (button("Cancel", {px(72), px(26)})) job->cancel();
  const float left = start.x, right = start.x + width - px(28), y = start.y + px(44);
  list->AddRectFilled({left, y}, {right, y + px(4)}, ink(tint::well), px(2));
  list->AddRectFilled({left, y}, {left + (right - left) * float(job->done()), y + px(4)},
                      ink(tint::accent), px(2));
  ImGui::End();
}

}  // namespace bozzetto::ui
