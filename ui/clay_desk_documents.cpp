// Documents on the desk: opened, saved in the background, left.
#include <algorithm>
#include <cmath>

#include "bozzetto/io/mesh_file.hpp"
#include "bozzetto/mesh/decimate.hpp"
#include "bozzetto/surface/welded.hpp"
#include "ui/clay_desk.hpp"
#include "ui/clay_desk_parts.hpp"

namespace bozzetto::ui {
namespace {

namespace fs = std::filesystem;

FillOperation firstShape(NewClay kind, double radius) {
  Primitive primitive;
  primitive.radii = glm::dvec3(radius);
  if (kind == NewClay::block) {
    primitive.shape = Shape::box;
    primitive.radii *= 0.8;
  }
  return {primitive};
}

// Nobody has worked on the first shape of a new document: it is not offered as work.
bool isOnlyBegun(std::size_t steps, const std::string& lastLabel) {
  return steps < 2 && lastLabel == "fill";
}

}  // namespace

ClayDesk::ClayDesk(FileSystem& files) : files_(&files) {
  session_ = std::make_unique<Session>(Session::inMemory(options()));
  lay(std::move(*session_));
}

ClayDesk::~ClayDesk() {
  stroke_.reset();
  endSaving();
}

SessionOptions ClayDesk::options() const {
  SessionOptions options;
  options.upkeep = SurfaceUpkeep::afterEachDab;
  options.files = files_;
  return options;
}

// Puts another document on the desk; the old one has been put away.
void ClayDesk::lay(Session session) {
  session_ = std::make_unique<Session>(std::move(session));
  dresser_ = std::make_unique<Dresser>();
  recording_ = {};
  if (!sculptor().field().tree.empty())
    recording_.start =
        RecordingStart{session_->path().filename().string(), fieldHash(sculptor().field())};
  heldTool_ = heldAction_ = heldClay_ = "";
  begun_.reset();
  const std::uint64_t version = status_.version + 1;
  status_ = {};
  status_.version = version;
  historyMoment_ = ~std::uint64_t{0};
  pictureless_.clear();
  unpictured_.clear();
  for (const Step& step : history().steps()) pictureless_.push_back(step.number);
  OpenedDocument opened{session_->parts, session_->findings()};
  const auto saved = history().savedState();
  const bool elsewhere = saved != history().place();
  opened.canGoBack = saved && elsewhere;
  const auto steps = history().steps();
  const bool neverSaved = !saved && !steps.empty();
  const bool onlyBegun = neverSaved && isOnlyBegun(steps.size(), steps.back().note.label);
  opened.surprising =
      opened.findings.recovered && elsewhere && !onlyBegun && !session_->path().empty();
  out_.opened = std::move(opened);
  for (const std::string& notice : session_->findings().notices) note(notice);
  showAll();
}

// Nothing is on the desk then, but air.
void ClayDesk::putAway() {
  cancelStroke();
  settleHand();
  endSaving();
  leave();
  *session_ = Session::inMemory(options());
}

void ClayDesk::leave() {
  cancelStroke();
  settleHand();
  endSaving();
  if (!session_->saved() && !isModified()) discard();
}

void ClayDesk::discard() {
  cancelStroke();
  settleHand();
  endSaving();
  Session::discard(std::move(*session_));
  *session_ = Session::inMemory(options());
}

// A new one; in memory where there is no place for it.
Session ClayDesk::begin(const fs::path& path) {
  try {
    return Session::create(path, options());
  } catch (const Error& error) {
    fail(error.what());
    fail("Nothing is kept on the disk until the scene is saved");
    return Session::inMemory(options());
  }
}

void ClayDesk::startNew(NewClay kind, const fs::path& path) {
  putAway();
  lay(begin(path));
  if (kind != NewClay::empty) apply(firstShape(kind, newRadius));
  begun_ = history().place();
  tellStatus();
}

void ClayDesk::leave(Leaving leaving) {
  if (leaving == Leaving::discard) discard();
  putAway();
}

// Our own file is free for the new session only when we have left it: then a look comes first.
void ClayDesk::open(const fs::path& path, Progress& progress, Leaving leaving) {
  std::error_code ignored;
  const bool own = fs::equivalent(path, session_->path(), ignored);
  if (own) {
    Session::look(path, options(), progress);
    leave(leaving);
  }
  Session opened = Session::open(path, options(), progress);
  if (!own) leave(leaving);
  lay(std::move(opened));
}

void ClayDesk::import(const ImportOperation& operation, Progress& progress, Leaving leaving) {
  Session made = begin({});
  Telling telling(progress, *this);
  OperationReport report;
  try {
    report = made.sculptor().apply(operation, telling);
  } catch (...) {
    Session::discard(std::move(made));
    throw;
  }
  leave(leaving);
  lay(std::move(made));
  recording_.start.reset();
  recording_.operations.push_back(operation);
  status_.last = report;
  tellStatus();
}

// What the window knows of the document.
void ClayDesk::give(const SceneParts& parts) {
  session_->parts.view = parts.view;
  session_->parts.thumbnail = parts.thumbnail;
  for (const auto& [name, value] : parts.settings) session_->parts.settings[name] = value;
}

void ClayDesk::save(const fs::path& path, const SceneParts& parts) {
  cancelStroke();
  settleHand();
  endSaving();
  if (path == session_->path()) session_->requireSavable();
  give(parts);
  session_->settleHistory();
  saving_ = std::make_unique<Saving>(session_->file(), path, session_->document());
  tellStatus();
}

// Waits where it has not ended.
void ClayDesk::endSaving() {
  if (!saving_) return;
  const auto saving = std::move(saving_);
  bool succeeded = false;
  try {
    saving->job.result();
    if (saving->path == session_->path()) {
      session_->markSaved(saving->document);
    } else {
      session_->goOnAs(saving->path, saving->document);
    }
    begun_.reset();
    succeeded = true;
  } catch (const std::exception& error) {
    fail(std::string("Not saved: ") + error.what());
  }
  out_.saved = SavedFile{saving->path, succeeded};
  historyMoment_ = ~std::uint64_t{0};
  tellStatus();
}

void ClayDesk::saveNumbered(const fs::path& path, const SceneParts& parts, Progress& progress) {
  give(parts);
  const Document copy = asCopy(session_->document());
  note("Saved " + saveNumberedCopy(path, copy, progress, *files_).filename().string());
}

void ClayDesk::exportMesh(const fs::path& path, double keep, Progress& progress) {
  meshFormatOf(path);
  const TriangleMesh mesh = weld(sculptor().surface(), sculptor().field().scale);
  writeMesh(path, keep < 1 ? decimate(mesh, keep) : mesh, progress);
}

void ClayDesk::findLeftBehind() {
  std::vector<LeftDocument> left;
  for (const fs::path& path : Session::leftBehind(*files_)) {
    const auto glance = glanceAt(historyFolderOf(path), *files_);
    if (!glance) continue;
    if (isOnlyBegun(glance->steps, glance->label)) {
      Session::discardLeftBehind(path, *files_);
    } else {
      left.push_back({path, *glance});
    }
  }
  std::ranges::sort(left, std::greater(), [](const LeftDocument& d) { return d.glance.time; });
  out_.left = std::move(left);
}

void ClayDesk::discardLeftBehind(const fs::path& path) {
  Session::discardLeftBehind(path, *files_);
  findLeftBehind();
}

// A new shape that nobody has touched is no work, and a file that holds all is none either.
bool ClayDesk::isModified() const {
  if (session_->saved()) return false;
  return history().place() != begun_;
}

Keeping ClayDesk::keeping() const {
  const History<8>& steps = history();
  Keeping keeping;
  keeping.path = session_->path();
  keeping.modified = isModified();
  keeping.readOnly = session_->findings().readOnly;
  keeping.kept = steps.onDisk() && steps.durableMoment() >= steps.moment();
  keeping.trouble = session_->trouble();
  if (saving_) keeping.saving = std::floor(saving_->job.done() * 20) / 20;
  return keeping;
}

// Shelf, supports and settings survive a crash too, also where no quiet moment comes.
void ClayDesk::keepPartsSoon() {
  const auto now = std::chrono::steady_clock::now();
  const bool early = now - partsKept_ < std::chrono::seconds(1);
  if (stroke_ || (early && session_->trouble().empty())) return;
  partsKept_ = now;
  session_->keepParts();
}

void ClayDesk::lookAfter() {
  if (saving_ && saving_->job.finished()) return endSaving();
  keepPartsSoon();
  if (!(keeping() == status_.keeping)) tellStatus();
}

bool ClayDesk::isWaiting() const {
  const History<8>& steps = history();
  return saving_ ||
         (steps.onDisk() && session_->trouble().empty() && steps.durableMoment() < steps.moment());
}

std::optional<std::chrono::milliseconds> ClayDesk::patience() const {
  if (isWaiting()) return std::chrono::milliseconds(15);
  if (!session_->trouble().empty()) return std::chrono::milliseconds(1000);
  return std::nullopt;
}

}  // namespace bozzetto::ui
