#include "ui/clay_desk.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <numbers>

#include "bozzetto/base/file.hpp"
#include "bozzetto/render/thumbnail.hpp"
#include "bozzetto/sculptor/replay.hpp"
#include "bozzetto/surface/statistics.hpp"
#include "ui/clay_desk_parts.hpp"
#include "ui/stiffness_shown.hpp"

namespace bozzetto::ui {
namespace {

constexpr std::size_t kMostDrawn = 60;   // steps of earlier days without a picture
constexpr double kMostBlocks = 125'000;  // of a stroke's own: half a gigabyte, more than by intent

}  // namespace

void ClayDesk::apply(const Operation& operation, Progress& progress) {
  cancelStroke();
  settleHand();
  status_.lastEdit = {};
  status_.lastEditStep = 0;
  const StepNumber newest = newestStep();
  heldTool_ = heldAction_ = heldClay_ = "";  // some operations change the hand
  Telling telling(progress, *this);
  status_.last = bench().apply(operation, telling);
  if (status_.last.physics) solidRan_ = status_.last.physics;
  recording_.operations.push_back(operation);
  ++status_.version;
  if (newestStep() != newest) status_.lastEditStep = history().place();
  show();
}

StepNumber ClayDesk::newestStep() const {
  const auto& steps = status_.history->steps;
  return std::max(steps.empty() ? 0 : steps.back().number, history().place());
}

void ClayDesk::relax(const ClayOperation& settings, int steps, Progress& progress) {
  cancelStroke();
  settleHand();
  holdOne(settings, heldClay_);
  apply(RelaxOperation{steps}, progress);
}

// Strokes take what the hand holds; it is told only when it changes.
void ClayDesk::holdOne(const Operation& wanted, std::string& held) {
  std::string text = toText(wanted);
  if (text == held) return;
  Telling telling(Progress::none(), *this);
  bench().apply(wanted, telling);
  recording_.operations.push_back(wanted);
  held = std::move(text);
}

void ClayDesk::behave(const ClayOperation& clay) {
  if (stroke_ || toText(clay) == toText(ClayOperation{sculptor().clay().settings})) return;
  holdOne(clay, heldClay_);
  tellStatus();
}

void ClayDesk::hold(const HandOperations& hand) {
  holdOne(hand.tool, heldTool_);
  holdOne(hand.action, heldAction_);
  if (movesClay(hand.action.action.kind)) holdOne(hand.clay, heldClay_);
}

void ClayDesk::beginStroke(const HandOperations& hand, Stroke stroke) {
  cancelStroke();
  settleHand();
  hold(hand);
  stroke_ = bench().begin(std::move(stroke));
  noticed_.clear();
  tellNotice();
  nodesBefore_ = sculptor().field().tree.nodeCount();
  dabs_ = 0;
  grown_ = false;
  status_.inStroke = true;
  status_.lastEdit = {};
  status_.lastEditStep = 0;
  tellStatus();
}

// As replaying tells it: once a stroke, unless more points change it.
void ClayDesk::tellNotice() {
  std::string notice = stroke_->notice();
  if (notice.empty() || notice == noticed_) return;
  note(notice);
  noticed_ = std::move(notice);
}

void ClayDesk::extendStroke(std::span<const StrokePoint> points) {
  for (std::size_t n = 0; stroke_ && n < points.size() && !grewEnough(); ++n) {
    stroke_->extend(points.subspan(n, 1));
  }
}

// What a large tool does by accident, far away. Of dabs that are not made yet a tube is expected:
// a block of it has some 64 cells of surface.
bool ClayDesk::grewEnough() {
  if (grown_ || sculptor().action().kind != ActionKind::add) return grown_;
  const FieldScale& scale = sculptor().field().scale;
  const glm::dvec3 radii = sculptor().tool().radii / scale.spacing;
  const auto [smallest, largest] = std::minmax({radii.x, radii.y, radii.z});
  const double waiting = double(stroke_->plannedDabs() - dabs_) * stroke_->stroke().spacing;
  const double made = double(sculptor().field().tree.nodeCount()) - double(nodesBefore_);
  const double expected = made + waiting * smallest * 2 * std::numbers::pi * largest / 64;
  grown_ = expected > kMostBlocks;
  if (grown_)
    note("So much clay at a time is hardly meant: the stroke ends here. Go on with another");
  return grown_;
}

bool ClayDesk::dab() {
  if (!stroke_ || givesUp()) return false;
  const bool made = enough([&] { return stroke_->dab(); });
  if (made) ++dabs_;
  unshown_ |= made;
  return made;
}

void ClayDesk::showDabs() {
  if (!std::exchange(unshown_, false)) return;
  enough([&] {
    show();
    return true;
  });
}

// Where memory ends the stroke goes.
bool ClayDesk::enough(const std::function<bool()>& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    cancelStroke();
    throw Error("not enough memory for this stroke: a smaller tool or a coarser grid needs less");
  }
}

