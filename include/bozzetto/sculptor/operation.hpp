// Whatever a person can do is an operation: a small value that can be kept, replayed and told to
// others. Window, command line and tests all speak in these. World units throughout.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "bozzetto/history/step.hpp"
#include "bozzetto/sculptor/clay_operations.hpp"
#include "bozzetto/sculptor/solid_operations.hpp"
#include "bozzetto/sculptor/tool_operations.hpp"
#include "bozzetto/tool/action.hpp"
#include "bozzetto/tool/fill.hpp"
#include "bozzetto/tool/shape.hpp"
#include "bozzetto/tool/stroke.hpp"

namespace bozzetto {

/// Spacing and iso of an empty document. On one that has clay, other values are an error.
struct SceneOperation {
  std::optional<double> spacing;
  std::optional<double> iso;
};

/// Deposits a whole primitive.
struct FillOperation {
  Primitive primitive;
};

/// A mesh becomes clay, with a grid to its measure. Into an empty document only.
struct ImportOperation {
  std::string from;                 ///< relative to the recording's folder
  double cells = 128;               ///< along its longest side
  std::optional<double> spacing{};  ///< instead of that
  Colour colour;                    ///< where the mesh has none
};

/// The tool that strokes use from now on.
struct ToolOperation {
  ToolShape shape;
  std::optional<ToolSource> source{};  ///< of freeform tools
};

/// What strokes do from now on.
struct ActionOperation {
  ActionOptions action;
  /// Instead of the action's kind: bring back this state of the history, as far as the tool and
  /// the action's strength reach.
  std::optional<StepNumber> recall = std::nullopt;
};

struct StrokeOperation {
  Stroke stroke;
};

/// A count beyond the history takes back all there is.
struct UndoOperation {
  int count = 1;
};

struct RedoOperation {
  int count = 1;
};

/// To any state of the history, on whatever branch; 0 is the one before the first step.
struct GoToOperation {
  StepNumber step = 0;
};

/// The same clay on another grid.
struct ResampleOperation {
  double spacing = 1;
};

using Operation = std::variant<
    SceneOperation, FillOperation, ImportOperation, ToolOperation, ActionOperation, StrokeOperation,
    UndoOperation, RedoOperation, GoToOperation, ResampleOperation, SolidOperation,
    SolidMoveOperation, BakeOperation, WrapOperation, WrapApplyOperation, SolidDropOperation,
    ClayOperation, RelaxOperation, SupportOperation, HoldOperation, ReleaseOperation,
    SolidFromClayOperation, SolidCarveOperation, SolidExtrudeOperation, SolidJoinOperation,
    SolidSubdivideOperation, SolidSharpOperation, SolidPullOperation, SolidRunOperation,
    SolidSplineOperation, SolidPaintOperation, SolidInflateOperation, SolidTrimOperation,
    SolidWindowOperation, SolidRestOperation, SolidSettingsOperation, SolidProbeOperation,
    CombineOperation, CutOperation, TextOperation, ShelfKeepOperation, ShelfRenameOperation,
    ShelfDropOperation, SupportMoveOperation, SupportDropOperation>;

/// The "op" of an operation: "scene", "fill", …
std::string_view nameOf(const Operation& operation);

/// One operation from one line of JSON. `where` opens error texts ("file.jsonl:12"). Throws Error
/// for what does not parse, unknown operations, unknown keys, values of the wrong kind.
Operation parseOperation(std::string_view line, const std::string& where);

/// One line of JSON that parses to the same operation.
std::string toText(const Operation& operation);

}  // namespace bozzetto
