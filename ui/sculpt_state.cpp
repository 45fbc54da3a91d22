#include "ui/sculpt_state.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "bozzetto/clay/idle.hpp"

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
    {stamp, Icon::stamp, "Stamp", "Print", "prints, and clay rises round it", add, true, false},
    {hold, Icon::hold, "Hold", "Hold", "keeps clay as it is", free, true, false},
    {free, Icon::hold, "Let go", "Let go", "what was held moves again", hold, true, false},
    {stiffen, Icon::stiffen, "Stiffen", "Stiffen", "keeps its form when moved", soften, true,
     false},
    {soften, Icon::soften, "Soften", "Soften", "gives way sooner", stiffen, true, false},
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

// The shortest turn that brings one direction to another, both of length 1.
glm::dquat turnBetween(const glm::dvec3& from, const glm::dvec3& to) {
  const double cosine = glm::dot(from, to);
  if (cosine > -0.999999) return glm::normalize(glm::dquat(1 + cosine, glm::cross(from, to)));
  const glm::dvec3 helper = std::abs(from.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
  return glm::angleAxis(glm::pi<double>(), glm::normalize(glm::cross(from, helper)));
}

constexpr glm::dvec3 kUp(0, 1, 0);

}  // namespace

std::span<const ToolRow, kToolCount> toolTable() { return kTools; }

const ToolRow& rowOf(ActionKind action) {
  return *std::ranges::find(kTools, action, &ToolRow::action);
}

Strengths strengthsOf(ActionKind action) {
  if (action == push)
    return {"Depth", "How far the tool sinks into what it meets, as part of its radius."};
  return {"Strength", "How much every dab does."};
}

double PressureCurve::operator()(double pressure) const {
  return least + (1 - least) * std::pow(std::clamp(pressure, 0.0, 1.0), gamma);
}

ToolShape SculptState::tool(const glm::dvec3& normal, const glm::dvec3& towardsViewer) const {
  if (isFreeform()) return freeformTool(towardsViewer);
  ToolShape made{shape, profile, radii(), rotation};
  if (placement.toNormal) return made;
  if (alignment == Alignment::normal) made.rotation = turnBetween(kUp, normal) * rotation;
  if (alignment == Alignment::view) made.rotation = turnBetween(kUp, towardsViewer) * rotation;
  return made;
}

ToolShape SculptState::freeformTool(const glm::dvec3& towardsViewer) const {
  ToolShape made{shape, profile, {}, rotation, freeform->sculpture};
  made.scale = proportions * (size / freeform->size);
  made.radii = freeformRadii(*freeform->sculpture, made.scale);
  if (alignment == Alignment::view && !placement.toNormal)
    made.rotation = turnBetween(-freeform->sculpture->contact(), towardsViewer) * rotation;
  return made;
}

glm::dquat SculptState::standing(const ToolShape& made, const glm::dvec3& normal) const {
  if (!placement.toNormal) return made.rotation;
  const glm::dvec3 outward = -(made.rotation * contactOf(made));
  return turnBetween(outward, normal) * made.rotation;
}

glm::dvec3 SculptState::contactOf(const ToolShape& made) {
  return made.sculpture ? made.sculpture->contact() : glm::dvec3(0, 0, -1);
}

ToolOperation SculptState::toolOperation(const ToolShape& made) const {
  if (made.shape != Shape::freeform) return {made};
  return {made, freeform->source};
}

void SculptState::take(const Freeform& taken, double cell) {
  if (taken.kept != nullptr) {
    const bool fits = taken.size > 3 * cell && taken.size < 128 * cell;
    shape = Shape::freeform;
    freeform = taken;
    proportions = glm::dvec3(1);
    rotation = {1, 0, 0, 0};
    if (fits) size = taken.size;
  } else if (const ToolShape* plain = plainShapeOf(taken.preset)) {
    takePlain(*plain, cell);
  }
  for (const Operation& operation : taken.preset) takeUse(operation, cell);
}

void SculptState::takePlain(const ToolShape& taken, double cell) {
  drop();
  shape = taken.shape;
  profile = taken.profile;
  const double largest = std::max({taken.radii.x, taken.radii.y, taken.radii.z});
  size = std::clamp(largest, kSmallestToolCells * cell, 256 * cell);
  proportions = glm::max(taken.radii / largest, 0.1);
}

