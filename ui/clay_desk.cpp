#include "ui/clay_desk.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bozzetto/base/file.hpp"
#include "bozzetto/io/mesh_file.hpp"
#include "bozzetto/mesh/decimate.hpp"
#include "bozzetto/solid/solid_codec.hpp"
#include "bozzetto/surface/statistics.hpp"
#include "bozzetto/surface/welded.hpp"
#include "ui/sculpt_state.hpp"

namespace bozzetto::ui {
namespace {

constexpr double kNewRadius = 48;  // world units = cells of a new scene

template <class T>
void replaceIf(std::optional<T>& old, std::optional<T>& later) {
  if (later) old = std::move(later);
}

std::size_t bytesOf(const std::map<Key, PatchRef>& patches) {
  std::size_t bytes = 0;
  for (const auto& [key, patch] : patches) bytes += patch ? patch->uploadBytes() : 0;
  return bytes;
}

// Empty for operations that are no step of history.
std::string titleOf(const Operation& operation) {
  std::string name(nameOf(operation));
  for (const char* none :
       {"undo", "redo", "scene", "tool", "action", "clay", "support", "support_move",
        "support_drop", "solid_probe", "shelf_keep", "shelf_rename", "shelf_drop"})
    if (name == none) return "";
  std::ranges::replace(name, '_', ' ');
  name[0] = char(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

}  // namespace

// Notices become notes in the window.
class ClayDesk::Telling : public Progress {
 public:
  Telling(Progress& outer, ClayDesk& desk) : outer_(&outer), desk_(&desk) {}
  bool report(std::string_view what, double done) override { return outer_->report(what, done); }
  void note(std::string_view text) override { desk_->note(std::string(text)); }

 private:
  Progress* outer_;
  ClayDesk* desk_;
};

bool Publication::empty() const {
  return !cleared && fine.empty() && coarse.empty() && !floor && !status && !statistics &&
         !opened && !shelf && !taken && !solid && notes.empty() && errors.empty();
}

void Publication::add(Publication later) {
  if (later.cleared) {
    cleared = true;
    fine.clear();
    coarse.clear();
  }
  for (auto& [key, patch] : later.fine) fine[key] = std::move(patch);
  for (auto& [key, patch] : later.coarse) coarse[key] = std::move(patch);
  replaceIf(floor, later.floor);
  replaceIf(status, later.status);
  replaceIf(statistics, later.statistics);
  replaceIf(opened, later.opened);
  replaceIf(shelf, later.shelf);
  replaceIf(taken, later.taken);
  replaceIf(solid, later.solid);
  for (std::string& text : later.notes) notes.push_back(std::move(text));
  for (std::string& text : later.errors) errors.push_back(std::move(text));
}

std::size_t Publication::uploadBytes() const { return bytesOf(fine) + bytesOf(coarse); }

ClayDesk::ClayDesk() { lay({}); }

// Puts another document on the desk.
void ClayDesk::lay(Document document) {
  stroke_.reset();
  sculptor_ = std::make_unique<Sculptor>(std::move(document.field), SurfaceUpkeep::afterEachDab);
  sculptor_->tools().shelf = document.parts.shelf;
  sculptor_->place(document.parts.supports);
  sculptor_->place(decodeSolid(document.parts.solid, "the scene"));
  dresser_ = std::make_unique<Dresser>();
  parts_ = std::move(document.parts);
  recording_ = {};
  heldTool_ = heldAction_ = heldClay_ = "";
  titles_.clear();
  const std::uint64_t version = status_.version + 1;
  status_ = {};
  status_.version = status_.savedVersion = version;
  out_.opened = parts_;
  showAll();
}

void ClayDesk::startNew(NewClay kind) {
  file_ = SceneFile();
  lay({});
  Primitive primitive;
  primitive.radii = glm::dvec3(kNewRadius);
  if (kind == NewClay::block) {
    primitive.shape = Shape::box;
    primitive.radii *= 0.8;
  }
  if (kind != NewClay::empty) apply(FillOperation{primitive});
  status_.savedVersion = status_.version;
  tellStatus();
}

void ClayDesk::open(const std::filesystem::path& path, Progress& progress) {
  lay(file_.load(path, progress));
}

void ClayDesk::import(const std::filesystem::path& path, const ImportOptions& options,
                      Progress& progress) {
  const TriangleMesh mesh = readMesh(path, progress);
  Document document;
  document.field.scale.spacing = importSpacing(mesh, options);
  Edit<CornerBlock<8>> edit(document.field.tree);
  const ImportReport report = voxelise(mesh, options, edit, progress);
  edit.commit();
  file_ = SceneFile();
  lay(std::move(document));
  status_.savedVersion = 0;
  tellStatus();
  if (report.openEdges > 0) note(fmt::format("{} open edges were closed", report.openEdges));
}

Document ClayDesk::documentWith(const SceneParts& parts) const {
  Document document{sculptor_->field(), parts};
  document.parts.identity = parts_.identity;
  document.parts.shelf = sculptor_->tools().shelf;
  document.parts.supports = sculptor_->clay().supports;
  document.parts.solid = encodeSolid(sculptor_->solid());
  return document;
}

void ClayDesk::saveNumbered(const std::filesystem::path& path, const SceneParts& parts,
                            Progress& progress) {
  Document copy = documentWith(parts);
  copy.parts.identity = SceneIdentity::random();
  note("Saved " + saveNumberedCopy(path, copy, progress).filename().string());
}

void ClayDesk::save(const std::filesystem::path& path, const SceneParts& parts,
                    Progress& progress) {
  Document document = documentWith(parts);
  file_.save(path, document, progress);
  parts_ = std::move(document.parts);
  status_.savedVersion = status_.version;
  tellStatus();
}

void ClayDesk::exportMesh(const std::filesystem::path& path, double keep, Progress& progress) {
  meshFormatOf(path);
  const TriangleMesh mesh = weld(sculptor_->surface(), sculptor_->field().scale);
  writeMesh(path, keep < 1 ? decimate(mesh, keep) : mesh, progress);
}

void ClayDesk::apply(const Operation& operation, Progress& progress) {
  cancelStroke();
  heldTool_ = heldAction_ = heldClay_ = "";  // some operations change the hand
  Telling telling(progress, *this);
  status_.last = sculptor_->apply(operation, telling);
  recording_.operations.push_back(operation);
  ++status_.version;
  nameSteps({titleOf(operation), std::nullopt, 0});
  show();
}

void ClayDesk::relax(const ClayOperation& settings, int steps, Progress& progress) {
  cancelStroke();
  holdOne(settings, heldClay_);
  apply(RelaxOperation{steps}, progress);
  account();
}

void ClayDesk::moveSupport(const SupportMoveOperation& move) {
  sculptor_->apply(move);
  auto& operations = recording_.operations;
  const auto* before =
      operations.empty() ? nullptr : std::get_if<SupportMoveOperation>(&operations.back());
  if (before != nullptr && before->number == move.number) operations.pop_back();
  operations.push_back(move);
  tellStatus();
}

// The ledger of what should keep the mass.
void ClayDesk::account() {
  ++status_.movedSteps;
  status_.drift += status_.last.massAfter - status_.last.massBefore;
}

// A step that was just made takes the place of those that had been undone.
void ClayDesk::nameSteps(StepLine title) {
  const auto& history = sculptor_->history();
  const std::size_t done = history.undoDepth(), count = done + history.redoDepth();
  if (history.redoDepth() == 0 && done > 0 && !title.label.empty()) {
    title.id = ++lastStep_;
    titles_.resize(done - 1);
    titles_.push_back(std::move(title));
  }
  titles_.resize(count);
}

// Strokes take what the hand holds; it is told only when it changes.
void ClayDesk::holdOne(const Operation& wanted, std::string& held) {
  std::string text = toText(wanted);
  if (text == held) return;
  sculptor_->apply(wanted);
  recording_.operations.push_back(wanted);
  held = std::move(text);
}

void ClayDesk::hold(const HandOperations& hand) {
  holdOne(hand.tool, heldTool_);
  holdOne(hand.action, heldAction_);
  if (movesClay(hand.action.action.kind)) holdOne(hand.clay, heldClay_);
}

void ClayDesk::beginStroke(const HandOperations& hand, Stroke stroke) {
  cancelStroke();
  hold(hand);
  stroke_ = sculptor_->begin(std::move(stroke));
  status_.inStroke = true;
  status_.lastEdit = {};
  status_.lastEditStep = 0;
  tellStatus();
}

void ClayDesk::extendStroke(std::span<const StrokePoint> points) {
  if (stroke_) stroke_->extend(points);
}

bool ClayDesk::dab() {
  if (!stroke_ || !stroke_->dab()) return false;
  show();
  return true;
}

void ClayDesk::endStroke() {
  if (!stroke_) return;
  status_.last = stroke_->finish();
  recording_.operations.push_back(StrokeOperation{stroke_->stroke()});
  stroke_.reset();
  status_.inStroke = false;
  ++status_.version;
  const ActionKind action = sculptor_->action().kind;
  if (movesClay(action)) account();
  nameSteps({std::string(rowOf(action).title), action, 0});
  status_.lastEditStep = lastStep_;
  show();
}

void ClayDesk::cancelStroke() {
  if (!stroke_) return;
  stroke_.reset();
  status_.inStroke = false;
  show();
}

void ClayDesk::saveRecording(const std::filesystem::path& path) const {
  const std::string text = toText(recording_);
  writeFile(path, std::as_bytes(std::span(text)));
}

void ClayDesk::replay(const std::filesystem::path& path, Progress& progress) {
  const Recording recording = readRecording(path);
  const double count = double(recording.operations.size());
  for (std::size_t n = 0; n < recording.operations.size(); ++n) {
    progress.step("replay", double(n) / count);
    apply(recording.operations[n]);
  }
}

void ClayDesk::put(std::vector<UnpackedPatch> patches) {
  for (UnpackedPatch& patch : patches) {
    auto& target = patch.fineness == Fineness::fine ? out_.fine : out_.coarse;
    const Key key = patch.origin;
    PatchRef ref;
    if (!patch.indices.empty()) ref = std::make_shared<const ShownPatch>(std::move(patch));
    target[key] = std::move(ref);
  }
}

void ClayDesk::showAll() {
  sculptor_->takeChanges();
  out_.cleared = true;
  out_.fine.clear();
  out_.coarse.clear();
  if (structure_ == Structure::surface) {
    put(dresser_->rebuild(sculptor_->field(), sculptor_->surface()));
  } else {
    put(structurePatches(sculptor_->surface(), sculptor_->field(), structure_));
  }
  bounds_ = dresser_->bounds(sculptor_->surface());
  rest_ = Rest::floor;
  tellStatus();
}

void ClayDesk::show() {
  const SurfaceChanges changes = sculptor_->takeChanges();
  if (changes.all || structure_ != Structure::surface) return showAll();
  std::vector<UnpackedPatch> patches =
      dresser_->refresh(sculptor_->field(), sculptor_->surface(), changes.blocks, changes.patches);
  for (const UnpackedPatch& patch : patches) status_.lastEdit.add(patch.bounds());
  bounds_.add(status_.lastEdit);
  put(std::move(patches));
  rest_ = Rest::light;
  tellStatus();
}

void ClayDesk::tellStatus() {
  status_.scale = sculptor_->field().scale;
  status_.bounds = bounds_;
  if (!status_.inStroke) status_.stage = Stage::around(bounds_);
  status_.mass = status_.last.massAfter;
  status_.clay = sculptor_->clay();
  tellSolid(sculptor_->solid());
  const auto& history = sculptor_->history();
  status_.done = history.undoDepth();
  status_.isLit = rest_ != Rest::light;
  status_.operations = recording_.operations.size();
  status_.steps = titles_;
  out_.status = status_;
}

void ClayDesk::setStructure(Structure structure) {
  structure_ = structure;
  showAll();
}

bool ClayDesk::settle() {
  if (stroke_) return false;
  switch (rest_) {
    case Rest::light: {
      std::vector<UnpackedPatch> better = dresser_->settle(sculptor_->surface());
      if (better.empty()) rest_ = Rest::floor;
      put(std::move(better));
      return true;
    }
    case Rest::floor:
      bounds_ = dresser_->bounds(sculptor_->surface());
      tellStatus();
      out_.floor = dresser_->floor(status_.stage, bounds_);
      rest_ = Rest::statistics;
      return true;
    case Rest::statistics:
      out_.statistics = count();
      rest_ = Rest::pictures;
      return true;
    case Rest::pictures:
      if (pictureNext()) return true;
      rest_ = Rest::nothing;
      break;
    case Rest::nothing:
      break;
  }
  return false;
}

ClayStatistics ClayDesk::count() const {
  ClayStatistics counted;
  const Clay& field = sculptor_->field();
  counted.field = statistics(field);
  const SurfaceStatistics surface = statistics(sculptor_->surface(), field);
  counted.cubes = surface.cubes;
  counted.crossingCubes = surface.crossingCubes;
  counted.edges = surface.edges;
  counted.triangles = surface.triangles;
  counted.components = surface.components;
  return counted;
}

Publication ClayDesk::take() { return std::exchange(out_, {}); }

}  // namespace bozzetto::ui
