// A null window with its shelf open and a library of its own.
#pragma once
#include <cmath>
#include <cstdlib>

#include "bozzetto/sculptor/shelf_tool.hpp"
#include "ui/null_window.hpp"

namespace bozzetto::ui {

class Shelf : public Null {
 protected:
  Shelf() {
    ::setenv("XDG_DATA_HOME", folder_.path().c_str(), 1);
    tap(letter('Q'));
    settle();
  }

  const ShelfCard* card(const std::string& name) {
    for (const ShelfCard& each : atelier_.shelf.cards)
      if (each.entry.name == name) return &each;
    return nullptr;
  }
  void take(const std::string& name) {
    ASSERT_NE(card(name), nullptr) << name;
    atelier_.takeTool(card(name)->entry);
    settle();
  }
  // A lasso round the middle of the view, a third as high as it.
  void circle() {
    tapCtrl(letter('L'));
    settle();
    const double radius = atelier_.extent().height / 6;
    const auto at = [&](int n) {
      const double turn = 6.283185307179586 * n / 24;
      return middle() + radius * glm::dvec2(std::cos(turn), std::sin(turn));
    };
    moveTo(at(0));
    settle();
    post(ButtonChanged{Button::left, true});
    for (int n = 1; n < 24; ++n) moveTo(at(n));
    post(ButtonChanged{Button::left, false});
    settle();
  }
  // Of the first card.
  glm::dvec2 firstCard() const { return interface_.layout().drawer.low + glm::dvec2(44, 170); }

  const testing::Folder folder_;
};

}  // namespace bozzetto::ui
