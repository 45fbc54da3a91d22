// The deformable solid on the desk, as the window shows it.
#include "ui/clay_desk.hpp"

namespace bozzetto::ui {

void ClayDesk::showSolid(const SolidWish& wish) {
  solidWish_ = wish;
  solidTold_ = nullptr;
  tellSolid(bench().solid());
}

// With the next publication, when it is another one.
void ClayDesk::tellSolid(const SolidRef& solid) {
  const double spacing = bench().field().scale.spacing;
  if (solid == solidTold_ && spacing == solidSpacing_) return;
  solidSpacing_ = spacing;
  out_.solid = solid ? shownSolid(solid, solidWish_.map, spacing, solidWish_.colour) : nullptr;
  solidTold_ = solid;
}

// What an operation of a drag would do, without doing it.
void ClayDesk::previewSolid(const Operation& drag) {
  constexpr int kQuickSteps = 6;  // of physics: the hand waits for them
  if (bench().solid() == nullptr) return;
  Solid solid = *bench().solid();
  if (const auto* move = std::get_if<SolidMoveOperation>(&drag)) {
    solid.control.points.at(std::get<Id>(move->point)) += move->by;
  } else if (const auto* pull = std::get_if<SolidPullOperation>(&drag)) {
    solid =
        pulled(solid, pull->ropes, solid.settings.ropeStrength, std::min(pull->steps, kQuickSteps));
  }
  tellSolid(std::make_shared<const Solid>(std::move(solid)));
}

}  // namespace bozzetto::ui
