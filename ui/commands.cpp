#include "ui/commands.hpp"

#include <array>

namespace bozzetto::ui {
namespace {

using enum Command;
using enum CommandGroup;

constexpr auto kCommands = std::to_array<CommandRow>({
    {newBall, file, "new_ball", "New ball", "Starts again with a ball of clay.", "Ctrl+N",
     "Ctrl+N"},
    {newBlock, file, "new_block", "New block", "Starts again with a block of clay.", "", ""},
    {newEmpty, file, "new_empty", "New, empty", "Starts again with nothing but air.",
     "Ctrl+Shift+N", "Ctrl+Shift+N"},
    {Command::open, file, "open", "Open…", "Opens a scene.", "Ctrl+O", "Ctrl+O"},
    {save, file, "save", "Save", "Saves the scene.", "Ctrl+S", "Ctrl+S"},
    {saveAs, file, "save_as", "Save as…", "Saves the scene under another name.", "Ctrl+Shift+S",
     "Ctrl+Shift+S"},
    {saveNumbered, file, "save_numbered", "Save a numbered copy",
     "Puts the scene as it is aside: scene.001.bzt, scene.002.bzt and on.", "Ctrl+Alt+S",
     "Ctrl+Alt+S"},
    {importMesh, file, "import", "Import a mesh…",
     "A new scene: clay of a mesh (OBJ, PLY, STL, OFF, GLB).", "Ctrl+I", "Ctrl+I"},
    {exportMesh, file, "export", "Export a mesh…",
     "Writes the surface as OBJ, PLY, STL, GLB or IV.", "Ctrl+E", "Ctrl+E"},
    {screenshot, file, "screenshot", "Picture of the clay…",
     "Saves what the viewport shows, at rest and without panels, in any size.", "F12", "F12"},
    {screenshotWindow, file, "screenshot_window", "Picture of the window…",
     "Saves the whole window with its panels.", "Shift+F12", "Shift+F12"},
    {turntable, file, "turntable", "Turntable…", "Saves a row of pictures, once around the clay.",
     "Ctrl+F12", "Ctrl+F12"},
    {reference, file, "reference", "Reference picture…",
     "Puts a PNG behind the clay, facing you as you look now.", "", ""},
    {loadMatcap, file, "load_matcap", "Matcap from a picture…",
     "Shades the clay like the lit ball in a PNG.", "", ""},
    {record, file, "record", "Save recording…",
     "Saves every operation since this scene was opened, to be replayed.", "Ctrl+R", "Ctrl+R"},
    {Command::replay, file, "replay", "Replay a recording…", "Does what a recording says, here.",
     "Ctrl+Shift+R", "Ctrl+Shift+R"},
    {quit, file, "quit", "Quit", "Closes the window.", "Ctrl+Q", "Ctrl+Q"},

    {undo, edit, "undo", "Undo", "Takes the last stroke back.", "Ctrl+Z", "Ctrl+Z"},
    {redo, edit, "redo", "Redo", "Does it again.", "Ctrl+Shift+Z, Ctrl+Y", "Ctrl+Shift+Z, Ctrl+Y"},
    {undoView, edit, "undo_view", "Last view", "Looks from where you looked before.", "Alt+Z",
     "Ctrl+Alt+Z"},
    {redoView, edit, "redo_view", "Next view", "Goes forward among views.", "Alt+Y", "Ctrl+Alt+Y"},

    {toolAdd, tool, "tool_add", "Add clay", "Piles clay up, on the surface or in the air.", "1, V",
     "1"},
    {toolRemove, tool, "tool_remove", "Carve", "Takes clay away, little by little.", "2, C", "2"},
    {toolErase, tool, "tool_erase", "Erase", "Cuts away all that the tool covers.", "3", "3"},
    {toolSmooth, tool, "tool_smooth", "Smooth", "Evens out bumps.", "4, S", "4"},
    {toolPaint, tool, "tool_paint", "Paint", "Colours the clay that the tool covers.", "5, P", "5"},
    {toolPaintSoft, tool, "tool_paint_soft", "Soft paint", "Colours gently, most at the centre.",
     "6, Shift+P", "6"},
    {toolStamp, tool, "tool_stamp", "Stamp", "Prints the tool; clay rises round it.", "D", "D"},
    {toolPush, tool, "tool_push", "Push", "Presses clay in; what gives way piles up around.",
     "7, G", "7"},
    {toolGrip, tool, "tool_grip", "Grip", "Takes hold of clay and drags it along.", "8, K", "8"},
    {toolSwell, tool, "tool_swell", "Swell", "Lets clay swell out.", "9, I", "9"},
    {toolHold, tool, "tool_hold", "Hold",
     "Keeps clay as it is, whatever other tools do; the opposite lets go.", "0, M", "0"},
    {toolStiffen, tool, "tool_stiffen", "Stiffen",
     "Paints clay that keeps its form when it is pushed and gripped.", "J", "J"},
    {toolSoften, tool, "tool_soften", "Soften", "Paints clay that gives way sooner than the rest.",
     "Shift+J", "Shift+J"},

    {uniteTool, tool, "unite_tool", "Unite the tool",
     "The tool from the shelf becomes clay where it stands, with its colours.", "Ctrl+1", "Ctrl+1"},
    {subtractTool, tool, "subtract_tool", "Subtract the tool",
     "Takes the tool's form away from the clay.", "Ctrl+2", "Ctrl+2"},
    {intersectTool, tool, "intersect_tool", "Intersect with the tool",
     "Leaves only what is inside the tool.", "Ctrl+3", "Ctrl+3"},
    {combineFile, tool, "combine_file", "Combine with a file…",
     "Unites the clay with another scene, a tool or a mesh, takes its form away, or leaves only "
     "what is inside it.",
     "Ctrl+4", "Ctrl+4"},

    {dragSize, stroke, "drag_size", "Size", "Move the pointer to change the tool's size.", "F",
     "S"},
    {dragStrength, stroke, "drag_strength", "Strength",
     "Move the pointer to change the tool's strength.", "Shift+F", "U"},
    {dragRotation, stroke, "drag_rotation", "Rotation", "Move the pointer to turn the tool.",
     "Ctrl+F", "R"},
    {larger, stroke, "larger", "Larger", "A step larger.", "]", "]"},
    {smaller, stroke, "smaller", "Smaller", "A step smaller.", "[", "["},
    {stronger, stroke, "stronger", "Stronger", "A step stronger.", "Shift+]", "Shift+]"},
    {weaker, stroke, "weaker", "Weaker", "A step weaker.", "Shift+[", "Shift+["},
    {mirrorX, stroke, "mirror_x", "Mirror left and right", "Every stroke also on the other side.",
     "X", "X"},
    {mirrorY, stroke, "mirror_y", "Mirror up and down", "Every stroke also upside down.", "", ""},
    {mirrorZ, stroke, "mirror_z", "Mirror front and back", "Every stroke also behind.", "", ""},
    {stabiliser, stroke, "stabiliser", "Steady hand", "The tool follows the pointer on a rope.",
     "Shift+S", "L"},
    {eyedropper, stroke, "eyedropper", "Pick colour", "Takes the colour under the pointer.", "E",
     "C"},
    {swapColours, stroke, "swap_colours", "Swap colours", "Takes the second colour in hand.",
     "Shift+X", "V"},
    {Command::lasso, stroke, "lasso", "Lasso", "Draw round a part of the clay, to copy or cut it.",
     "Ctrl+L", "Ctrl+L"},
    {copyPart, stroke, "copy_part", "Copy the part",
     "What is in the lasso, or in the workspace box, becomes the tool in hand.", "Ctrl+C",
     "Ctrl+C"},
    {cutPart, stroke, "cut_part", "Cut the part",
     "Takes what is in the lasso, or in the workspace box, out of the clay and into the hand.",
     "Ctrl+X", "Ctrl+X"},
    {toolBall, stroke, "tool_ball", "Back to a ball", "Lets go of a tool from the shelf.",
     "Shift+Q", "Shift+Q"},
    {palette, stroke, "palette", "Palette", "Tools, sizes and colours under the pointer.", "Space",
     "Space"},
    {nextToolDisplay, stroke, "tool_display", "Show the tool",
     "The tool as a ring, see-through, solid, in wires, or not at all.", "T", "T"},

    {moveScene, move, "move_scene", "Move the scene", "Mouse and puck turn the scene.", "F2", "F2"},
    {moveTool, move, "move_tool", "Move the tool",
     "The puck holds the tool; the mouse turns the scene.", "F3", "F3"},
    {moveLight, move, "move_light", "Move the light", "Dragging turns the light.", "F4", "F4"},

    {relax, matter, "relax", "Relax", "Lets clay settle: its layers run without a tool.", "R",
     "Shift+R"},
    {holdBox, matter, "hold_box", "Hold the box", "Holds all clay in the workspace box.", "Shift+M",
     "Shift+M"},
    {releaseHold, matter, "release", "Let all go",
     "Nothing is held any more, nor painted stiff or soft.", "Alt+M", "Alt+M"},
    {placeTable, matter, "place_table", "A table", "A board under the clay, as wide as it.", "",
     ""},
    {placeTool, matter, "place_tool", "The tool as a support",
     "Leaves a support like the tool under the pointer; clay cannot go there.", "Y", "Y"},
    {dropSupport, matter, "drop_support", "Take the support away", "The one that is chosen.",
     "Delete", "Delete"},
    {dropSupports, matter, "drop_supports", "No supports", "Takes all supports away.", "", ""},

    {solidMode, solid, "solid_mode", "Solid mode", "Tools for deformable solids and wraps.", "L",
     "Shift+L"},
    {solidMove, solid, "solid_move", "Move a point", "Drags a control point of the lattice.",
     "Alt+1", "Alt+1"},
    {solidRope, solid, "solid_rope", "Rope", "Pulls the solid by a spring; it gives way.", "Alt+2",
     "Alt+2"},
    {solidSpline, solid, "solid_spline", "Curve",
     "Click points of the surface, then drag the controls of the curve through them.", "Alt+C",
     "Alt+C"},
    {solidCarve, solid, "solid_carve", "Carve a cell",
     "Removes the control cell under the pointer.", "Alt+3", "Alt+3"},
    {solidExtrude, solid, "solid_extrude", "Extrude",
     "A cell grows from the face under the pointer.", "Alt+4", "Alt+4"},
    {solidJoin, solid, "solid_join", "Join", "Click one face, then another: a cell joins them.",
     "Alt+5", "Alt+5"},
    {solidSubdivide, solid, "solid_subdivide", "Subdivide", "Splits the cell under the pointer.",
     "Alt+6", "Alt+6"},
    {solidSharp, solid, "solid_sharp", "Sharp", "Tags a point, edge or face as sharp; Ctrl: not.",
     "Alt+7", "Alt+7"},
    {solidMass, solid, "solid_mass", "Mass", "A brush for mass; Ctrl: lighter.", "Alt+8", "Alt+8"},
    {solidStiffness, solid, "solid_stiffness", "Stiffness", "A brush for stiffness; Ctrl: softer.",
     "Alt+9", "Alt+9"},
    {solidInflate, solid, "solid_inflate", "Inflate", "Swells the solid; Ctrl: deflates it.",
     "Alt+0", "Alt+0"},
    {solidTrim, solid, "solid_trim", "Trim", "Cells under the brush take no part; Ctrl: again.",
     "Alt+T", "Alt+T"},
    {solidProbe, solid, "solid_probe", "Probe",
     "Touches the surface: tells the stiffness there, shows how it pushes back.", "Alt+P", "Alt+P"},
    {solidBlock, solid, "solid_block", "New block",
     "A block of control cells in the view's middle.", "", ""},
    {solidFromClay, solid, "solid_from_clay", "Solid from the clay",
     "Coarse cells where the clay is.", "", ""},
    {wrap, solid, "wrap", "Wrap the clay",
     "A lattice round the clay, or round what is in the workspace box.", "", ""},
    {wrapApply, solid, "wrap_apply", "Apply the wrap", "The clay goes along with the lattice.", "",
     ""},
    {bake, solid, "bake", "Bake into clay", "The solid becomes clay, in the colour in hand.", "",
     ""},
    {solidRun, solid, "solid_run", "Let it move", "Some steps of physics.", "", ""},
    {solidRest, solid, "solid_rest", "Take as rest", "The present shape is the rest shape.", "",
     ""},
    {solidDrop, solid, "solid_drop", "Let the solid go", "The solid or wrap goes; the clay stays.",
     "", ""},

    {frameAll, view, "frame_all", "Show all clay", "Brings all clay into sight.", "Home", "F"},
    {frameEdit, view, "frame_edit", "Show the last stroke", "Brings the last stroke into sight.",
     "Num .", "Num ."},
    {front, view, "front", "From the front", "Looks along −Z.", "Num 1", "Num 1"},
    {back, view, "back", "From behind", "Looks along +Z.", "Ctrl+Num 1", "Ctrl+Num 1"},
    {right, view, "right", "From the right", "Looks along −X.", "Num 3", "Num 3"},
    {left, view, "left", "From the left", "Looks along +X.", "Ctrl+Num 3", "Ctrl+Num 3"},
    {top, view, "top", "From above", "Looks down.", "Num 7", "Num 7"},
    {bottom, view, "bottom", "From below", "Looks up.", "Ctrl+Num 7", "Ctrl+Num 7"},
    {orbitLeft, view, "orbit_left", "Turn left", "Turns the view by 15°.", "Num 4", "Num 4"},
    {orbitRight, view, "orbit_right", "Turn right", "Turns the view by 15°.", "Num 6", "Num 6"},
    {orbitUp, view, "orbit_up", "Turn up", "Turns the view by 15°.", "Num 8", "Num 8"},
    {orbitDown, view, "orbit_down", "Turn down", "Turns the view by 15°.", "Num 2", "Num 2"},
    {projection, view, "projection", "Parallel lines",
     "Switches between perspective and parallel projection.", "Num 5", "Num 5"},
    {nextEnvironment, view, "next_look", "Next look",
     "Without surroundings, chrome, plastic, glaze: the modes of environment mapping.", "N", "N"},
    {wireframe, view, "wireframe", "Wireframe", "Shows the triangles.", "W", "Shift+F"},
    {workspaceBox, view, "box", "Workspace box", "A box around the clay.", "B", "B"},
    {fitBox, view, "fit_box", "Fit the box", "Puts the box around the clay.", "Shift+B", "Shift+B"},
    {Command::history, view, "history", "History",
     "All steps with their branches: go to one, compare, bring a part back.", "Shift+Tab",
     "Shift+Tab"},
    {panels, view, "panels", "Panels", "Hides and shows the panels.", "Tab", "Tab"},
    {shelf, view, "shelf", "Shelf", "Tools that are sculptures: take them, keep them.", "Q", "Q"},
    {fullScreen, view, "full_screen", "Full screen", "The clay and nothing else.", "F11", "F11"},

    {Command::showHelp, CommandGroup::help, "help", "Keys and help",
     "All keys, and how to change them.", "F1", "F1"},
});
static_assert(kCommands.size() == static_cast<std::size_t>(Command::count));

}  // namespace

std::span<const CommandRow> commandTable() { return kCommands; }

const CommandRow& rowOf(Command command) { return kCommands[static_cast<std::size_t>(command)]; }

std::string_view toText(CommandGroup group) {
  constexpr auto names = std::to_array<std::string_view>(
      {"File", "Edit", "Tools", "Stroke", "Move", "Clay", "Solid", "View", "Help"});
  return names[static_cast<std::size_t>(group)];
}

std::vector<Chord> chordsOf(std::string_view text) {
  std::vector<Chord> chords;
  while (!text.empty()) {
    const std::size_t comma = text.find(", ");
    if (const auto chord = chordNamed(text.substr(0, comma))) chords.push_back(*chord);
    text = comma == std::string_view::npos ? "" : text.substr(comma + 2);
  }
  return chords;
}

}  // namespace bozzetto::ui
