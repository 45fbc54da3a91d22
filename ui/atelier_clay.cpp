// Clay that behaves like clay: what is held, what stands in its way, and running its layers.
#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "bozzetto/clay/thin_support.hpp"
#include "ui/atelier.hpp"

namespace bozzetto::ui {
namespace {

constexpr double kKnobPixels = 14;
constexpr double kTurnPixels = 100;    // for a radian, at scale 1
constexpr float kSupportBehind = .1f;  // of a support, seen behind clay

// `mesh` in cells of the sculpture, from its middle.
ToolGhost supportGhost(const clay::Support& support, std::shared_ptr<const ToolMesh> mesh,
                       double spacing) {
  const Sculpture& sculpture = *support.sculpture;
  const glm::dmat4 turn(glm::mat3_cast(normalisedRotation(support.rotation)));
  const glm::dvec3 cells = support.radii / (sculpture.halfExtents() * spacing);
  ToolGhost ghost;
  ghost.mesh = std::move(mesh);
  ghost.cellsFromTool = glm::translate(glm::dmat4(1), support.centre / spacing) * turn *
                        glm::scale(glm::dmat4(1), cells);
  return ghost;
}

}  // namespace

void Atelier::relax() {
  begin("Relaxing",
        [settings = ClayOperation{sculpt.clay}, steps = relaxSteps](
            ClayDesk& desk, Progress& progress) { desk.relax(settings, steps, progress); });
}

void Atelier::tellClay() {
  std::string text = toText(ClayOperation{sculpt.clay});
  if (status_.inStroke || !jobs_.empty() || text == toldClay_) return;
  toldClay_ = std::move(text);
  worker_.post([clay = ClayOperation{sculpt.clay}](ClayDesk& desk) { desk.behave(clay); });
}

// In the workspace box; the first time that is shown.
void Atelier::holdBox() {
  if (!options.box || !options.boxSize) {
    say(Message::Kind::note, "This is the box: hold once more, and what is in it is held");
    return run(Command::fitBox);
  }
  apply(HoldOperation{options.boxSize->low, options.boxSize->high, 1});
}

void Atelier::placeTable() {
  const double spacing = status_.scale.spacing;
  const CellBounds& all = patches_.bounds();
  clay::Support table;
  const glm::dvec3 low = all.empty() ? glm::dvec3(-48) : all.low;
  const glm::dvec3 high = all.empty() ? glm::dvec3(48) : all.high;
  const glm::dvec3 half = (high - low) * (spacing / 2);
  table.radii = {half.x * 1.3, std::max(4 * spacing, half.y * 0.06), half.z * 1.3};
  table.centre = (low + high) * (spacing / 2);
  table.centre.y = low.y * spacing - table.radii.y;
  apply(SupportOperation{table});
  chosenSupport = status_.clay.supports.size();
}

// As its ghost stands there; a sculpture on its pivot.
void Atelier::placeToolAsSupport(const glm::dvec3& at) {
  const GroundHit ground = hover_.ground.value_or(GroundHit{at, view.back()});
  ToolShape tool = toolAt(ground);
  if (!heldTool_) tool.rotation = sculpt.standing(tool, ground.normal);
  SupportOperation operation{{tool.shape, at, tool.radii, tool.rotation}};
  if (tool.sculpture) {
    const glm::dvec3 pivot = tool.sculpture->pivot() / tool.sculpture->halfExtents();
    operation.support.centre -= normalisedRotation(tool.rotation) * (pivot * tool.radii);
    operation.source = sculpt.freeform->source;
  }
  apply(operation);
  chosenSupport = status_.clay.supports.size();
}

void Atelier::moveSupport(std::size_t n, const clay::Support& support) {
  touch();
  if (!movedSupport_) movedSupport_ = MovedSupport{n, status_.clay.supports[n], support};
  movedSupport_->now = support;
  showMovedSupport();
}

// What is drawn does not wait for the desk, which knows nothing of it yet.
void Atelier::showMovedSupport() {
  auto& supports = status_.clay.supports;
  if (movedSupport_ && movedSupport_->number < supports.size())
    supports[movedSupport_->number] = movedSupport_->now;
}

void Atelier::settleSupport() {
  const auto moved = std::exchange(movedSupport_, std::nullopt);
  if (moved && !(moved->now == moved->before))
    apply(SupportMoveOperation{int(moved->number), {moved->now}});
}

// As it was before it was taken.
void Atelier::leaveSupport() {
  if (!movedSupport_) return;
  movedSupport_->now = movedSupport_->before;
  showMovedSupport();
  movedSupport_.reset();
}

void Atelier::dropSupport(std::size_t n) {
  chosenSupport.reset();
  apply(SupportDropOperation{int(n)});
}

std::optional<std::size_t> Atelier::supportAt(glm::dvec2 pixel) const {
  const auto& supports = status_.clay.supports;
  for (std::size_t n = 0; n < supports.size(); ++n) {
    const glm::dvec2 knob = pixelOf(view, extent_, supports[n].centre);
    if (glm::length(knob - pixel) < kKnobPixels * scale_) return n;
  }
  return std::nullopt;
}

// Along the plane that faces the viewer, with Ctrl towards him; with Shift it turns, as a ball
// under the pointer would.
void Atelier::dragSupport(glm::dvec2 to) {
  if (!chosenSupport || *chosenSupport >= status_.clay.supports.size()) return;
  clay::Support support = status_.clay.supports[*chosenSupport];
  const glm::dvec2 by = to - pointer_;
  if (held_.shift) {
    const glm::dvec2 angles = by / (kTurnPixels * scale_);
    const glm::dquat turn =
        glm::angleAxis(angles.x, view.up()) * glm::angleAxis(angles.y, view.right());
    support.rotation = glm::normalize(turn * normalisedRotation(support.rotation));
  } else if (held_.ctrl) {
    support.centre += view.back() * (by.y * unitsPerPixel(view, extent_, support.centre));
  } else {
    const glm::dvec3 from =
        onFacingPlane(view, rayThrough(view, extent_, pointer_), support.centre);
    support.centre += onFacingPlane(view, rayThrough(view, extent_, to), support.centre) - from;
  }
  moveSupport(*chosenSupport, support);
}

void Atelier::addSupports(Overlays& overlays) const {
  const double spacing = status_.scale.spacing;
  const auto& supports = status_.clay.supports;
  for (std::size_t n = 0; n < supports.size(); ++n) {
    const clay::Support& support = supports[n];
    const ToolShape shape{support.shape, Profile::box, clay::metRadii(support, spacing),
                          support.rotation};
    ToolGhost ghost = support.shape == Shape::freeform
                          ? supportGhost(support, status_.supportMeshes[n], spacing)
                          : bodyOf(shape, support.centre / spacing);
    ghost.display = ToolDisplay::transparent;
    ghost.hidden = kSupportBehind;
    ghost.ink = n == chosenSupport ? Ink(.373f, .722f, .788f, 1) : Ink(.62f, .66f, .72f, 1);
    overlays.tools.push_back(ghost);
  }
}

}  // namespace bozzetto::ui
