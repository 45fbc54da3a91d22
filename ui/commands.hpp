// All that a key, a menu or a button can ask for, in one table: name, what it does, default keys.
// Menus, tooltips, the help window and the key editor read the same rows.
#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "ui/keys.hpp"

namespace bozzetto::ui {

enum class Command {
  newBall,
  newBlock,
  newEmpty,
  open,
  save,
  saveAs,
  saveNumbered,
  importMesh,
  exportMesh,
  screenshot,
  screenshotWindow,
  turntable,
  reference,
  loadMatcap,
  record,
  replay,
  quit,
  undo,
  redo,
  undoView,
  redoView,
  toolAdd,
  toolRemove,
  toolErase,
  toolSmooth,
  toolPaint,
  toolPaintSoft,
  toolStamp,
  toolPush,
  toolGrip,
  toolSwell,
  toolHold,
  toolStiffen,
  toolSoften,
  uniteTool,
  subtractTool,
  intersectTool,
  combineFile,
  dragSize,
  dragStrength,
  dragRotation,
  larger,
  smaller,
  stronger,
  weaker,
  mirrorX,
  mirrorY,
  mirrorZ,
  stabiliser,
  eyedropper,
  swapColours,
  lasso,
  copyPart,
  cutPart,
  toolBall,
  palette,
  nextToolDisplay,
  moveScene,
  moveTool,
  moveLight,
  relax,
  holdBox,
  releaseHold,
  placeTable,
  placeTool,
  dropSupport,
  dropSupports,
  solidMode,
  solidMove,
  solidRope,
  solidSpline,
  solidCarve,
  solidExtrude,
  solidJoin,
  solidSubdivide,
  solidSharp,
  solidMass,
  solidStiffness,
  solidInflate,
  solidTrim,
  solidProbe,
  solidBlock,
  solidFromClay,
  wrap,
  wrapApply,
  bake,
  solidRun,
  solidRest,
  solidDrop,
  frameAll,
  frameEdit,
  front,
  back,
  right,
  left,
  top,
  bottom,
  orbitLeft,
  orbitRight,
  orbitUp,
  orbitDown,
  projection,
  nextEnvironment,
  wireframe,
  workspaceBox,
  fitBox,
  history,
  panels,
  shelf,
  fullScreen,
  showHelp,
  count
};

enum class CommandGroup { file, edit, tool, stroke, move, matter, solid, view, help };

struct CommandRow {
  Command command;
  CommandGroup group;
  std::string_view id;       ///< in the key file; never changes
  std::string_view title;    ///< in menus
  std::string_view tip;      ///< one sentence
  std::string_view blender;  ///< default keys, "Ctrl+Z", alternatives split by ", "
  std::string_view zbrush;
};

/// One row per command, in the enum's order.
std::span<const CommandRow> commandTable();
const CommandRow& rowOf(Command command);
std::string_view toText(CommandGroup group);

/// The chords of a text like "Ctrl+Shift+Z, Ctrl+Y".
std::vector<Chord> chordsOf(std::string_view text);

}  // namespace bozzetto::ui
