// The past: steps to go to, to compare with, to bring back; work that came back by itself.
#include "ui/atelier.hpp"

namespace bozzetto::ui {

void Atelier::setTool(ActionKind action) {
  setMode(WorkMode::clay);
  sculpt.action = action;
  sculpt.recall.reset();
}

void Atelier::goTo(StepNumber step) {
  if (step != status_.history->place) apply(GoToOperation{step});
}

void Atelier::recallFrom(StepNumber step) { sculpt.recall = step; }

void Atelier::compareWith(StepNumber step) {
  ask([step](ClayDesk& desk) { desk.compare(step); });
}

void Atelier::peek(bool shown) {
  if (shown == peeking_ || (shown && !comparison)) return;
  peeking_ = shown;
  touch();
  const auto step = shown ? std::optional(comparison->step) : std::nullopt;
  worker_.post([step](ClayDesk& desk) { desk.peek(step); });
}

void Atelier::answerRecovered(bool asSaved) {
  dialog = Dialog::none;
  if (asSaved && status_.history->saved) goTo(*status_.history->saved);
}

void Atelier::openLeftBehind(const std::filesystem::path& path) {
  dialog = Dialog::none;
  ifSaved([this, path] {
    bring("Opening what was left behind",
          [path, leaving = leaving()](ClayDesk& desk, Progress& progress) {
            desk.open(path, progress, leaving);
          });
  });
}

void Atelier::discardLeftBehind(const std::filesystem::path& path) {
  worker_.post([path](ClayDesk& desk) { desk.discardLeftBehind(path); });
}

void Atelier::keepPicture(StepNumber step, Bytes png) {
  if (bringing() != nullptr) return;
  worker_.post([step, png = std::move(png)](ClayDesk& desk) mutable {
    desk.keepPicture(step, std::move(png));
  });
}

}  // namespace bozzetto::ui
