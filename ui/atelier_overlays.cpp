// What is drawn over the clay: ring, tool, working plane, box.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "bozzetto/tool/symmetry.hpp"
#include "ui/atelier.hpp"

namespace bozzetto::ui {
namespace {

constexpr Ink kAdding{1, .725f, .541f, 1};       // #FFB98A
constexpr Ink kCarving{.435f, .780f, .839f, 1};  // #6FC7D6
constexpr Ink kLasso{.98f, .86f, .42f, 1};

Ink inkFor(ActionKind action, Colour colour) {
  switch (action) {
    case ActionKind::add:
      return kAdding;
    case ActionKind::paint:
    case ActionKind::paintSoft:
      return {float(colour.r) / 255, float(colour.g) / 255, float(colour.b) / 255, 1};
    case ActionKind::smooth:
      return {.86f, .87f, .88f, 1};
    default:
      return kCarving;
  }
}

std::shared_ptr<const ToolMesh> meshFor(Shape shape, const glm::dvec3& radii, ToolDisplay display) {
  const Rounding rounding = display == ToolDisplay::wire ? Rounding::wires : Rounding::smooth;
  switch (shape) {
    case Shape::box:
      return unitMesh(UnitShape::box);
    case Shape::cylinder:
      return unitMesh(UnitShape::cylinder, rounding);
    case Shape::capsule:
      return capsuleMesh(glm::vec3(radii), rounding);
    default:
      return unitMesh(UnitShape::ball, rounding);
  }
}

constexpr int kMostRings = 64;  // of an array's copies

// Where the potential falls to one half: what the tool leaves behind, roughly.
double coreOf(Profile profile) { return profile == Profile::wyvill ? 0.5 : 0.85; }
// Tools that move clay have their surface at their radii.
double coreOf(const SculptState& sculpt) {
  if (movesClay(sculpt.action)) return 1;
  return sculpt.isFreeform() ? 0.75 : coreOf(sculpt.profile);
}

glm::dmat4 placed(const glm::dvec3& at, const glm::dmat3& turn, const glm::dvec3& radii) {
  return glm::translate(glm::dmat4(1), at) * glm::dmat4(turn) * glm::scale(glm::dmat4(1), radii);
}

}  // namespace

Overlays Atelier::overlays() const {
  Overlays overlays;
  addStage(overlays);
  addSupports(overlays);
  addSolid(overlays);
  if (mode_ == WorkMode::solid) return overlays;
  const bool busy = gesture_ == Gesture::orbit || gesture_ == Gesture::pan ||
                    gesture_ == Gesture::zoom || gesture_ == Gesture::light || lightHandle_ ||
                    movingReference;
  const bool held = heldTool_ && puckMoves == Moves::tool;
  if ((hover_.inside && !busy && dialog == Dialog::none) || held) {
    if (options.ring) addRings(overlays);
    addTool(overlays);
  } else if (standOpen && sculpt.isFreeform() && !busy && dialog == Dialog::none) {
    addShownTool(overlays);
  }
  return overlays;
}

// The cursor and, thinner, its images.
void Atelier::addRings(Overlays& overlays) const {
  const double spacing = status_.scale.spacing;
  const bool held = heldTool_ && puckMoves == Moves::tool;
  const bool onClay = hover_.ground.has_value() && !held;
  if (!onClay && !sculpt.air && !held) return;
  RingCursor ring;
  ring.on = onClay ? RingCursor::On::clay : RingCursor::On::air;
  ring.centre = (held ? heldTool_->position : hover_.point()) / spacing;
  ring.normal = onClay ? hover_.ground->normal : view.back();
  ring.radius = sculpt.size / spacing * coreOf(sculpt);
  if (draggedAnchor()) {
    const Stand stand = standOn({}, toolAt(maker_->start()));
    ring.centre = stand.at / spacing;
    ring.normal = maker_->start().normal;
    ring.radius *= stand.growth;
  }
  ring.ink = inkFor(actionNow(), sculpt.colour);
  const glm::dvec3 centre = sculpt.symmetry.centre / spacing;
  const auto& [right, up, back] = sculpt.placement.copies;
  for (int n = 0; n < std::min(right * up * back, kMostRings); ++n) {
    const glm::dvec3 steps(n % right, n / right % up, n / right / up);
    const glm::dvec3 at = ring.centre + steps * sculpt.placement.copyStep / spacing;
    for (const glm::dmat3& image : imagesOf(sculpt.symmetry)) {
      RingCursor copy = ring;
      copy.centre = centre + image * (at - centre);
      copy.normal = image * ring.normal;
      copy.weight = overlays.rings.empty() ? 1 : .5f;
      overlays.rings.push_back(copy);
    }
  }
}

void Atelier::addTool(Overlays& overlays) const {
  if (options.tool == ToolDisplay::hidden) return;
  const double spacing = status_.scale.spacing;
  const bool held = heldTool_ && puckMoves == Moves::tool;
  if (!held && !hover_.ground && !sculpt.air) return;
  GroundHit ground = hover_.ground.value_or(GroundHit{hover_.air, view.back()});
  if (held) ground = heldGround();
  const bool pushes = sculpt.leads(actionNow()) && maker_ && !held;
  const ToolShape tool = toolAt(pushes ? maker_->start() : ground);
  if (!held) ground.position = toolPlace(ground);
  const Stand stand = standOn(ground, tool);
  overlays.tools.push_back(ghostOf(tool, stand));
  if (standOpen && tool.sculpture) addMarks(tool, stand, overlays);
  if (hover_.ground && !held) return;
  const glm::dvec3 at = ground.position / spacing;
  const double core = coreOf(sculpt);
  WorkingPlane plane;
  plane.centre = at;
  plane.normal = view.back();
  plane.radius = 3.2 * sculpt.size / spacing;
  plane.toolRadius = sculpt.size / spacing * core;
  plane.shadowFloor = status_.stage.floor;
  overlays.plane = plane;
}

// Where the pointer's tool is, or would be; in a push not where the clay has gone meanwhile.
glm::dvec3 Atelier::toolPlace(const GroundHit& ground) const {
  const auto press = pressOn(ground);
  if (press && maker_) return maker_->last();
  const glm::dvec3 at = ground.position + ground.normal * (sculpt.depth * sculpt.size);
  if (!press || !hover_.ground) return at;
  const Ray ray = rayThrough(view, extent_, pointer_);
  const double spacing = status_.scale.spacing;
  return at + press->lift(broadNormal(patches_, ray, ground, press->radius(), spacing), 1);
}

ToolGhost Atelier::ghostOf(const ToolShape& tool, const Stand& stand) const {
  ToolGhost ghost = tool.sculpture ? sculptureGhost(tool, stand) : primitiveGhost(tool, stand);
  ghost.display = options.tool;
  ghost.ink = inkFor(actionNow(), sculpt.colour);
  return ghost;
}

// What the pointer would meet in the middle of the view.
GroundHit Atelier::middleOfView() const {
  const Ray ray = rayThrough(view, extent_, glm::dvec2(extent_.width, extent_.height) / 2.0);
  return groundUnder(patches_, ray, status_.scale.spacing)
      .value_or(GroundHit{view.target, view.back()});
}

// While its pivot and contact are chosen on a panel.
void Atelier::addShownTool(Overlays& overlays) const {
  const GroundHit ground = middleOfView();
  const ToolShape tool = sculpt.tool(ground.normal, view.back());
  const Stand stand = standOn(ground, tool);
  overlays.tools.push_back(ghostOf(tool, stand));
  if (options.tool == ToolDisplay::hidden) overlays.tools.back().display = ToolDisplay::transparent;
  addMarks(tool, stand, overlays);
}

// A ring round the pivot, and an arrow to it the way the tool touches.
void Atelier::addMarks(const ToolShape& tool, const Stand& stand, Overlays& overlays) const {
  constexpr int kCorners = 32;
  constexpr Ink kMark{.373f, .722f, .788f, 1};
  const double size = sculpt.size / status_.scale.spacing, head = .16 * size;
  const glm::dvec3 at = stand.at / status_.scale.spacing;
  const glm::dvec3 down = stand.turn * SculptState::contactOf(tool);
  const glm::dvec3 helper = std::abs(down.x) < .5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(down, helper)), up = glm::cross(right, down);
  Polyline ring;
  ring.ink = kMark;
  ring.width = 2.5f;
  ring.hidden = .8f;
  Polyline shaft = ring, tips = ring, across = ring;
  ring.closed = true;
  for (int n = 0; n < kCorners; ++n) {
    const double turn = 2 * glm::pi<double>() * n / kCorners;
    ring.points.push_back(at + head * (std::cos(turn) * right + std::sin(turn) * up));
  }
  shaft.points = {at - 1.4 * size * down, at};
  tips.points = {at - head * (1.6 * down - right), at, at - head * (1.6 * down + right)};
  across.points = {at - head * (1.6 * down - up), at, at - head * (1.6 * down + up)};
  for (Polyline* line : {&ring, &shaft, &tips, &across}) overlays.lines.push_back(*line);
}

