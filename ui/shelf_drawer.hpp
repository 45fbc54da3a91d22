// The drawer with shelves: what it shows and what is being typed into it. Values only.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ui/freeform.hpp"

namespace bozzetto::ui {

struct ShelfDrawer {
  /// What is asked for at the bottom.
  enum class Form { none, keep, replace, replaceMine, nameMine, letters, rename, remove };
  enum class Part { allClay, insideBox, insideLasso, toolInHand };

  bool open = false;
  std::vector<ShelfCard> cards;
  std::string query;
  std::optional<ToolEntry::Place> place;  ///< none: all

  Form form = Form::none;
  bool formOpened = false;         ///< it wants the keyboard
  std::optional<ToolEntry> about;  ///< whom replace, rename, remove and share are about
  std::string name, tags, text;
  Part part = Part::allClay;
  bool patch = false;  ///< of that, what stands on a plane
  double letterSize = 16, letterDepth = 4;

  bool shows(const ShelfCard& card) const {
    return (!place || *place == card.entry.place) && matches(card.entry, query);
  }
};

/// Words separated by commas or spaces.
std::vector<std::string> tagsOf(const std::string& text);
/// The card of that name, the scene's own before others; null when there is none.
const ShelfCard* cardNamed(const std::vector<ShelfCard>& cards, const std::string& name);
/// "shape" or, where cards have that, "shape 2", "shape 3" …
std::string freeName(const std::vector<ShelfCard>& cards, const std::string& wanted);

}  // namespace bozzetto::ui
