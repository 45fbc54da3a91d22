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
  solidTold_ = solid;
  out_.solid = nullptr;
  poseClay(solid);
  if (!solid) return;
  auto shown = std::make_shared<SolidShown>(
      *shownSolid(solid, {solidWish_.map, solidWish_.colour, spacing}));
  shown->ran = solidRan_;
  out_.solid = std::move(shown);
}

// The clay as a posed wrap would carry it; its own surface again when there is none.
void ClayDesk::poseClay(const SolidRef& solid) {
  const bool poses = solidWish_.wrap == WrapShown::asPosed && solid && solid->isWrap() &&
                     solid->control.points != solid->wrapRest;
  if (!poses && !posed_) return;
  const double spacing = bench().field().scale.spacing;
  if (poses) {
    if (!posed_ || !posed_->isOf(*solid, spacing))
      posed_ = std::make_unique<PosedClay>(*solid, spacing);
    posed_->pose(solid->control.points);
  } else {
    posed_.reset();
  }
  for (const auto& [key, patch] : fine_) out_.fine[key] = patch;
  for (const auto& [key, patch] : coarse_) out_.coarse[key] = patch;
}

void ClayDesk::touchSolid(const glm::dvec3& at, double radius) {
  if (bench().solid()) out_.touched = probedStiffness(*bench().solid(), at, radius);
}

// What an operation of a drag would do, without doing it; physics as long as the hand has patience.
void ClayDesk::previewSolid(const Operation& drag) {
  constexpr int kFewSteps = 6;      // until it is known what a step takes
  constexpr double kPatience = 25;  // milliseconds
  if (bench().solid() == nullptr) return;
  const Solid& now = *bench().solid();
  const auto steps = [&](int wanted) {
    const double step = solidRan_ ? solidRan_->msStep : 0;
    return std::min(wanted, step > 0 ? std::max(1, int(kPatience / step)) : kFewSteps);
  };
  Solid solid;
  RunReport ran;
  if (const auto* move = std::get_if<SolidMoveOperation>(&drag)) {
    solid = now;
    solid.control.points.at(std::get<Id>(move->point)) += move->by;
  } else if (const auto* pull = std::get_if<SolidPullOperation>(&drag)) {
    solid = pulled(now, pull->ropes, now.settings.ropeStrength, steps(pull->steps), &ran);
  } else if (const auto* bend = std::get_if<SolidSplineOperation>(&drag)) {
    solid = splined(now, bend->points, bend->drags, steps(bend->steps), &ran);
  } else {
    return;
  }
  if (ran.steps > 0) solidRan_ = ran;
  tellSolid(std::make_shared<const Solid>(std::move(solid)));
}

}  // namespace bozzetto::ui