void ClayDesk::endStroke() {
  if (!stroke_) return;
  if (givesUp()) return cancelStroke();
  tellNotice();
  status_.last = stroke_->finish();
  tellNotice();  // what the clay could not do
  recording_.operations.push_back(StrokeOperation{stroke_->stroke()});
  stroke_.reset();
  undrape();
  status_.inStroke = false;
  ++status_.version;
  status_.lastEditStep = history().place();
  show();
}

void ClayDesk::cancelStroke() {
  if (!stroke_) return;
  stroke_.reset();
  status_.inStroke = false;
  show();
}

// Another state that was looked at makes room for ours.
void ClayDesk::settleHand() { peek(std::nullopt); }

// The clay itself and its history stay where they are.
void ClayDesk::peek(std::optional<StepNumber> step) {
  if (stroke_ || (!step && !peek_)) return;
  const auto before = std::exchange(peek_, nullptr);
  status_.peek = step;
  if (before && !before->sameGrid) {
    showAll();
  } else if (before) {
    put(dresser_->refresh(shownClay(), shownSurface(), before->changes.blocks,
                          before->changes.patches));
    rest_ = Rest::light;
    tellStatus();
  }
  if (!step) return;
  peek_ = std::make_unique<Peek>(bench().history().fieldAt(*step, sculptor().field()), sculptor(),
                                 shown_);
  if (structure_ != Structure::surface) peek_->sameGrid = false;
  if (!peek_->sameGrid) out_.cleared = true;
  const Clay& clay = peek_->shown.of(peek_->clay);
  const Surface<8>& surface = peek_->shown.of(peek_->surface);
  put(peek_->sameGrid
          ? dresser_->refresh(clay, surface, peek_->changes.blocks, peek_->changes.patches)
          : dresser_->rebuild(clay, surface));
  tellStatus();
}

void ClayDesk::compare(StepNumber step) {
  cancelStroke();
  settleHand();
  const Peek then(bench().history().fieldAt(step, sculptor().field()), sculptor(), {});
  const Clay& now = sculptor().field();
  Comparison found{step, bozzetto::compare(then.clay, now), then.clay.scale, now.scale};
  found.volumeThen = then.volume();
  found.volumeNow = measure(sculptor().surface()).volume * std::pow(now.scale.spacing, 3);
  out_.comparison = found;
}

void ClayDesk::keepPicture(StepNumber step, Bytes png) {
  bench().history().setThumbnail(step, std::move(png));
}

void ClayDesk::saveRecording(const std::filesystem::path& path) const {
  const std::string text = toText(recording_);
  writeFile(path, std::as_bytes(std::span(text)));
}

void ClayDesk::replay(const std::filesystem::path& path, Progress& progress) {
  const Recording recording = readRecording(path);
  Telling telling(progress, *this);
  requireStart(recording, sculptor().field(), telling);
  const double count = double(recording.operations.size());
  for (std::size_t n = 0; n < recording.operations.size(); ++n) {
    progress.step("replay", double(n) / count);
    apply(recording.operations[n]);
    if (status_.lastEditStep != 0) unpictured_.push_back(status_.lastEditStep);
  }
}

void ClayDesk::put(std::vector<UnpackedPatch> patches) {
  for (UnpackedPatch& patch : patches) {
    if (stiffnessTold_.any()) patch.stiffness = stiffnessOn(patch, stiffnessTold_);
    auto& target = patch.fineness == Fineness::fine ? out_.fine : out_.coarse;
    const Key key = patch.origin;
    auto& known = patch.fineness == Fineness::fine ? fine_ : coarse_;
    PatchRef ref;
    if (!patch.indices.empty()) ref = std::make_shared<const ShownPatch>(std::move(patch));
    if (ref) {
      known[key] = ref;
    } else {
      known.erase(key);
    }
    target[key] = std::move(ref);
  }
}

void ClayDesk::showAll() {
  bench().takeChanges();
  out_.cleared = true;
  out_.undraped |= std::exchange(draped_, false);
  for (auto* patches : {&out_.fine, &out_.coarse, &fine_, &coarse_}) patches->clear();
  shown_.rebuild(sculptor().field());
  if (structure_ == Structure::surface) {
    put(dresser_->rebuild(shownClay(), shownSurface()));
  } else {
    put(structurePatches(sculptor().surface(), sculptor().field(), structure_));
  }
  bounds_ = dresser_->bounds(shownSurface());
  if (status_.lastEditStep != 0) status_.lastEdit = bounds_;
  rest_ = Rest::floor;
  tellStatus();
}

void ClayDesk::show() {
  unshown_ = false;
  const SurfaceChanges changes = bench().takeChanges();
  if (changes.all || structure_ != Structure::surface) return showAll();
  if (draped_) {
    showCloths(changes);
  } else {
    showMesh(changes);
  }
}

