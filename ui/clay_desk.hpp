// Where the clay is worked on, off the window's thread: the sculptor, its file, and what the window
// is to be shown. Not thread-safe: ClayWorker calls it from its one thread; tests call it directly.
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bozzetto/io/voxelise.hpp"
#include "bozzetto/render/dresser.hpp"
#include "bozzetto/render/structure.hpp"
#include "bozzetto/scene/scene_file.hpp"
#include "bozzetto/sculptor/recording.hpp"
#include "bozzetto/sculptor/sculptor.hpp"
#include "ui/freeform.hpp"
#include "ui/patch_set.hpp"
#include "ui/solid_shown.hpp"

namespace bozzetto::ui {

/// One line of the history list.
struct StepLine {
  std::string label;
  std::optional<ActionKind> action;  ///< of a stroke
  std::uint64_t id = 0;              ///< never used twice
};

/// What the window knows of the clay: small values, copied with every publication.
struct ClayStatus {
  FieldScale scale;
  CellBounds bounds;  ///< of the surface, cells
  Stage stage;
  double mass = 0;
  std::vector<StepLine> steps;
  std::size_t done = 0;       ///< of the steps; the rest can be redone
  std::uint64_t version = 0;  ///< grows with every change of the clay
  std::uint64_t savedVersion = 0;
  OperationReport last;            ///< of the last operation
  clay::Setup clay;                ///< what strokes that move clay meet
  std::size_t movedSteps = 0;      ///< strokes that moved clay, and relaxations, since opened
  double drift = 0;                ///< of the mass, over these
  CellBounds lastEdit;             ///< cells
  std::uint64_t lastEditStep = 0;  ///< the step that it belongs to
  bool isLit = false;              ///< nothing waits for better light
  std::size_t operations = 0;      ///< recorded since the scene was opened
  bool inStroke = false;
};

/// Counted when the clay has come to rest.
struct ClayStatistics {
  FieldStatistics field;
  std::int64_t cubes = 0, crossingCubes = 0, edges = 0, triangles = 0, components = 0;
  double volume = 0, area = 0;  ///< world units
};

/// How the solid is to be shown.
struct SolidWish {
  SolidMap map = SolidMap::none;
  Colour colour;
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
  std::optional<FloorOcclusion> floor;
  std::optional<ClayStatus> status;
  std::optional<ClayStatistics> statistics;
  std::optional<SceneParts> opened;  ///< another document is on the desk
  std::optional<std::vector<ShelfCard>> shelf;
  std::optional<std::shared_ptr<const SolidShown>> solid;  ///< null: there is none
  std::optional<Freeform> taken;                           ///< from a shelf
  std::vector<std::string> notes, errors;

  bool empty() const;
  /// Puts a later one on top.
  void add(Publication later);
  std::size_t uploadBytes() const;
};

enum class NewClay { empty, ball, block };

enum class ShelfPictures { none, made };

class ClayDesk {
 public:
  ClayDesk();

  // Documents. Each throws Error and leaves the desk as it was.
  void startNew(NewClay kind);
  void open(const std::filesystem::path& path, Progress& progress);
  void import(const std::filesystem::path& path, const ImportOptions& options, Progress& progress);
  void save(const std::filesystem::path& path, const SceneParts& parts, Progress& progress);
  /// A copy beside `path`; we go on with the file we have.
  void saveNumbered(const std::filesystem::path& path, const SceneParts& parts, Progress& progress);
  void exportMesh(const std::filesystem::path& path, double keep, Progress& progress);

  // Operations.
  void apply(const Operation& operation, Progress& progress = Progress::none());
  void beginStroke(const HandOperations& hand, Stroke stroke);
  void extendStroke(std::span<const StrokePoint> points);
  /// The next dab whose place is sure; false when there is none.
  bool dab();
  void endStroke();
  void cancelStroke();

  /// With these settings from now on.
  void relax(const ClayOperation& settings, int steps, Progress& progress);
  /// A row of moves of one support is recorded as one.
  void moveSupport(const SupportMoveOperation& move);

  // Solids (clay_desk_solid.cpp).
  void showSolid(const SolidWish& wish);
  /// Shows what a move or a pull would do.
  void previewSolid(const Operation& drag);

  // Shelves (clay_desk_shelf.cpp).
  /// Lists all tools with the next publication; their pictures follow at rest.
  void listShelf();
  /// Whether anybody looks at them.
  void setPictures(ShelfPictures pictures) { pictures_ = pictures; }
  void takeTool(const ToolSource& source);
  /// A tool of any place as one file.
  void shareTool(const std::string& name, const std::filesystem::path& path);
  /// In the user's library.
  void keepForUser(const std::string& name);
  void dropUserTool(const std::string& name);
  void renameUserTool(const std::string& name, const std::string& to);

  // Recordings.
  void saveRecording(const std::filesystem::path& path) const;
  void replay(const std::filesystem::path& path, Progress& progress);

  /// Shows the surface, or the cubes it is made of.
  void setStructure(Structure structure);

  /// A piece of the work that waits until nothing else is to do (better light, statistics); false
  /// when all is done.
  bool settle();

  /// What changed since the last call.
  Publication take();

  const Sculptor& sculptor() const { return *sculptor_; }
  const Recording& recording() const { return recording_; }
  void note(std::string text) { out_.notes.push_back(std::move(text)); }
  void fail(std::string text) { out_.errors.push_back(std::move(text)); }

 private:
  class Telling;
  Document documentWith(const SceneParts& parts) const;
  void lay(Document document);
  void show();
  void showAll();
  void put(std::vector<UnpackedPatch> patches);
  void hold(const HandOperations& hand);
  void account();
  void holdOne(const Operation& wanted, std::string& held);
  void tellSolid(const SolidRef& solid);
  void picture(ShelfCard& card);
  bool pictureNext();
  void tellStatus();
  void nameSteps(StepLine title);
  ClayStatistics count() const;

  std::unique_ptr<Sculptor> sculptor_;
  std::unique_ptr<LiveStroke<8>> stroke_;
  std::unique_ptr<Dresser> dresser_;
  SceneParts parts_;
  SceneFile file_;
  Recording recording_;
  ClayStatus status_;
  std::vector<StepLine> titles_;  // of the history's steps
  std::uint64_t lastStep_ = 0;
  std::string heldTool_, heldAction_, heldClay_;  // operations last told; empty: not known
  std::vector<ShelfCard> cards_;
  SolidWish solidWish_;
  SolidRef solidTold_;  // what the window shows
  double solidSpacing_ = 0;
  ShelfPictures pictures_ = ShelfPictures::none;
  std::map<std::string, std::shared_ptr<const Bytes>> starterPictures_;
  Publication out_;
  CellBounds bounds_;  // of all patches
  Structure structure_ = Structure::surface;
  enum class Rest { light, floor, statistics, pictures, nothing } rest_ = Rest::nothing;
};

}  // namespace bozzetto::ui
