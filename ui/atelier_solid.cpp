// Solid mode: what pointer and panels do to a deformable solid. All of it leaves as operations;
// while something is dragged the worker shows what it would do.
#include <glm/geometric.hpp>

#include "ui/atelier.hpp"

namespace bozzetto::ui {
namespace {

constexpr double kReachPixels = 12;

}  // namespace

void Atelier::setMode(WorkMode mode) {
  if (mode == mode_) return;
  cancelStroke();
  mode_ = mode;
  solidHit_ = {};
  joinFrom_.reset();
  tellSolid();
}

// How it is to be shown.
void Atelier::tellSolid() {
  const WrapShown wrap = mode_ == WorkMode::solid ? WrapShown::asPosed : WrapShown::asClayIs;
  worker_.post(
      [wish = SolidWish{solid.map, sculpt.colour, wrap}](ClayDesk& desk) { desk.showSolid(wish); });
}

PickRay Atelier::solidRay() const {
  const Ray ray = rayThrough(view, extent_, pointer_);
  PickRay along{ray.origin, ray.direction};
  const double depth = std::max(glm::length(view.eye() - view.target), 1e-9);
  along.reach = kReachPixels * scale_ * unitsPerPixel(view, extent_, view.target) / depth;
  return along;
}

SolidHit Atelier::controlUnder() const {
  const PickRay ray = solidRay();
  const auto picked = pickAlong(solidShown_->control(), solidShown_->topology, solidElement(), ray);
  if (picked.empty()) return {};
  const Id n = picked.front().element;
  // A point is taken where it is, not where the ray passes it.
  if (solidElement() == Element::point) return {n, solidShown_->control().points[n]};
  return {n, ray.origin + ray.direction * picked.front().depth};
}

// Of the solid's surface; in a wrap, of the clay's, where there is some.
SolidHit Atelier::massUnder() const {
  const Lattice& mass = solidShown_->mass;
  const PickRay ray = solidRay();
  if (solidShown_->solid->isWrap()) {
    if (const auto clay = groundUnder(patches_, {ray.origin, ray.direction}, status_.scale.spacing))
      return {nearest(mass, solidShown_->topology, Element::point, clay->position), clay->position};
  }
  const auto picked = pickAlong(mass, solidShown_->topology, Element::face, ray);
  if (picked.empty()) return {};
  SolidHit hit{kNoId, ray.origin + ray.direction * picked.front().depth};
  for (const Id n : mass.faces[picked.front().element]) {
    const double distance = glm::distance(mass.points[n], hit.place);
    if (hit.element == kNoId || distance < glm::distance(mass.points[hit.element], hit.place))
      hit.element = n;
  }
  return hit;
}

Element Atelier::solidElement() const {
  return solid.tool == SolidTool::sharp ? solid.sharpens : rowOf(solid.tool).element;
}

void Atelier::hoverSolid() {
  solidHit_ = {};
  curve_.handle.reset();
  if (mode_ != WorkMode::solid || !solidShown_) return;
  const SolidToolRow& row = rowOf(solid.tool);
  solidHit_ = row.reach == SolidReach::control ? controlUnder() : massUnder();
  const bool takesPoint = row.grip == SolidGrip::drag || row.grip == SolidGrip::curve;
  if (row.reach == SolidReach::surface && takesPoint && solidHit_.element != kNoId)
    solidHit_.place = solidShown_->mass.points[solidHit_.element];
  if (row.grip == SolidGrip::curve) hoverCurve();
}

bool Atelier::beginSolid() {
  hoverSolid();
  const SolidGrip grip = rowOf(solid.tool).grip;
  if (grip == SolidGrip::curve) return beginCurve();
  if (solidHit_.element == kNoId) return false;
  dragged_ = handTo_ = solidHit_.place;
  if (solid.tool == SolidTool::rope || grip == SolidGrip::touch) beginFelt();
  if (grip == SolidGrip::drag) return true;
  workSolid();
  if (grip == SolidGrip::touch) touchSolid();
  return grip == SolidGrip::brush || grip == SolidGrip::touch;
}

// A click or a dab of a brush.
void Atelier::workSolid() {
  const bool inverse = heldMeaning() == Held::invert;
  const glm::dvec3& place = solidHit_.place;
  const glm::dvec3 at = rowOf(solid.tool).reach == SolidReach::surface
                            ? place
                            : middleOf(solidShown_->control(), solidShown_->topology,
                                       solidElement(), solidHit_.element);
  switch (solid.tool) {
    case SolidTool::carve:
      return applySolid(SolidCarveOperation{at});
    case SolidTool::extrude:
      return applySolid(SolidExtrudeOperation{at, solid.length});
    case SolidTool::join:
      if (!joinFrom_) return void(joinFrom_ = at);
      return applySolid(SolidJoinOperation{*std::exchange(joinFrom_, std::nullopt), at});
    case SolidTool::subdivide:
      return applySolid(SolidSubdivideOperation{at});
    case SolidTool::sharp:
      return applySolid(SolidSharpOperation{solid.sharpens, at, inverse ? Sharp::no : Sharp::yes});
    case SolidTool::mass:
    case SolidTool::stiffness: {
      const Matter matter = solid.tool == SolidTool::mass ? Matter::mass : Matter::hardness;
      const double factor = inverse ? 1 / solid.factor : solid.factor;
      return applySolid(SolidPaintOperation{matter, place, solid.radius, factor});
    }
    case SolidTool::inflate: {
      const double amount = inverse ? -solid.amount / (1 + solid.amount) : solid.amount;
      return applySolid(SolidInflateOperation{place, solid.radius, amount, solid.steps});
    }
    case SolidTool::trim:
      return applySolid(
          SolidTrimOperation{place, solid.radius, inverse ? TakesPart::yes : TakesPart::no});
    case SolidTool::probe:
      return applySolid(SolidProbeOperation{place, solid.radius});
    case SolidTool::move:
    case SolidTool::rope:
    case SolidTool::spline:
      return;
  }
}

void Atelier::applySolid(const Operation& operation) { apply(operation); }

// What a drag of the hand from `solidHit_` to `dragged_` means.
Operation Atelier::solidDrag() const {
  const glm::dvec3 by = dragged_ - solidHit_.place;
  if (solid.tool == SolidTool::move) return SolidMoveOperation{solidHit_.element, by};
  if (solid.tool == SolidTool::spline)
    return SolidSplineOperation{curveStart_, {{*curve_.handle, by}}, solid.steps};
  SolidPullOperation pull;
  pull.ropes = {{solidHit_.place, dragged_}};
  pull.steps = solid.steps;
  return pull;
}

void Atelier::dragSolid(glm::dvec2 to) {
  pointer_ = to;
  const SolidGrip grip = rowOf(solid.tool).grip;
  if (grip == SolidGrip::touch) return touchSolid();
  if (grip == SolidGrip::brush) return brushSolid();
  handTo_ = onFacingPlane(view, rayThrough(view, extent_, to), solidHit_.place);
  if (felt_) felt_->place(handTo_);
  followHand();
}

// A dab every half radius.
void Atelier::brushSolid() {
  const SolidHit hit = massUnder();
  if (hit.element == kNoId || glm::distance(hit.place, dragged_) < solid.radius / 2) return;
  solidHit_ = hit;
  dragged_ = hit.place;
  workSolid();
}

void Atelier::endSolid() {
  const SolidGrip grip = rowOf(solid.tool).grip;
  const bool drags = grip == SolidGrip::drag || grip == SolidGrip::curve;
  if (drags) dragged_ = felt_ ? felt_->tool() : handTo_;
  if (drags && dragged_ != solidHit_.place) applySolid(solidDrag());
  felt_.reset();
  previewing_ = false;
}

void Atelier::cancelSolid() {
  if (gesture_ != Gesture::solid) return;
  gesture_ = Gesture::none;
  felt_.reset();
  previewing_ = false;
  tellSolid();
}

void Atelier::makeBlock() {
  SolidOperation made;
  made.block.cells = solid.cells;
  made.block.edge = glm::dvec3(solid.edge);
  made.block.centre = view.target;
  applySolid(made);
}

void Atelier::wrapClay() {
  WrapOperation wrap{solid.cells, std::nullopt};
  if (options.box && options.boxSize) wrap.box = {{options.boxSize->low, options.boxSize->high}};
  applySolid(wrap);
}

void Atelier::applyWrap() {
  const WrapOptions how{solid.bakeLevels, solid.keepMass ? KeepMass::yes : KeepMass::no};
  begin("Carrying the clay along", [how](ClayDesk& desk, Progress& progress) {
    desk.apply(WrapApplyOperation{how}, progress);
  });
}

void Atelier::bakeSolid() {
  const BakeOptions how{solid.bakeLevels, sculpt.colour};
  begin("Baking the solid",
        [how](ClayDesk& desk, Progress& progress) { desk.apply(BakeOperation{how}, progress); });
}

void Atelier::solidWindow() {
  SolidWindowOperation window;
  if (options.box && options.boxSize) window.box = {{options.boxSize->low, options.boxSize->high}};
  applySolid(window);
}

bool Atelier::runSolid(Command command) {
  if (command >= Command::solidMove && command <= Command::solidProbe) {
    setMode(WorkMode::solid);
    solid.tool = SolidTool(int(command) - int(Command::solidMove));
    solidHit_ = {};
    joinFrom_.reset();
    dropCurve();
    return true;
  }
  switch (command) {
    case Command::solidMode:
      setMode(mode_ == WorkMode::solid ? WorkMode::clay : WorkMode::solid);
      return true;
    case Command::solidBlock:
      setMode(WorkMode::solid);
      makeBlock();
      return true;
    case Command::solidFromClay:
      setMode(WorkMode::solid);
      applySolid(SolidFromClayOperation{solid.coarse});
      return true;
    case Command::wrap:
      setMode(WorkMode::solid);
      wrapClay();
      return true;
    case Command::wrapApply:
      applyWrap();
      return true;
    case Command::bake:
      bakeSolid();
      return true;
    case Command::solidRun:
      applySolid(SolidRunOperation{solid.steps});
      return true;
    case Command::solidRest:
      applySolid(SolidRestOperation{});
      return true;
    case Command::solidDrop:
      applySolid(SolidDropOperation{});
      return true;
    default:
      return false;
  }
}

}  // namespace bozzetto::ui
