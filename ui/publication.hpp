// What the clay's thread tells the window's: values, handed over finished.
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bozzetto/field/difference.hpp"
#include "bozzetto/history/copy.hpp"
#include "bozzetto/render/dresser.hpp"
#include "bozzetto/sculptor/session.hpp"
#include "ui/freeform.hpp"
#include "ui/patch_set.hpp"
#include "ui/solid_shown.hpp"

namespace bozzetto::ui {

/// A step of the history as panels show it.
struct StepLine {
  StepNumber number = 0, parent = 0;
  std::string title;
  std::optional<ActionKind> action;  ///< of a stroke
  std::int64_t time = 0;             ///< milliseconds since 1970, UTC
  std::uint64_t corners = 0;         ///< changed; 0 until it is written
};

/// The tree of steps, and where we are in it.
struct HistoryView {
  std::vector<StepLine> steps;  ///< in the order in which they were made
  StepNumber root = 0, place = 0;
  std::optional<StepNumber> saved;  ///< the state that the file has
  std::vector<StepNumber> line;     ///< what was done, and then what redo would do
  std::size_t done = 0;             ///< of the line

  /// Null for the root.
  const StepLine* find(StepNumber number) const;
};

/// How the document stands on the disk.
struct Keeping {
  std::filesystem::path path;    ///< empty: no name yet
  bool modified = false;         ///< there is something that the file does not hold
  bool readOnly = false;         ///< somebody else has it, or nothing can be written there
  bool kept = true;              ///< every step is on the disk, synced
  std::string trouble;           ///< why steps are not
  std::optional<double> saving;  ///< 0…1 while a save is on its way
  friend bool operator==(const Keeping&, const Keeping&) = default;
};

/// Of a picture of a step, pixels.
constexpr glm::ivec2 kStepPicture{116, 92};

/// What the window knows of the clay: small values, copied with every publication.
struct ClayStatus {
  FieldScale scale;
  CellBounds bounds;  ///< of the surface, cells
  Stage stage;
  double mass = 0;
  std::shared_ptr<const HistoryView> history = std::make_shared<const HistoryView>();
  std::size_t done = 0;         ///< steps that undo would take back
  std::uint64_t version = 0;    ///< grows with every change of the clay
  OperationReport last;         ///< of the last operation
  CellBounds lastEdit;          ///< cells
  StepNumber lastEditStep = 0;  ///< the step that it belongs to
  bool isLit = false;           ///< nothing waits for better light
  std::size_t operations = 0;   ///< recorded since the scene was opened
  bool inStroke = false;
  std::optional<StepNumber> peek;  ///< a state that is only looked at
  clay::Setup clay;                ///< what strokes that move clay meet
  /// Of the supports, in their order; null for those that are no sculptures.
  std::vector<std::shared_ptr<const ToolMesh>> supportMeshes;
  MassLedger ledger;
  Keeping keeping;
};

/// Counted when the clay has come to rest.
struct ClayStatistics {
  FieldStatistics field;
  std::int64_t cubes = 0, crossingCubes = 0, edges = 0, triangles = 0, components = 0;
  double volume = 0, area = 0;  ///< world units
};

/// Another document is on the desk.
struct OpenedDocument {
  SceneParts parts;
  SessionFindings findings;
  /// Work came back that nobody has asked for by name.
  bool surprising = false;
  bool canGoBack = false;  ///< to what the file holds
};

/// Work without a name that a program left when it ended.
struct LeftDocument {
  std::filesystem::path path;
  HistoryGlance glance;
};

struct SavedFile {
  std::filesystem::path path;
  bool succeeded = false;
};

/// How another state differs from the clay now.
struct Comparison {
  StepNumber step = 0;
  FieldDifference found;  ///< from that state to now
  FieldScale then, now;
  double volumeThen = 0, volumeNow = 0;  ///< world units
};

enum class WrapShown { asClayIs, asPosed };
/// How the solid is to be shown.
struct SolidWish {
  SolidMap map = SolidMap::none;
  Colour colour;
  WrapShown wrap = WrapShown::asClayIs;  ///< the clay in a wrap, as it would be carried
};

/// What strokes take.
struct HandOperations {
  ToolOperation tool;
  ActionOperation action;
  ClayOperation clay;  ///< for actions that move clay
};

/// What changed since the last publication.
struct Publication {
  bool cleared = false;                  ///< forget all patches first
  std::map<Key, PatchRef> fine, coarse;  ///< by first corner; null: gone
  std::map<Key, PatchRef> heights;       ///< cloths that are shown instead of both
  /// All cloths there were are to go: for those above, or once all other patches are uploaded.
  bool undraped = false;
  std::optional<FloorOcclusion> floor;
  std::optional<ClayStatus> status;
  std::optional<ClayStatistics> statistics;
  std::optional<OpenedDocument> opened;
  std::map<StepNumber, Bytes> pictures;  ///< PNG, of the document on the desk
  std::optional<std::vector<LeftDocument>> left;
  std::optional<SavedFile> saved;
  std::optional<Comparison> comparison;
  std::optional<std::vector<ShelfCard>> shelf;
  std::optional<std::shared_ptr<const SolidShown>> solid;  ///< null: there is none
  std::optional<double> touched;                           ///< stiffness where the probe is
  std::optional<Freeform> taken;                           ///< from a shelf
  std::vector<std::string> notes, errors;

  bool empty() const;
  /// Puts a later one on top.
  void add(Publication later);
  std::size_t uploadBytes() const;
};

/// The history as it stands.
HistoryView viewOf(const History<8>& history);

}  // namespace bozzetto::ui
