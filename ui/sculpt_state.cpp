#include "ui/sculpt_state.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace bozzetto::ui {
namespace {

using enum ActionKind;

constexpr std::array<ToolRow, kToolCount> kTools{{
    {add, Icon::add, "Add clay", "Add clay", "clay piles up", remove, true, true},
    {remove, Icon::carve, "Carve", "Carve", "clay goes, little by little", add, true, false},
    {erase, Icon::erase, "Erase", "Erase", "cuts all it covers", add, false, false},
    {paint, Icon::paint, "Paint", "Paint", "colour with a sharp rim", paintSoft, false, true},
    {paintSoft, Icon::softPaint, "Soft paint", "Paint", "colour that fades out", paint, true, true},
    {smooth, Icon::smooth, "Smooth", "Smooth", "evens out bumps", smooth, true, false},
    {hold, Icon::hold, "Hold", "Hold", "keeps clay as it is", hold, true, false},
    {push, Icon::push, "Push", "Push", "clay gives way, none is lost", push, true, false},
    {grip, Icon::grip, "Grip", "Grip", "drags clay along", grip, true, false},
    {swell, Icon::swell, "Swell", "Swell", "clay swells out", swell, true, false},
}};

constexpr Colour rgb(unsigned hex) {
  return {std::uint8_t(hex >> 16), std::uint8_t(hex >> 8), std::uint8_t(hex)};
}

constexpr std::array<Colour, 14> kColours{
    rgb(0xAC7052), rgb(0x8A4F3A), rgb(0xDCCBAA), rgb(0xC9B79C), rgb(0x75473A),
    rgb(0xA9604F), rgb(0x4F6D5E), rgb(0x6B7F93), rgb(0xE8DFD2), rgb(0x3E3431),
    rgb(0xD9A441), rgb(0xB24A3A), rgb(0x3F6E6A), rgb(0x1E1C1B)};

// The shortest turn that brings y to `direction`.
glm::dquat fromY(const glm::dvec3& direction) {
  const glm::dvec3 y(0, 1, 0);
  if (glm::dot(direction, y) < -0.999999) return {0, 1, 0, 0};
  return glm::normalize(glm::dquat(1 + glm::dot(y, direction), glm::cross(y, direction)));
}

}  // namespace

std::span<const ToolRow, kToolCount> toolTable() { return kTools; }

const ToolRow& rowOf(ActionKind action) {
  return *std::ranges::find(kTools, action, &ToolRow::action);
}

double PressureCurve::operator()(double pressure) const {
  return least + (1 - least) * std::pow(std::clamp(pressure, 0.0, 1.0), gamma);
}

ToolShape SculptState::tool(const glm::dvec3& normal, const glm::dvec3& towardsViewer) const {
  ToolShape made{shape, profile, radii(), rotation};
  if (alignment == Alignment::normal) made.rotation = fromY(normal) * rotation;
  if (alignment == Alignment::view) made.rotation = fromY(towardsViewer) * rotation;
  return made;
}

ActionOptions SculptState::options(ActionKind kind) const {
  return {kind, rowOf(kind).usesStrength ? strengthOf(kind) : 1, colour};
}

Stroke SculptState::strokeFrom(const StrokePoint& first) const {
  Stroke stroke;
  stroke.points = {first};
  stroke.spacing = spacing;
  stroke.pressure = {pressureStrength, pressureSize};
  stroke.symmetry = symmetry;
  return stroke;
}

ActionKind actionFor(ActionKind chosen, Held held) {
  if (held == Held::smooth) return smooth;
  return held == Held::invert ? rowOf(chosen).inverse : chosen;
}

std::span<const Colour, 14> clayColours() { return kColours; }

}  // namespace bozzetto::ui