void ClayDesk::tellStatus() {
  showStiffness();
  status_.scale = peek_ ? peek_->clay.scale : sculptor().field().scale;
  status_.bounds = bounds_;
  if (!status_.inStroke) status_.stage = Stage::around(bounds_);
  status_.mass = status_.last.massAfter;
  status_.ledger = sculptor().ledger();
  tellSupports();
  tellSolid(sculptor().solid());
  status_.isLit = rest_ != Rest::light;
  status_.operations = recording_.operations.size();
  if (std::exchange(historyMoment_, history().moment()) != history().moment()) {
    status_.history = std::make_shared<const HistoryView>(viewOf(history()));
    status_.done = status_.history->done;
  }
  status_.keeping = keeping();
  out_.status = status_;
}

void ClayDesk::tellSupports() {
  status_.clay = sculptor().clay();
  status_.supportMeshes.clear();
  std::map<std::shared_ptr<const Sculpture>, std::shared_ptr<const ToolMesh>> meshes;
  for (const clay::Support& support : status_.clay.supports) {
    std::shared_ptr<const ToolMesh> mesh;
    if (support.shape == Shape::freeform) {
      mesh = supportMeshes_[support.sculpture];
      if (!mesh) mesh = meshOf(*support.sculpture);
      meshes[support.sculpture] = mesh;
    }
    status_.supportMeshes.push_back(std::move(mesh));
  }
  supportMeshes_ = std::move(meshes);
}

void ClayDesk::setStructure(Structure structure) {
  structure_ = structure;
  showAll();
}

void ClayDesk::setSmoothing(Smoothing smoothing) {
  cancelStroke();
  settleHand();
  shown_.setSmoothing(smoothing);
  showAll();
}

bool ClayDesk::settle() {
  if (stroke_ || peek_) return false;
  keepPartsSoon();
  if (const auto sculpture = std::exchange(unprepared_, nullptr)) {
    sculpture->distance();
    return true;
  }
  switch (rest_) {
    case Rest::light: {
      std::vector<UnpackedPatch> better = dresser_->settle(shownSurface());
      if (better.empty()) rest_ = Rest::floor;
      put(std::move(better));
      return true;
    }
    case Rest::floor:
      bounds_ = dresser_->bounds(shownSurface());
      tellStatus();
      out_.floor = dresser_->floor(status_.stage, bounds_);
      rest_ = Rest::statistics;
      return true;
    case Rest::statistics:
      out_.statistics = count();
      rest_ = Rest::pictures;
      return true;
    case Rest::pictures:
      if (loadPicture() || pictureNext() || pictureStep()) return true;
      rest_ = Rest::nothing;
      break;
    case Rest::nothing:
      break;
  }
  session_->keepParts();
  return false;
}

// Of steps from earlier days, the latest first.
bool ClayDesk::loadPicture() {
  if (pictureless_.empty()) return false;
  const StepNumber step = pictureless_.back();
  pictureless_.pop_back();
  if (Bytes png = history().thumbnail(step); !png.empty()) {
    out_.pictures[step] = std::move(png);
  } else if (unpictured_.size() < kMostDrawn) {
    unpictured_.push_back(step);
  }
  return true;
}

// Of steps that no window saw happen: imported, replayed, made by the command line.
bool ClayDesk::pictureStep() {
  if (pictures_ == ShelfPictures::none || unpictured_.empty()) return false;
  const StepNumber step = unpictured_.front();
  unpictured_.erase(unpictured_.begin());
  try {
    const Clay then = bench().history().fieldAt(step, sculptor().field());
    Bytes png = thumbnailOf(then, kStepPicture.x, kStepPicture.y);
    if (png.empty()) return true;
    out_.pictures[step] = png;
    keepPicture(step, std::move(png));
  } catch (const Error&) {
    // It is no more, or cannot be read.
  }
  return true;
}

ClayStatistics ClayDesk::count() const {
  ClayStatistics counted;
  const Clay& field = sculptor().field();
  counted.field = statistics(field);
  const SurfaceStatistics surface = statistics(sculptor().surface(), field);
  counted.cubes = surface.cubes;
  counted.crossingCubes = surface.crossingCubes;
  counted.edges = surface.edges;
  counted.triangles = surface.triangles;
  counted.components = surface.components;
  const SurfaceMeasure measured = measure(sculptor().surface());
  counted.volume = measured.volume * std::pow(field.scale.spacing, 3);
  counted.area = measured.area * field.scale.spacing * field.scale.spacing;
  return counted;
}

Publication ClayDesk::take() {
  if (posed_) {
    posed_->carry(out_.fine);
    posed_->carry(out_.coarse);
  }
  return std::exchange(out_, {});
}

}  // namespace bozzetto::ui
