// What each command does. One place; menus, keys and buttons all come here.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ui/atelier.hpp"

namespace bozzetto::ui {
namespace {

constexpr double kBoxRoom = 2;  // cells: clay has density beyond its surface
constexpr double kQuarter = std::numbers::pi / 2, kStep = kQuarter / 6;

struct NamedView {
  Command command;
  double yaw, pitch;
};
constexpr std::array<NamedView, 6> kViews{{{Command::front, 0, 0},
                                           {Command::back, 2 * kQuarter, 0},
                                           {Command::right, kQuarter, 0},
                                           {Command::left, -kQuarter, 0},
                                           {Command::top, 0, kQuarter},
                                           {Command::bottom, 0, -kQuarter}}};

struct NamedTool {
  Command command;
  ActionKind action;
};
constexpr std::array<NamedTool, 13> kTools{{{Command::toolAdd, ActionKind::add},
                                            {Command::toolRemove, ActionKind::remove},
                                            {Command::toolErase, ActionKind::erase},
                                            {Command::toolSmooth, ActionKind::smooth},
                                            {Command::toolPaint, ActionKind::paint},
                                            {Command::toolPaintSoft, ActionKind::paintSoft},
                                            {Command::toolStamp, ActionKind::stamp},
                                            {Command::toolPush, ActionKind::push},
                                            {Command::toolGrip, ActionKind::grip},
                                            {Command::toolSwell, ActionKind::swell},
                                            {Command::toolHold, ActionKind::hold},
                                            {Command::toolStiffen, ActionKind::stiffen},
                                            {Command::toolSoften, ActionKind::soften}}};

struct NamedTurn {
  Command command;
  double yaw, pitch;
};
constexpr std::array<NamedTurn, 4> kTurns{{{Command::orbitLeft, -kStep, 0},
                                           {Command::orbitRight, kStep, 0},
                                           {Command::orbitUp, 0, kStep},
                                           {Command::orbitDown, 0, -kStep}}};

// The looks that one key goes through, as the cards show them.
void nextLook(Look& look) {
  struct Row {
    Mode mode;
    Matcap matcap;
  };
  constexpr std::array<Row, 7> rows{{{Mode::clay, Matcap::wax},
                                     {Mode::glaze, Matcap::wax},
                                     {Mode::plastic, Matcap::wax},
                                     {Mode::metal, Matcap::wax},
                                     {Mode::glass, Matcap::wax},
                                     {Mode::matcap, Matcap::wax},
                                     {Mode::matcap, Matcap::jade}}};
  std::size_t at = 0;
  for (std::size_t n = 0; n < rows.size(); ++n) {
    if (rows[n].mode != look.mode) continue;
    if (look.mode == Mode::matcap && rows[n].matcap != look.matcap) continue;
    at = n + 1;
  }
  look.mode = rows[at % rows.size()].mode;
  look.matcap = rows[at % rows.size()].matcap;
}

Axis axisOf(Command command) { return kAxes[std::size_t(command) - std::size_t(Command::mirrorX)]; }

Moves movesOf(Command command) { return Moves(int(command) - int(Command::moveScene)); }

bool isMirror(Command c) { return c >= Command::mirrorX && c <= Command::mirrorZ; }
bool isMoves(Command c) { return c >= Command::moveScene && c <= Command::moveLight; }

Dialog dialogOf(Command command) {
  switch (command) {
    case Command::open:
      return Dialog::open;
    case Command::saveAs:
      return Dialog::saveAs;
    case Command::importMesh:
      return Dialog::import;
    case Command::combineFile:
      return Dialog::combine;
    case Command::exportMesh:
      return Dialog::exportMesh;
    case Command::screenshot:
      return Dialog::picture;
    case Command::screenshotWindow:
      return Dialog::windowPicture;
    case Command::turntable:
      return Dialog::turntable;
    case Command::record:
      return Dialog::record;
    case Command::reference:
      return Dialog::reference;
    case Command::loadMatcap:
      return Dialog::matcap;
    case Command::replay:
      return Dialog::replay;
    case Command::showHelp:
      return Dialog::help;
    default:
      return Dialog::none;
  }
}

}  // namespace

bool Atelier::isChecked(Command command) const {
  for (const NamedTool& tool : kTools)
    if (tool.command == command) return sculpt.action == tool.action && !sculpt.recall;
  if (isMirror(command)) return sculpt.symmetry.mirror[std::size_t(index(axisOf(command)))];
  if (isMoves(command)) return mouseMoves == movesOf(command);
  switch (command) {
    case Command::stabiliser:
      return sculpt.steady;
    case Command::projection:
      return view.projection == Projection::orthographic;
    case Command::wireframe:
      return options.look.edges;
    case Command::workspaceBox:
      return options.box;
    case Command::history:
      return historyShown;
    case Command::panels:
      return panelsShown;
    case Command::shelf:
      return shelf.open;
    case Command::solidMode:
      return mode_ == WorkMode::solid;
    case Command::fullScreen:
      return fullScreen;
    default:
      return false;
  }
}

bool Atelier::isPossible(Command command) const {
  switch (command) {
    case Command::undo:
      return status_.done > 0 || status_.inStroke;
    case Command::redo:
      return status_.done < status_.history->line.size();
    case Command::wrap:
    case Command::solidFromClay:
      return !patches_.empty();
    case Command::wrapApply:
      return solidShown_ && solidShown_->solid->isWrap();
    case Command::bake:
      return solidShown_ && !solidShown_->solid->isWrap();
    case Command::solidRun:
    case Command::solidRest:
    case Command::solidDrop:
      return solidShown_ != nullptr;
    case Command::uniteTool:
    case Command::subtractTool:
    case Command::intersectTool:
      return sculpt.isFreeform();
    case Command::copyPart:
    case Command::cutPart:
      return part().has_value() && !patches_.empty();
    case Command::dropSupport:
      return chosenSupport && *chosenSupport < status_.clay.supports.size();
    case Command::dropSupports:
      return !status_.clay.supports.empty();
    case Command::relax:
    case Command::releaseHold:
    case Command::exportMesh:
    case Command::frameEdit:
    case Command::fitBox:
      return !patches_.empty();
    default:
      return true;
  }
}

void Atelier::run(Command command) {
  touch();
  if (const Dialog wanted = dialogOf(command); wanted != Dialog::none) {
    const bool leaves = wanted == Dialog::open || wanted == Dialog::import;
    if (leaves) return ifSaved([this, wanted] { dialog = wanted; });
    dialog = wanted;
    return;
  }
  for (const NamedView& named : kViews)
    if (named.command == command) return lookFrom(named.yaw, named.pitch);
  for (const NamedTool& tool : kTools)
    if (tool.command == command) return setTool(tool.action);
  for (const NamedTurn& turn : kTurns)
    if (turn.command == command) return turnBy(turn.yaw, turn.pitch);
  if (isMirror(command)) {
    bool& mirror = sculpt.symmetry.mirror[std::size_t(index(axisOf(command)))];
    mirror = !mirror;
    return;
  }
  if (isMoves(command)) {
    const bool leaves = command == Command::moveLight && mouseMoves == Moves::light;
    return takeHold(leaves ? Moves::scene : movesOf(command));
  }
  if (!runFile(command) && !runStroke(command) && !runClay(command) && !runSolid(command) &&
      !runParts(command)) {
    runView(command);
  }
}

// The tool is the puck's; the mouse keeps the scene then.
void Atelier::takeHold(Moves what) {
  mouseMoves = what == Moves::tool ? Moves::scene : what;
  puckMoves = what;
  if (what != Moves::tool) heldTool_.reset();
}

bool Atelier::runFile(Command command) {
  switch (command) {
    case Command::newBall:
      ifSaved([this] { startNew(NewClay::ball); });
      return true;
    case Command::newBlock:
      ifSaved([this] { startNew(NewClay::block); });
      return true;
    case Command::newEmpty:
      ifSaved([this] { startNew(NewClay::empty); });
      return true;
    case Command::save:
      if (path().empty()) {
        dialog = Dialog::saveAs;
      } else {
        saveScene(path());
      }
      return true;
    case Command::saveNumbered:
      if (path().empty()) {
        dialog = Dialog::saveAs;
      } else {
        saveNumbered();
      }
      return true;
    case Command::quit:
      askToClose();
      return true;
    case Command::undo:
      if (maker_) {
        cancelStroke();
      } else {
        apply(UndoOperation{});
      }
      return true;
    case Command::redo:
      apply(RedoOperation{});
      return true;
    default:
      return false;
  }
}

bool Atelier::runStroke(Command command) {
  const auto dragByKey = [&](Gesture gesture) {
    before_ = sculpt;
    gesture_ = gesture;
    gestureByKey_ = true;
    return true;
  };
  double& strength = sculpt.strengthOf(sculpt.action);
  switch (command) {
    case Command::dragSize:
      return dragByKey(Gesture::size);
    case Command::dragStrength:
      return dragByKey(Gesture::strength);
    case Command::dragRotation:
      return dragByKey(Gesture::rotation);
    case Command::larger:
      scaleSize(1 / 0.9);
      return true;
    case Command::smaller:
      scaleSize(0.9);
      return true;
    case Command::stronger:
      strength = std::min(strength + 0.05, 1.0);
      return true;
    case Command::weaker:
      strength = std::max(strength - 0.05, 0.01);
      return true;
    case Command::stabiliser:
      sculpt.steady = !sculpt.steady;
      return true;
    case Command::eyedropper:
      gesture_ = Gesture::pickColour;
      return true;
    case Command::swapColours:
      std::swap(sculpt.colour, sculpt.second);
      return true;
    case Command::toolBall:
      sculpt.drop();
      return true;
    case Command::palette:
      paletteOpen = !paletteOpen;
      palettePlace = pointer_ + corner_;
      return true;
    case Command::nextToolDisplay:
      showNextTool();
      return true;
    default:
      return false;
  }
}

bool Atelier::runClay(Command command) {
  switch (command) {
    case Command::relax:
      relax();
      return true;
    case Command::holdBox:
      holdBox();
      return true;
    case Command::releaseHold:
      apply(ReleaseOperation{true, false});
      return true;
    case Command::placeTable:
      placeTable();
      return true;
    case Command::placeTool:
      placeToolAsSupport(hover_.point());
      return true;
    case Command::dropSupport:
      dropSupport(*chosenSupport);
      return true;
    case Command::dropSupports:
      chosenSupport.reset();
      apply(ReleaseOperation{false, true});
      return true;
    default:
      return false;
  }
}

// Ring alone, then with the body see-through, solid, in wires, then nothing.
void Atelier::showNextTool() {
  ToolDisplay& tool = options.tool;
  if (!options.ring) {
    options.ring = true;
    tool = ToolDisplay::hidden;
  } else if (tool == ToolDisplay::wire) {
    options.ring = false;
    tool = ToolDisplay::hidden;
  } else if (tool == ToolDisplay::hidden) {
    tool = ToolDisplay::transparent;
  } else {
    tool = tool == ToolDisplay::transparent ? ToolDisplay::solid : ToolDisplay::wire;
  }
}

void Atelier::runView(Command command) {
  const ViewState before = view;
  switch (command) {
    case Command::undoView:
      return changeSight(&ViewHistory::undo);
    case Command::redoView:
      return changeSight(&ViewHistory::redo);
    case Command::frameAll:
      frameAll();
      break;
    case Command::frameEdit:
      frameEdit();
      break;
    case Command::projection:
      view.projection = view.projection == Projection::perspective ? Projection::orthographic
                                                                   : Projection::perspective;
      break;
    case Command::nextEnvironment:
      nextLook(options.look);
      return;
    case Command::wireframe:
      options.look.edges = !options.look.edges;
      return;
    case Command::workspaceBox:
      options.box = !options.box;
      return;
    case Command::fitBox:
      options.box = true;
      options.boxSize = WorkspaceBox{(patches_.bounds().low - kBoxRoom) * status_.scale.spacing,
                                     (patches_.bounds().high + kBoxRoom) * status_.scale.spacing};
      return;
    case Command::history:
      historyShown = !historyShown;
      return;
    case Command::panels:
      panelsShown = !panelsShown;
      return;
    case Command::shelf:
      shelf.open = !shelf.open;
      if (shelf.open) listShelf();
      return;
    case Command::fullScreen:
      fullScreen = !fullScreen;
      return;
    default:
      return;
  }
  movedView(before);
}

void Atelier::turnBy(double yaw, double pitch) {
  const ViewState before = view;
  view.worldFromView =
      glm::normalize(glm::angleAxis(yaw, glm::dvec3(0, 1, 0)) * view.worldFromView *
                     glm::angleAxis(-pitch, glm::dvec3(1, 0, 0)));
  movedView(before);
}

void Atelier::frameEdit() {
  CellBounds box = status_.lastEdit;
  if (box.empty()) return frameAll();
  box.low *= status_.scale.spacing;
  box.high *= status_.scale.spacing;
  frame(view, std::span(&box, 1), extent_.aspect(), 0.6);
}

}  // namespace bozzetto::ui
