// The clay on its way to the window: as a mesh, or as cloths while much of it moves (Dewaele & Cani
// 2003, §4.2).
#include <chrono>

#include "ui/clay_desk.hpp"
#include "ui/stiffness_shown.hpp"

namespace bozzetto::ui {
namespace {

class Stopwatch {
 public:
  double milliseconds() const {
    return std::chrono::duration<double, std::milli>(Clock::now() - began_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point began_ = Clock::now();
};

std::size_t blocksIn(const std::vector<KeyRun>& runs) {
  std::size_t sum = 0;
  for (const KeyRun& run : runs) sum += std::size_t(run.length);
  return sum;
}

}  // namespace

void ClayDesk::seenFrom(const Camera& camera) {
  if (eye_ == camera) return;
  eye_ = camera;
  if (draped_ && dresser_->drapery()->facings() != facingsFor(camera, bounds_)) drape();
}

void ClayDesk::showMesh(const SurfaceChanges& changes) {
  const Stopwatch watch;
  const SurfaceChanges shown = shown_.follow(sculptor().field(), changes);
  std::vector<UnpackedPatch> patches =
      dresser_->refresh(shownClay(), shownSurface(), shown.blocks, shown.patches);
  for (const UnpackedPatch& patch : patches) status_.lastEdit.add(patch.bounds());
  bounds_.add(status_.lastEdit);
  put(std::move(patches));
  rest_ = Rest::light;
  heightSwitch_.meshed(blocksIn(changes.blocks), watch.milliseconds());
  if (stroke_ && eye_ && heightSwitch_.wantsCloths()) drape();
  tellStatus();
}

// Paint is no change of the surface: patches that it meets, or met, are tinted anew.
void ClayDesk::showStiffness() {
  const clay::Stiffness& now = sculptor().clay().stiffness;
  if (now.painted == stiffnessTold_.painted) return;
  const clay::Stiffness before = std::exchange(stiffnessTold_, now);
  const CellBounds box = differenceOf(before, now);
  std::vector<UnpackedPatch> tinted;
  for (const auto* patches : {&fine_, &coarse_})
    for (const auto& [key, patch] : *patches)
      if (meet(patch->bounds, box)) tinted.push_back(patch->data);
  put(std::move(tinted));
}

void ClayDesk::showCloths(const SurfaceChanges& changes) {
  putCloths(
      dresser_->redrape(shownClay(), shown_.followBlocks(sculptor().field(), changes.blocks)));
  heightSwitch_.draped(blocksIn(changes.blocks));
  if (!heightSwitch_.wantsCloths()) return undrape();
  tellStatus();
}

void ClayDesk::putCloths(std::vector<UnpackedPatch> patches) {
  for (UnpackedPatch& patch : patches) {
    const Key key = patch.origin;
    PatchRef& shown = out_.heights[key];
    shown = nullptr;
    if (patch.indices.empty()) continue;
    if (stiffnessTold_.any()) patch.stiffness = stiffnessOn(patch, stiffnessTold_);
    shown = std::make_shared<const ShownPatch>(std::move(patch));
    status_.lastEdit.add(shown->bounds);
  }
  bounds_.add(status_.lastEdit);
}

void ClayDesk::drape() {
  bench().letSurfaceWait();
  out_.undraped = true;
  out_.heights.clear();
  draped_ = true;
  const CellBounds edited = status_.lastEdit;
  putCloths(dresser_->drape(shownClay(), facingsFor(*eye_, bounds_)));
  status_.lastEdit = edited;
}

void ClayDesk::undrape() {
  if (!std::exchange(draped_, false)) return;
  out_.undraped = true;
  out_.heights.clear();
  bench().catchUp();
  showMesh(bench().takeChanges());
  heightSwitch_.reset();
}

}  // namespace bozzetto::ui