void SculptState::takeUse(const Operation& operation, double cell) {
  if (const auto* tool = std::get_if<ToolOperation>(&operation)) {
    rotation = tool->shape.rotation;
    const glm::dvec3& scale = tool->shape.scale;
    const double largest = std::max({scale.x, scale.y, scale.z});
    if (!isFreeform() || !tool->source || !(largest > 0)) return;
    proportions = glm::max(scale / largest, 0.1);
    size = std::clamp(largest * freeform->size, kSmallestToolCells * cell, 256 * cell);
  } else if (const auto* doing = std::get_if<ActionOperation>(&operation)) {
    action = doing->action.kind;
    strengthOf(action) = doing->action.strength;
    ownColours = doing->action.ownColours;
    if (action == ActionKind::stamp) stamp = doing->action.stamp;
    if (!isFreeform()) colour = doing->action.colour;
  } else if (const auto* made = std::get_if<StrokeOperation>(&operation)) {
    spacing = made->stroke.spacing;
    placement = made->stroke.placement;
    if (isFreeform()) return;
    pressureStrength = made->stroke.pressure.strength;
    pressureSize = made->stroke.pressure.size;
  } else if (const auto* clays = std::get_if<ClayOperation>(&operation)) {
    clay = clays->settings;
  }
}

std::vector<std::string> SculptState::preset() const {
  StrokeOperation made{strokeFrom({glm::dvec3(0), 1})};
  made.stroke.symmetry = {};
  std::vector<std::string> lines{toText(ActionOperation{options(action)}), toText(made)};
  if (movesClay(action)) lines.push_back(toText(ClayOperation{clay}));
  return lines;
}

std::string SculptState::presetOfTool(const std::string& from) const {
  if (!isFreeform()) return toText(ToolOperation{{shape, profile, radii(), rotation}});
  ToolOperation tool{{shape, profile, {}, rotation}};
  tool.shape.scale = proportions * (size / freeform->size);
  tool.source.emplace().from = from;
  return toText(tool);
}

void SculptState::drop() {
  shape = Shape::ellipsoid;
  if (freeform) spacing = SculptState{}.spacing;
  freeform.reset();
  placement = {};
}

ActionOptions SculptState::options(ActionKind kind) const {
  ActionOptions made{kind, rowOf(kind).usesStrength ? strengthOf(kind) : 1, colour};
  made.ownColours = ownColours && isFreeform();
  made.stamp = stamp;
  return made;
}

ActionOperation SculptState::operation(ActionKind kind) const {
  const bool recalls = recall && kind == action;
  ActionOperation operation{options(kind)};
  if (!recalls) return operation;
  operation.recall = recall;
  operation.action.strength = recallStrength;
  return operation;
}

Stroke SculptState::strokeFrom(const StrokePoint& first) const {
  Stroke stroke;
  stroke.points = {first};
  stroke.spacing = spacing;
  stroke.pressure = {pressureStrength, pressureSize};
  stroke.symmetry = symmetry;
  stroke.placement = placement;
  if (placement.anchored) stroke.placement.jitter = {};  // printed is what was dragged
  return stroke;
}

bool SculptState::leads(ActionKind now) const {
  return movesClay(now) && !(recall && now == action);
}

Stroke SculptState::strokeBy(ActionKind now, const StrokePoint& first) const {
  Stroke stroke = strokeFrom(first);
  return leads(now) ? clay::withoutIdle(std::move(stroke)) : stroke;
}

StrokePoint SculptState::pointBy(ActionKind now, StrokePoint point) const {
  if (leads(now) && !pressureSize) point.pressure = 1;
  return point;
}

ActionKind actionFor(ActionKind chosen, Held held) {
  if (held == Held::smooth) return smooth;
  if (held == Held::hold) return ActionKind::hold;
  return held == Held::invert ? rowOf(chosen).inverse : chosen;
}

std::span<const Colour, 14> clayColours() { return kColours; }

}  // namespace bozzetto::ui
