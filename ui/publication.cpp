#include "ui/publication.hpp"

#include <algorithm>

#include "ui/sculpt_state.hpp"

namespace bozzetto::ui {
namespace {

template <class T>
void replaceIf(std::optional<T>& old, std::optional<T>& later) {
  if (later) old = std::move(later);
}

std::size_t bytesOf(const std::map<Key, PatchRef>& patches) {
  std::size_t bytes = 0;
  for (const auto& [key, patch] : patches) bytes += patch ? patch->uploadBytes() : 0;
  return bytes;
}

// "stroke paint_soft" → the paint; nothing for what is no stroke.
std::optional<ActionKind> actionOf(const std::string& label) {
  constexpr std::string_view kStroke = "stroke ";
  if (!label.starts_with(kStroke)) return std::nullopt;
  return actionNamed(std::string_view(label).substr(kStroke.size()));
}

// "solid_move" → "Solid move".
std::string readable(std::string label) {
  std::ranges::replace(label, '_', ' ');
  if (!label.empty()) label[0] = char(std::toupper(static_cast<unsigned char>(label[0])));
  return label;
}

StepLine lineOf(const Step& step) {
  StepLine line{
      step.number, step.parent,        readable(step.note.label), actionOf(step.note.label),
      step.time,   step.changedCorners};
  for (const ToolRow& row : toolTable())
    if (row.action == line.action) line.title = row.title;
  if (step.note.label == "stroke recall") line.title = "Bring back";
  return line;
}

}  // namespace

const StepLine* HistoryView::find(StepNumber number) const {
  const auto at = std::ranges::lower_bound(steps, number, {}, &StepLine::number);
  return at != steps.end() && at->number == number ? &*at : nullptr;
}

HistoryView viewOf(const History<8>& history) {
  const StepTree& tree = history.tree();
  HistoryView view;
  for (const Step& step : history.steps()) view.steps.push_back(lineOf(step));
  view.root = tree.root();
  view.place = tree.place();
  view.saved = history.savedState();
  view.done = tree.undoDepth();
  const StepNumber end = tree.redoTarget(tree.redoDepth());
  for (const StepTree::Leg& leg : tree.path(tree.root(), end)) view.line.push_back(leg.step);
  return view;
}

bool Publication::empty() const {
  return !cleared && fine.empty() && coarse.empty() && heights.empty() && !undraped && !floor &&
         !status && !statistics && !opened && pictures.empty() && !left && !saved && !comparison &&
         !shelf && !taken && !solid && !touched && notes.empty() && errors.empty();
}

void Publication::add(Publication later) {
  if (later.undraped) {
    undraped = true;
    heights.clear();
  }
  for (auto& [key, patch] : later.heights) heights[key] = std::move(patch);
  if (later.cleared) {
    cleared = true;
    fine.clear();
    coarse.clear();
  }
  if (later.opened) pictures.clear();
  for (auto& [key, patch] : later.fine) fine[key] = std::move(patch);
  for (auto& [key, patch] : later.coarse) coarse[key] = std::move(patch);
  for (auto& [step, png] : later.pictures) pictures[step] = std::move(png);
  replaceIf(floor, later.floor);
  replaceIf(status, later.status);
  replaceIf(statistics, later.statistics);
  replaceIf(opened, later.opened);
  replaceIf(left, later.left);
  replaceIf(saved, later.saved);
  replaceIf(comparison, later.comparison);
  replaceIf(shelf, later.shelf);
  replaceIf(taken, later.taken);
  replaceIf(solid, later.solid);
  replaceIf(touched, later.touched);
  for (std::string& text : later.notes) notes.push_back(std::move(text));
  for (std::string& text : later.errors) errors.push_back(std::move(text));
}

std::size_t Publication::uploadBytes() const {
  return bytesOf(fine) + bytesOf(coarse) + bytesOf(heights);
}

}  // namespace bozzetto::ui
