// Solid mode: what pointer and panels do to a deformable solid. All of it leaves as operations;
// while something is dragged the worker shows what it would do.
#include <glm/geometric.hpp>

#include "ui/atelier.hpp"

namespace bozzetto::ui {
namespace {

constexpr double kReachPixels = 12;

Polyline lineOf(std::vector<glm::dvec3> points, Ink colour, float width) {
  Polyline line;
  line.points = std::move(points);
  line.ink = colour;
  line.width = width;
  return line;
}

constexpr Ink kLattice{.373f, .722f, .788f, .9f}, kWires{.09f, .11f, .14f, .38f};
constexpr Ink kChosen{.941f, .541f, .365f, 1};

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
  worker_.post(
      [wish = SolidWish{solid.map, sculpt.colour}](ClayDesk& desk) { desk.showSolid(wish); });
}

std::vector<SolidHit> Atelier::solidAlong(Element element) const {
  std::vector<SolidHit> hits;
  if (!solidShown_) return hits;
  const Ray ray = rayThrough(view, extent_, pointer_);
  PickRay along{ray.origin, ray.direction};
  const double depth = std::max(glm::length(view.eye() - view.target), 1e-9);
  along.reach = kReachPixels * scale_ * unitsPerPixel(view, extent_, view.target) / depth;
  for (const Picked& picked :
       pickAlong(solidShown_->control(), solidShown_->topology, element, along))
    hits.push_back({picked.element, ray.origin + ray.direction * picked.depth});
  return hits;
}

Element Atelier::solidElement() const {
  return solid.tool == SolidTool::sharp ? solid.sharpens : rowOf(solid.tool).element;
}

void Atelier::hoverSolid() {
  solidHit_ = {};
  if (mode_ != WorkMode::solid) return;
  const auto hits = solidAlong(solidElement());
  if (hits.empty()) return;
  solidHit_ = hits.front();
  // A point is taken where it is, not where the ray passes it.
  if (solidElement() == Element::point) {
    solidHit_.place = solidShown_->control().points[solidHit_.element];
  }
}

bool Atelier::beginSolid() {
  hoverSolid();
  if (solidHit_.element == kNoId) return false;
  dragged_ = solidHit_.place;
  if (rowOf(solid.tool).grip == SolidGrip::drag) return true;
  workSolid();
  return rowOf(solid.tool).grip == SolidGrip::brush;
}

// A click or a dab of a brush.
void Atelier::workSolid() {
  const bool inverse = heldMeaning() == Held::invert;
  const glm::dvec3 at =
      middleOf(solidShown_->control(), solidShown_->topology, solidElement(), solidHit_.element);
  const glm::dvec3& place = solidHit_.place;
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
      return;
  }
}

void Atelier::applySolid(const Operation& operation) { apply(operation); }

// What a drag of the hand from `solidHit_` to `dragged_` means.
Operation Atelier::solidDrag() const {
  if (solid.tool == SolidTool::move)
    return SolidMoveOperation{solidHit_.element, dragged_ - solidHit_.place};
  SolidPullOperation pull;
  pull.ropes = {{solidHit_.place, dragged_}};
  pull.steps = solid.steps;
  return pull;
}

void Atelier::dragSolid(glm::dvec2 to) {
  const SolidGrip grip = rowOf(solid.tool).grip;
  if (grip == SolidGrip::drag) {
    dragged_ = onFacingPlane(view, rayThrough(view, extent_, to), solidHit_.place);
    if (previewing_) return;  // the next one when this has arrived
    previewing_ = true;
    worker_.post([drag = solidDrag()](ClayDesk& desk) { desk.previewSolid(drag); });
    return;
  }
  // A dab every half radius.
  pointer_ = to;
  const auto hits = solidAlong(Element::face);
  if (hits.empty() || glm::distance(hits.front().place, dragged_) < solid.radius / 2) return;
  solidHit_ = hits.front();
  dragged_ = solidHit_.place;
  workSolid();
}

void Atelier::endSolid() {
  if (rowOf(solid.tool).grip == SolidGrip::drag && dragged_ != solidHit_.place)
    applySolid(solidDrag());
  previewing_ = false;
}

void Atelier::cancelSolid() {
  if (gesture_ != Gesture::solid) return;
  gesture_ = Gesture::none;
  previewing_ = false;
  tellSolid();
}

void Atelier::addSolid(Overlays& overlays) const {
  if (mode_ != WorkMode::solid || !solidShown_) return;
  const double spacing = status_.scale.spacing;
  const Lattice& control = solidShown_->control();
  const Topology& topology = solidShown_->topology;
  if (solid.wires && solid.surface) {
    for (const auto& wire : solidShown_->wires) {
      Polyline line = lineOf({wire[0] / spacing, wire[1] / spacing}, kWires, 1);
      line.hidden = 0;
      overlays.lines.push_back(std::move(line));
    }
  }
  if (solid.lattice) {
    for (const auto& [a, b] : topology.edges)
      overlays.lines.push_back(
          lineOf({control.points[a] / spacing, control.points[b] / spacing}, kLattice, 1.3f));
    for (const auto& [a, b] : control.sharpEdges)
      overlays.lines.push_back(
          lineOf({control.points[a] / spacing, control.points[b] / spacing}, kChosen, 2.2f));
  }
  addSolidHit(overlays);
}

// What the tool would take.
void Atelier::addSolidHit(Overlays& overlays) const {
  if (solidHit_.element == kNoId || !hover_.inside) return;
  const double spacing = status_.scale.spacing;
  const Lattice& control = solidShown_->control();
  const Topology& topology = solidShown_->topology;
  const auto edge = [&](Id n) {
    const auto& [a, b] = topology.edges[n];
    overlays.lines.push_back(
        lineOf({control.points[a] / spacing, control.points[b] / spacing}, kChosen, 3));
  };
  switch (solidElement()) {
    case Element::cell:
      for (const Id n : topology.cellEdges[solidHit_.element]) edge(n);
      break;
    case Element::face:
      if (rowOf(solid.tool).grip != SolidGrip::click || solid.tool == SolidTool::probe) break;
      for (const Id n : topology.faceEdges[solidHit_.element]) edge(n);
      break;
    case Element::edge:
      edge(solidHit_.element);
      break;
    case Element::point:
      break;
  }
  if (gesture_ == Gesture::solid && rowOf(solid.tool).grip == SolidGrip::drag)
    overlays.lines.push_back(lineOf({solidHit_.place / spacing, dragged_ / spacing}, kChosen, 2));
  if (rowOf(solid.tool).grip != SolidGrip::brush) return;
  RingCursor ring;
  ring.centre = solidHit_.place / spacing;
  ring.normal = view.back();
  ring.radius = solid.radius / spacing;
  ring.on = RingCursor::On::air;
  overlays.rings.push_back(ring);
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
  whenDone(worker_.start("Carrying the clay along",
                         [how](ClayDesk& desk, Progress& progress) {
                           desk.apply(WrapApplyOperation{how}, progress);
                         }),
           {});
}

void Atelier::bakeSolid() {
  const BakeOptions how{solid.bakeLevels, sculpt.colour};
  whenDone(worker_.start("Baking the solid",
                         [how](ClayDesk& desk, Progress& progress) {
                           desk.apply(BakeOperation{how}, progress);
                         }),
           {});
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
