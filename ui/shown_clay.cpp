#include "ui/shown_clay.hpp"

#include <utility>

#include "bozzetto/field/smoothed.hpp"

namespace bozzetto::ui {

void ShownClay::setSmoothing(Smoothing smoothing) {
  copy_.reset();
  if (smoothing == Smoothing::shown) copy_.emplace();
}

void ShownClay::rebuild(const Clay& clay) {
  if (!copy_) return;
  copy_->clay = smoothed(clay);
  copy_->surface.rebuild(copy_->clay);
  copy_->waiting.clear();
}

SurfaceChanges ShownClay::follow(const Clay& clay, const SurfaceChanges& changes) {
  if (!copy_) return changes;
  SurfaceChanges shown;
  followBlocks(clay, changes.blocks);
  shown.blocks = std::exchange(copy_->waiting, {});
  shown.patches = copy_->surface.refresh(copy_->clay, shown.blocks).changed;
  return shown;
}

std::vector<KeyRun> ShownClay::followBlocks(const Clay& clay, const std::vector<KeyRun>& blocks) {
  if (!copy_) return blocks;
  std::vector<KeyRun> altered = refreshSmoothed(copy_->clay, clay, blocks);
  auto& waiting = copy_->waiting;
  waiting.insert(waiting.end(), altered.begin(), altered.end());
  waiting = withoutOverlaps(std::move(waiting));
  return altered;
}

}  // namespace bozzetto::ui
