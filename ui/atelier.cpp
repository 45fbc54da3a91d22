#include "ui/atelier.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace bozzetto::ui {
namespace {

constexpr double kMessageSeconds = 6;

CellBounds inWorld(const CellBounds& cells, double spacing) {
  return {cells.low * spacing, cells.high * spacing};
}

}  // namespace

Atelier::Atelier(const Options& given) : configFolder_(given.configFolder), worker_(given.wake) {
  if (!configFolder_.empty()) settings = readSettings(configFolder_);
  keymap.setProfile(settings.profile);
  keymap.setChanges(settings.keys);
  sculpt.pressureStrength = settings.pressureStrength;
  sculpt.pressureSize = settings.pressureSize;
  sculpt.curve = {settings.pressureGamma, settings.pressureLeast};
  view.turnTo(0.42, 0.10);
  options.look.dither = 1;
  if (given.scene.empty()) {
    startNew(NewClay::ball);
  } else {
    openScene(given.scene);
  }
}

Atelier::~Atelier() {
  settings.profile = keymap.profile();
  settings.keys = keymap.changes();
  settings.pressureStrength = sculpt.pressureStrength;
  settings.pressureSize = sculpt.pressureSize;
  settings.pressureGamma = sculpt.curve.gamma;
  settings.pressureLeast = sculpt.curve.least;
  try {
    writeSettings(configFolder_, settings);
  } catch (const Error&) {
    // Settings are a comfort; the scene is what matters, and it has been saved.
  }
}

void Atelier::setViewport(glm::dvec2 corner, const Extent& extent, double scale) {
  corner_ = corner;
  extent_ = extent;
  scale_ = scale;
}

Publication Atelier::poll() {
  Publication fresh = worker_.take();
  if (fresh.cleared) patches_.clear();
  for (const auto& [key, patch] : fresh.fine) patches_.put(key, patch);
  if (fresh.status) status_ = *fresh.status;
  if (fresh.statistics) statistics_ = *fresh.statistics;
  if (fresh.opened) opened(*fresh.opened);
  if (fresh.solid) {
    solidShown_ = *fresh.solid;
    previewing_ = false;
    if (gesture_ != Gesture::solid) hoverSolid();
  }
  if (fresh.shelf) shelf.cards = *fresh.shelf;
  if (fresh.taken) sculpt.take(*fresh.taken, status_.scale.spacing);
  for (const std::string& text : fresh.notes) say(Message::Kind::note, text);
  for (const std::string& text : fresh.errors) say(Message::Kind::error, text);
  if (!framed_ && !patches_.empty()) frameAll();
  if (!sized_ && !patches_.empty()) {
    const CellBounds& all = patches_.bounds();
    const double half = glm::length(all.high - all.low) / 2;
    sculpt.size = std::clamp(half * 0.1, 3.0, 64.0) * status_.scale.spacing;
    sized_ = true;
  }
  if (job_ && job_->isOver()) {
    const auto job = std::exchange(job_, nullptr);
    const auto then = std::exchange(afterJob_, nullptr);
    if (then && !job->failed()) then();
  }
  if (!fresh.empty() && gesture_ == Gesture::none) updateHover();
  return fresh;
}

void Atelier::opened(const SceneParts& parts) {
  framed_ = sized_ = false;
  mode_ = WorkMode::clay;
  if (shelf.open) listShelf();
  airPoint_.reset();
  heldTool_.reset();
  views_ = {};
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
  views_.moved(before, now_);
  touch();
  updateHover();
}

std::string Atelier::title() const { return path_.empty() ? "untitled" : path_.stem().string(); }

void Atelier::say(Message::Kind kind, std::string text) {
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

void Atelier::apply(const Operation& operation) {
  touch();
  worker_.post([operation](ClayDesk& desk) { desk.apply(operation); });
}

void Atelier::goToStep(std::size_t done) {
  const int by = int(done) - int(status_.done);
  if (by < 0) apply(UndoOperation{-by});
  if (by > 0) apply(RedoOperation{by});
}

}  // namespace bozzetto::ui