// An anchored stroke, while it is drawn, stays where it began; the pointer says how large the tool
// is, and which way it lies if it follows strokes.
Atelier::Stand Atelier::standOn(const GroundHit& ground, const ToolShape& tool) const {
  const auto turnOn = [&](const glm::dvec3& normal) {
    const glm::dquat turn =
        sculpt.leads(actionNow()) ? tool.rotation : sculpt.standing(tool, normal);
    return glm::dmat3(glm::mat3_cast(turn));
  };
  if (!draggedAnchor()) return {ground.position, turnOn(ground.normal)};
  const GroundHit& start = maker_->start();
  Stand stand{start.position + start.normal * (sculpt.depth * sculpt.size), turnOn(start.normal)};
  const glm::dvec3 way = maker_->last() - stand.at;
  if (glm::length(way) > 0) stand.growth = glm::length(way) / sculpt.size;
  if (!sculpt.placement.alongStroke) return stand;
  const glm::dvec3 contact = SculptState::contactOf(tool);
  stand.turn = orientationAlong(contact, -(stand.turn * contact), way).value_or(stand.turn);
  return stand;
}

// A primitive tool as something to draw, `part` of its radii large; `at` in cells.
ToolGhost Atelier::bodyOf(const ToolShape& tool, const glm::dvec3& at, double part,
                          ToolDisplay display) const {
  const glm::dvec3 radii = tool.radii * (part / status_.scale.spacing);
  const glm::dmat3 turn = glm::mat3_cast(normalisedRotation(tool.rotation));
  ToolGhost ghost;
  ghost.display = display;
  ghost.mesh = meshFor(tool.shape, radii, display);
  ghost.cellsFromTool = placed(at, turn, tool.shape == Shape::capsule ? glm::dvec3(1) : radii);
  return ghost;
}

