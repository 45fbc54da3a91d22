// What pointer, keys and puck do in the viewport.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "ui/atelier.hpp"

namespace bozzetto::ui {
namespace {

constexpr double kPuckUnitsPerSecond = 0.9;  // of the view's height
constexpr double kPuckRadiansPerSecond = 1.6;
constexpr double kDragFactor = 220;  // pixels for e-fold of size, at scale 1

bool movesView(Gesture gesture) {
  return gesture == Gesture::orbit || gesture == Gesture::pan || gesture == Gesture::zoom;
}

}  // namespace

void Atelier::pointer(const PointerMoved& event) {
  const glm::dvec2 to = event.at - corner_;
  pressure_ = event.pressure;
  hover_.inside = isInside(to);
  if (gesture_ != Gesture::none) dragTo(to);
  pointer_ = to;
  touch();
  if (!movesView(gesture_)) updateHover();
}

void Atelier::panelsHavePointer(bool have) {
  if (gesture_ != Gesture::none) return;
  hover_.inside = !have && isInside(pointer_);
}

bool Atelier::isInside(glm::dvec2 pixel) const {
  return pixel.x >= 0 && pixel.y >= 0 && pixel.x < extent_.width && pixel.y < extent_.height;
}

void Atelier::updateHover() {
  const Ray ray = rayThrough(view, extent_, pointer_);
  hover_.ground = groundUnder(patches_, ray, status_.scale.spacing);
  hover_.air = onFacingPlane(view, ray, airPoint_.value_or(view.target));
  if (gesture_ == Gesture::boxHandle) return;
  if (gesture_ != Gesture::solid) hoverSolid();
  findLight();
  boxHandle_.reset();
  if (const auto box = boxOutline()) boxHandle_ = handleAt(shotOf(viewFrame()), *box, pointer_);
}

Gesture Atelier::gestureFor(Button button, Modifiers with) const {
  const bool blender = keymap.profile() == KeyProfile::blender;
  const bool onGround = hover_.ground.has_value();
  if (button == Button::middle || (blender && button == Button::left && with.alt)) {
    if (mouseMoves == Moves::light) return Gesture::light;
    if (with.shift) return Gesture::pan;
    return with.ctrl ? Gesture::zoom : Gesture::orbit;
  }
  if (button == Button::left && movingReference) return Gesture::reference;
  if (button == Button::left && lightHandle_) return Gesture::lightHandle;
  if (button == Button::left && lassoNext_) return Gesture::lasso;
  if (button == Button::left && boxHandle_) return Gesture::boxHandle;
  if (button == Button::left && supportAt(pointer_)) return Gesture::support;
  if (button == Button::left && mode_ == WorkMode::solid) return Gesture::solid;
  if (button == Button::left) {
    const bool turns = sculpt.emptyDrag == EmptyDrag::orbit && !onGround;
    return turns ? Gesture::orbit : Gesture::stroke;
  }
  if (blender) return Gesture::sizeAndStrength;
  if (with.alt) return Gesture::pan;
  return with.ctrl ? Gesture::zoom : Gesture::orbit;
}

void Atelier::press(Button button, Modifiers with) {
  held_ = with;
  touch();
  if (gestureByKey_) {  // F and its kin: the left button takes the value, others give it back
    if (button != Button::left) sculpt = before_;
    gesture_ = Gesture::none;
    gestureByKey_ = false;
    return;
  }
  if (gesture_ == Gesture::pickColour) {
    pickColour();
    return;
  }
  if (gesture_ != Gesture::none) return;
  if (combining_ && button == Button::left) {
    if (sculpt.isFreeform()) return combineTool(*combining_);
    combining_.reset();
  }
  pressedAt_ = pointer_;
  before_ = sculpt;
  gesture_ = gestureFor(button, with);
  const bool onClay = gesture_ == Gesture::stroke || gesture_ == Gesture::solid ||
                      gesture_ == Gesture::support || gesture_ == Gesture::lasso;
  if (onClay && anotherComes()) gesture_ = Gesture::none;
  if (gesture_ == Gesture::solid && !beginSolid()) gesture_ = Gesture::none;
  if (gesture_ == Gesture::support) chosenSupport = supportAt(pointer_);
  if (gesture_ == Gesture::lasso) beginLasso();
  if (gesture_ == Gesture::stroke) beginStroke(pressure_);
}

void Atelier::release(Button) {
  touch();
  if (gestureByKey_ || gesture_ == Gesture::pickColour) return;
  if (gesture_ == Gesture::stroke) endStroke();
  if (gesture_ == Gesture::solid) endSolid();
  if (gesture_ == Gesture::lasso) endLasso();
  if (gesture_ == Gesture::support) settleSupport();
  gesture_ = Gesture::none;
  updateHover();
}

void Atelier::dragTo(glm::dvec2 to) {
  const ViewState before = view;
  switch (gesture_) {
    case Gesture::stroke:
      pointer_ = to;
      continueStroke(pressure_);
      return;
    case Gesture::orbit:
      orbit(view, extent_, pointer_, to, settings.orbit);
      break;
    case Gesture::pan:
      pan(view, extent_, to - pointer_);
      break;
    case Gesture::zoom:
      zoom(view, extent_, (pointer_.y - to.y) / (20 * scale_), pressedAt_);
      break;
    case Gesture::light:
      turnLight(to - pointer_);
      return;
    case Gesture::lightHandle:
      dragLight(to);
      return;
    case Gesture::boxHandle:
      dragBox(to - pointer_);
      return;
    case Gesture::support:
      dragSupport(to);
      return;
    case Gesture::reference:
      dragReference(to);
      return;
    case Gesture::solid:
      dragSolid(to);
      return;
    case Gesture::lasso:
      drawLasso(to);
      return;
    default:
      dragValues(to - pointer_);
      return;
  }
  movedView(before);
}

// Size and strength by dragging: right or up is more.
void Atelier::dragValues(glm::dvec2 by) {
  by /= scale_;
  const auto strengthen = [&](double amount) {
    double& strength = sculpt.strengthOf(sculpt.action);
    strength = std::clamp(strength + amount, 0.01, 1.0);
  };
  switch (gesture_) {
    case Gesture::size:
      scaleSize(std::exp(by.x / kDragFactor));
      break;
    case Gesture::strength:
      strengthen(by.x / 300);
      break;
    case Gesture::rotation:
      sculpt.rotation =
          glm::normalize(glm::angleAxis(by.x / 100, glm::dvec3(0, 1, 0)) * sculpt.rotation);
      break;
    case Gesture::sizeAndStrength:
      scaleSize(std::exp(-by.y / kDragFactor));
      strengthen(by.x / 300);
      break;
    default:
      break;
  }
}

void Atelier::scaleSize(double factor) {
  const double spacing = status_.scale.spacing;
  sculpt.size = std::clamp(sculpt.size * factor, kSmallestToolCells * spacing, 256 * spacing);
}

void Atelier::wheel(double notches, Modifiers with) {
  touch();
  if (movingReference && (with.ctrl || with.shift)) return wheelReference(notches, with);
  if (with.ctrl) return moveToolDepth(notches);
  if (with.shift) return scaleSize(std::pow(1.1, notches));
  const ViewState before = view;
  zoom(view, extent_, notches, pointer_);
  movedView(before);
}

// The working point in the air, nearer or farther.
void Atelier::moveToolDepth(double notches) {
  const glm::dvec3 from = hover_.ground ? hover_.ground->position : hover_.air;
  airPoint_ = from - view.back() * (notches * sculpt.size * 0.5);
  updateHover();
}

bool Atelier::key(const Chord& chord, bool repeated) {
  touch();
  if (chord.key == KeyCode::escape) {
    const bool idle = gesture_ == Gesture::none && !paletteOpen && !movingReference;
    if (gesture_ == Gesture::none) dropCurve();
    if (gesture_ == Gesture::lasso || gesture_ == Gesture::support) gesture_ = Gesture::none;
    leaveSupport();
    dropParts();
    cancelStroke();
    if (followsStroke()) worker_.giveUpStrokes();
    cancelSolid();
    joinFrom_.reset();
    if (gestureByKey_) sculpt = before_;
    if (gesture_ == Gesture::pickColour || gestureByKey_) gesture_ = Gesture::none;
    gestureByKey_ = false;
    paletteOpen = false;
    movingReference.reset();
    if (const auto running = job(); running && idle) running->cancel();
    if (mouseMoves == Moves::light) takeHold(Moves::scene);
    return true;
  }
  if (gestureByKey_ && chord.key == KeyCode::enter) {
    gesture_ = Gesture::none;
    gestureByKey_ = false;
    return true;
  }
  const auto command = keymap.find(chord);
  if (!command) return false;
  const bool repeats = *command == Command::larger || *command == Command::smaller ||
                       *command == Command::stronger || *command == Command::weaker ||
                       *command == Command::undo || *command == Command::redo ||
                       (*command >= Command::orbitLeft && *command <= Command::orbitDown);
  if (repeated && !repeats) return true;
  runsByKey_ = true;
  if (isPossible(*command)) run(*command);
  runsByKey_ = false;
  return true;
}

// The side under the pointer follows it along its axis.
void Atelier::dragBox(glm::dvec2 by) {
  const auto outline = boxOutline();
  if (!outline || !boxHandle_) return;
  const double spacing = status_.scale.spacing;
  WorkspaceBox box{outline->low * spacing, outline->high * spacing};
  const int axis = *boxHandle_ / 2;
  const bool high = *boxHandle_ % 2 == 1;
  glm::dvec3 place = (box.low + box.high) / 2.0, step(0);
  place[axis] = (high ? box.high : box.low)[axis];
  step[axis] = unitsPerPixel(view, extent_, place);
  const glm::dvec2 way = pixelOf(view, extent_, place + step) - pixelOf(view, extent_, place);
  const double square = glm::dot(way, way);
  if (square < 1e-4) return;
  double& side = (high ? box.high : box.low)[axis];
  side += step[axis] * glm::dot(by, way) / square;
  side = high ? std::max(side, box.low[axis] + spacing) : std::min(side, box.high[axis] - spacing);
  options.boxSize = box;
}

// In its plane before the viewer.
void Atelier::dragReference(glm::dvec2 to) {
  if (!movingReference || *movingReference >= options.references.size()) return;
  glm::dvec3& centre = options.references[*movingReference].picture.centre;
  centre += onFacingPlane(view, rayThrough(view, extent_, to), centre) -
            onFacingPlane(view, rayThrough(view, extent_, pointer_), centre);
}

// With Shift larger and smaller, with Ctrl nearer and farther.
void Atelier::wheelReference(double notches, Modifiers with) {
  if (*movingReference >= options.references.size()) return;
  ReferencePicture& picture = options.references[*movingReference].picture;
  const double factor = std::pow(1.1, notches);
  if (with.ctrl) picture.centre -= view.back() * (notches * .1 * glm::length(picture.up));
  if (with.ctrl) return;
  picture.right *= factor;
  picture.up *= factor;
}

void Atelier::pickColour() {
  gesture_ = Gesture::none;
  const Ray ray = rayThrough(view, extent_, pointer_);
  const auto hit = patches_.pick({ray.origin / status_.scale.spacing, ray.direction});
  if (hit) sculpt.colour = hit->colour;
}

// Six degrees of freedom in the picture's frame: for the scene the hand holds the clay, for the
// tool it holds the tool.
void Atelier::puck(const PuckMoved& event) {
  touch();
  const double speed = settings.puckSpeed * event.seconds;
  const double reach = unitsPerPixel(view, extent_, view.target) * extent_.height;
  const glm::dvec3 push = event.push * (speed * kPuckUnitsPerSecond * reach);
  const glm::dvec3 turn = event.turn * (speed * kPuckRadiansPerSecond);
  const double angle = glm::length(turn);
  const glm::dquat spin =
      angle > 1e-12 ? glm::angleAxis(angle, turn / angle) : glm::dquat(1, 0, 0, 0);
  if (puckMoves == Moves::light) {
    options.look.studio.turn += float(turn.y);
    return;
  }
  if (puckMoves == Moves::tool) {
    if (!heldTool_) heldTool_ = HeldTool{hover_.point(), sculpt.rotation};
    const glm::dquat world = view.worldFromView;
    heldTool_->position += world * push;
    heldTool_->rotation =
        glm::normalize(world * spin * glm::conjugate(world) * heldTool_->rotation);
    if (heldStroke_) continueStroke(1);
    return;
  }
  const ViewState before = view;
  view.worldFromView = glm::normalize(view.worldFromView * glm::conjugate(spin));
  view.target -= view.right() * push.x + view.up() * push.y;
  view.distance = std::clamp(view.distance - push.z, reach * 1e-3, 1e12);
  movedView(before);
}

void Atelier::puckButton(const PuckButton& event) {
  touch();
  if (event.number == 0 && puckMoves == Moves::tool) {
    if (event.down) beginHeldStroke();
    if (!event.down && heldStroke_) endStroke();
    return;
  }
  if (event.number == 0 && event.down) run(Command::frameAll);
  if (event.number == 1 && event.down) {
    run(puckMoves == Moves::scene ? Command::moveTool : Command::moveScene);
  }
}

}  // namespace bozzetto::ui
