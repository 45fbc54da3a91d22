#include "ui/atelier.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "bozzetto/sculptor/clay_settings.hpp"

namespace bozzetto::ui {
namespace {

constexpr double kSettingsSeconds = 1;  // between two looks at what settings became
constexpr double kMessageSeconds = 6;

CellBounds inWorld(const CellBounds& cells, double spacing) {
  return {cells.low * spacing, cells.high * spacing};
}

}  // namespace

Atelier::Atelier(const Options& given) : configFolder_(given.configFolder), worker_(given.wake) {
  if (!configFolder_.empty()) settings = settingsKept_ = readSettings(configFolder_);
  setProfile(settings.profile);
  keymap.setChanges(settings.keys);
  sculpt.pressureStrength = settings.pressureStrength;
  sculpt.pressureSize = settings.pressureSize;
  sculpt.curve = {settings.pressureGamma, settings.pressureLeast};
  view.turnTo(0.42, 0.10);
  options.look.dither = 1;
  worker_.post([radius = given.newRadius](ClayDesk& desk) { desk.newRadius = radius; });
  if (given.scene.empty()) {
    startNew(NewClay::ball);
    worker_.post([](ClayDesk& desk) { desk.findLeftBehind(); });
  } else {
    openScene(given.scene);
  }
}

Atelier::~Atelier() {
  for (const Job& each : jobs_) each.job->cancel();
  keepSettings();
}

// Written when they changed, so that a crash takes none of them.
void Atelier::keepSettings() {
  settings.profile = keymap.profile();
  settings.keys = keymap.changes();
  settings.pressureStrength = sculpt.pressureStrength;
  settings.pressureSize = sculpt.pressureSize;
  settings.pressureGamma = sculpt.curve.gamma;
  settings.pressureLeast = sculpt.curve.least;
  if (settings == settingsKept_) return;
  settingsKept_ = settings;
  try {
    writeSettings(configFolder_, settings);
  } catch (const Error&) {
    // Settings are a comfort; the scene is what matters, and it has been saved.
  }
}

// Where ZBrush people drag beside the clay they turn it.
void Atelier::setProfile(KeyProfile profile) {
  keymap.setProfile(profile);
  sculpt.emptyDrag = profile == KeyProfile::zbrush ? EmptyDrag::orbit : EmptyDrag::sculpt;
}

void Atelier::setViewport(glm::dvec2 corner, const Extent& extent, double scale) {
  pointer_ += corner_ - corner;  // it stays where it is in the window
  const bool moved = corner != corner_;
  corner_ = corner;
  extent_ = extent;
  scale_ = scale;
  if (moved && gesture_ == Gesture::none) updateHover();
}

Publication Atelier::poll() {
  if (now_ > settingsKeptAt_ + kSettingsSeconds && gesture_ == Gesture::none) {
    settingsKeptAt_ = now_;
    keepSettings();
  }
  const bool settled = asked_ && asked_->isOver();
  std::vector<std::shared_ptr<LongJob>> over;
  for (const Job& each : jobs_)
    if (each.job->isOver()) over.push_back(each.job);
  Publication fresh = worker_.take();
  if (fresh.cleared) patches_.clear();
  for (const auto& [key, patch] : fresh.fine) patches_.put(key, patch);
  if (fresh.status) status_ = *fresh.status;
  showMovedSupport();
  if (fresh.statistics) statistics_ = *fresh.statistics;
  tell(fresh);
  if (fresh.solid) {
    solidShown_ = *fresh.solid;
    previewing_ = false;
    keepCurve();
    if (gesture_ != Gesture::solid) hoverSolid();
  }
  watchLights();
  tellSmoothing();
  feel(fresh);
  if (fresh.shelf) shelf.cards = *fresh.shelf;
  if (fresh.taken) {
    // What was chosen while it came stays.
    const ActionKind now = sculpt.action;
    sculpt.take(*fresh.taken, status_.scale.spacing);
    if (taking_.first && now != taking_.second) sculpt.action = now;
    taking_.first = nullptr;
  }
  if (!framed_ && !patches_.empty()) frameAll();
  if (!sized_ && !patches_.empty()) {
    const CellBounds& all = patches_.bounds();
    const double half = glm::length(all.high - all.low) / 2;
    sculpt.size = std::clamp(half * 0.1, 3.0, 64.0) * status_.scale.spacing;
    sized_ = true;
  }
  finishJobs(over);
  if (settled) {
    asked_ = nullptr;
    decide(std::exchange(afterAsking_, nullptr));
  }
  if (!fresh.empty() && gesture_ == Gesture::none) updateHover();
  return fresh;
}

void Atelier::finishJobs(const std::vector<std::shared_ptr<LongJob>>& over) {
  for (const auto& job : over) {
    const auto at = std::ranges::find(jobs_, job, &Job::job);
    const auto then = std::move(at->then);
    jobs_.erase(at);
    if (!job->error().empty()) say(Message::Kind::error, job->error());
    if (then && !job->failed()) then();
  }
}

// What has become of the document.
void Atelier::tell(const Publication& fresh) {
  if (fresh.opened) opened(*fresh.opened);
  if (fresh.comparison) comparison = fresh.comparison;
  if (fresh.left) {
    left_ = *fresh.left;
    if (left_.empty() == (dialog == Dialog::leftBehind)) {
      dialog = left_.empty() ? Dialog::none : Dialog::leftBehind;
    }
  }
  for (const std::string& text : fresh.notes) say(Message::Kind::note, text);
  for (const std::string& text : fresh.errors) say(Message::Kind::error, text);
  if (fresh.saved) saved(*fresh.saved);
}

void Atelier::saved(const SavedFile& file) {
  const auto then = std::exchange(whenSaved_, nullptr);
  if (!file.succeeded) return;
  savedAt_ = now_;
  settings.remember(file.path);
  say(Message::Kind::note, "Saved " + file.path.filename().string());
  if (then) then();
}

void Atelier::opened(OpenedDocument document) {
  document_ = std::move(document);
  const SceneParts& parts = document_.parts;
  comparison.reset();
  peeking_ = false;
  sculpt.recall.reset();
  sculpt.clay = settingsOf(parts, "scene");
  savedAt_ = -1;
  if (document_.surprising) dialog = Dialog::recovered;
  if (document_.findings.readOnly) {
    say(Message::Kind::error, "Open elsewhere: read-only here. Save as… keeps what you change");
  }
  framed_ = sized_ = false;
  setMode(WorkMode::clay);
  wantPictures();
  if (shelf.open) listShelf();
  if (sculpt.isFreeform()) lookForTool();
  airPoint_.reset();
  heldTool_.reset();
  views_ = {};
  movingReference.reset();
  takeLights(parts);
  options.boxSize = parts.view.workspace;
  if (parts.view.camera.distance > 0) {
    view = viewOf(parts.view.camera);
    framed_ = true;
  } else {
    view = ViewState{};
    view.turnTo(0.42, 0.10);
  }
}

void Atelier::frameAll() {
  std::vector<CellBounds> boxes;
  for (const CellBounds& box : patches_.boxes()) {
    boxes.push_back(inWorld(box, status_.scale.spacing));
  }
  if (mode_ == WorkMode::solid && solidShown_) {
    CellBounds& lattice = boxes.emplace_back();
    for (const glm::dvec3& point : solidShown_->control().points) lattice.add({point, point});
  }
  if (boxes.empty()) {
    const double half = 48 * status_.scale.spacing;
    boxes.push_back({glm::dvec3(-half), glm::dvec3(half)});
  }
  frame(view, boxes, extent_.aspect(), 0.82);
  framed_ = true;
  airPoint_.reset();
}

void Atelier::lookFrom(double yaw, double pitch) {
  const ViewState before = view;
  view.turnTo(yaw, pitch);
  movedView(before);
}

void Atelier::movedView(const ViewState& before) {
  if (view == before) return;
  views_.moved({before, studioSeen_}, now_);
  touch();
  updateHover();
}

std::string Atelier::title() const { return path().empty() ? "untitled" : path().stem().string(); }

void Atelier::say(Message::Kind kind, std::string text) {
  std::erase_if(messages_, [&](const Message& message) { return message.text == text; });
  messages_.push_back({kind, std::move(text), now_ + kMessageSeconds});
  if (messages_.size() > 4) messages_.erase(messages_.begin());
}

std::vector<Message> Atelier::messages() const {
  std::vector<Message> live;
  for (const Message& message : messages_)
    if (message.until > now_) live.push_back(message);
  return live;
}

Held Atelier::heldMeaning() const {
  if (keymap.smooths(held_)) return Held::smooth;
  if (keymap.holds(held_)) return Held::hold;
  return keymap.inverts(held_) ? Held::invert : Held::nothing;
}

ViewFrame Atelier::viewFrame() const {
  ViewFrame shown;
  shown.camera = cameraOf(view, status_.scale.spacing);
  shown.stage = status_.stage;
  shown.look = options.look;
  shown.stereo = options.stereo;
  shown.place = {0, 0, int(extent_.width), int(extent_.height)};
  shown.now = now_;
  shown.lastInput = lastInput_;
  shown.stroke = gesture_ == Gesture::stroke || status_.inStroke;
  return shown;
}

// While another document is on its way, what is done to this one would meet that one.
const LongJob* Atelier::bringing() const {
  for (const Job& each : jobs_)
    if (each.job->brings() == Brings::anotherDocument) return each.job.get();
  return nullptr;
}

bool Atelier::anotherComes() {
  const LongJob* job = bringing();
  if (job != nullptr)
    say(Message::Kind::note, job->title() + ": wait for it, or cancel it, to go on here");
  return job != nullptr;
}

void Atelier::ask(ClayWorker::Task task) {
  if (!anotherComes()) worker_.post(std::move(task));
}

void Atelier::begin(const std::string& title, ClayWorker::Work work, std::function<void()> then) {
  if (!anotherComes()) whenDone(worker_.start(title, std::move(work)), std::move(then));
}

void Atelier::bring(const std::string& title, ClayWorker::Work work, std::function<void()> then) {
  if (anotherComes()) return;
  whenDone(worker_.start(title, std::move(work), Brings::anotherDocument), std::move(then));
}

void Atelier::apply(const Operation& operation) {
  touch();
  ask([operation](ClayDesk& desk) { desk.apply(operation); });
}

}  // namespace bozzetto::ui