ToolGhost Atelier::primitiveGhost(const ToolShape& tool, const Stand& stand) const {
  ToolShape standing = tool;
  standing.rotation = glm::quat_cast(stand.turn);
  standing.radii *= stand.growth;
  const glm::dvec3 at = stand.at / status_.scale.spacing;
  ToolGhost ghost = bodyOf(standing, at, coreOf(sculpt), options.tool);
  if (!options.limit) return ghost;
  const ToolGhost limit = bodyOf(standing, at);
  ghost.limit = limit.mesh;
  ghost.cellsFromLimit = limit.cellsFromTool;
  return ghost;
}

// A sculpture stands on its pivot.
ToolGhost Atelier::sculptureGhost(const ToolShape& tool, const Stand& stand) const {
  const double spacing = status_.scale.spacing;
  const double cell = tool.sculpture->scale().spacing / spacing;
  ToolGhost ghost;
  ghost.mesh = sculpt.freeform->mesh;
  ghost.cellsFromTool =
      glm::translate(placed(stand.at / spacing, stand.turn, tool.scale * (cell * stand.growth)),
                     -tool.sculpture->pivot());
  return ghost;
}

void Atelier::addStage(Overlays& overlays) const {
  if (options.grid) {
    FloorGrid grid;
    grid.centre = {status_.stage.centre.x, status_.stage.floor, status_.stage.centre.z};
    grid.step = std::max(1.0, status_.stage.unit / 4);
    overlays.grid = grid;
  }
  overlays.lights = lightMarks();
  if (auto places = lassoPlaces(); places.size() > 1) {
    Polyline line;
    line.points = std::move(places);
    for (glm::dvec3& place : line.points) place /= status_.scale.spacing;
    line.ink = kLasso;
    line.width = 2;
    line.hidden = 1;
    line.closed = true;
    overlays.lines.push_back(std::move(line));
  }
  for (const Reference& reference : options.references) {
    overlays.pictures.push_back(reference.picture);
    ReferencePicture& picture = overlays.pictures.back();
    for (glm::dvec3* place : {&picture.centre, &picture.right, &picture.up}) {
      *place /= status_.scale.spacing;
    }
  }
  overlays.box = boxOutline();
}

// The workspace box in cells, with handles where the pointer can take them.
std::optional<BoxOutline> Atelier::boxOutline() const {
  const double spacing = status_.scale.spacing;
  const CellBounds& all = patches_.bounds();
  if (!options.box || (!options.boxSize && all.empty())) return std::nullopt;
  BoxOutline box;
  box.low = options.boxSize ? options.boxSize->low / spacing : all.low;
  box.high = options.boxSize ? options.boxSize->high / spacing : all.high;
  box.handles = true;
  box.active = boxHandle_;
  return box;
}

}  // namespace bozzetto::ui
