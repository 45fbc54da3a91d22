// Strokes: from the pointer, or from a tool held in space, to the worker.
#include "ui/atelier.hpp"

namespace bozzetto::ui {

GroundHit Atelier::heldGround() const { return {heldTool_->position, view.back()}; }

ToolShape Atelier::toolAt(const GroundHit& ground) const {
  ToolShape tool = sculpt.tool(ground.normal, view.back());
  if (heldTool_) {
    tool.rotation = heldTool_->rotation;
  } else if (sculpt.leads(actionNow())) {
    tool.rotation = sculpt.standing(tool, ground.normal);
  }
  return tool;
}

HandOperations Atelier::handAt(const GroundHit& ground) const {
  return {sculpt.toolOperation(toolAt(ground)), sculpt.operation(actionNow()), {sculpt.clay}};
}

std::optional<Press> Atelier::pressOn(const GroundHit& ground) const {
  if (actionNow() != ActionKind::push || !sculpt.leads(ActionKind::push)) return std::nullopt;
  return Press(toolAt(ground), sculpt, status_.scale.spacing);
}

void Atelier::beginStroke(double pressure) {
  if (toolComes()) {
    gesture_ = Gesture::none;
    return;
  }
  if (heldTool_ && puckMoves == Moves::tool) return beginHeldStroke();
  const StrokeMaker::Setting setting{view, extent_, status_.scale.spacing,
                                     airPoint_.value_or(view.target),
                                     [this](const GroundHit& ground) { return pressOn(ground); }};
  maker_.emplace(patches_, sculpt, setting);
  const auto first = maker_->begin(pointer_, pressure);
  if (!first) {
    maker_.reset();
    gesture_ = Gesture::none;
    return;
  }
  tellEye();
  worker_.post([hand = handAt(maker_->start()), stroke = sculpt.strokeBy(actionNow(), *first)](
                   ClayDesk& desk) { desk.beginStroke(hand, stroke); });
}

void Atelier::beginHeldStroke() {
  if (anotherComes()) return;
  if (!heldTool_) heldTool_ = HeldTool{hover_.point(), sculpt.rotation};
  heldStroke_ = true;
  tellEye();
  worker_.post([hand = handAt(heldGround()),
                stroke = sculpt.strokeBy(actionNow(), {heldTool_->position, 1})](ClayDesk& desk) {
    desk.beginStroke(hand, stroke);
  });
}

void Atelier::continueStroke(double pressure) {
  if (heldStroke_) {
    points_.push_back({heldTool_->position, 1});
  } else if (maker_) {
    const auto next = maker_->move(pointer_, pressure);
    if (next) points_.push_back(sculpt.pointBy(actionNow(), *next));
  }
  flushStroke();
}

// What moves in a stroke is shown as it is seen from here.
void Atelier::tellEye() {
  const Camera eye = viewFrame().camera;
  if (toldEye_ == eye) return;
  toldEye_ = eye;
  worker_.post([eye](ClayDesk& desk) { desk.seenFrom(eye); });
}

void Atelier::flushStroke() {
  if (points_.empty()) return;
  tellEye();
  worker_.post(
      [points = std::exchange(points_, {})](ClayDesk& desk) { desk.extendStroke(points); });
}

void Atelier::endStroke() {
  flushStroke();
  // Strokes in the air go on from where this one ended.
  if (maker_) airPoint_ = maker_->last();
  maker_.reset();
  heldStroke_ = false;
  worker_.post([](ClayDesk& desk) { desk.endStroke(); });
}

bool Atelier::followsStroke() const { return status_.inStroke && !maker_ && !heldStroke_; }

void Atelier::cancelStroke() {
  if (!maker_ && !heldStroke_) return;
  maker_.reset();
  heldStroke_ = false;
  points_.clear();
  gesture_ = Gesture::none;
  worker_.post([](ClayDesk& desk) { desk.cancelStroke(); });
}

}  // namespace bozzetto::ui
