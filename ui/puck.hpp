// A SpaceMouse through spacenavd, whatever socket it listens on (environment SPNAV_SOCKET).
#pragma once
#include <vector>

#include "ui/events.hpp"

namespace bozzetto::ui {

class Puck {
 public:
  /// Without a daemon there is no puck, and nothing is wrong.
  Puck();
  ~Puck();
  Puck(const Puck&) = delete;
  Puck& operator=(const Puck&) = delete;

  bool isThere() const { return connected_; }
  /// What it did since the last call; pushes that follow each other are told one by one.
  std::vector<InputEvent> poll();

 private:
  bool connected_ = false;
};

}  // namespace bozzetto::ui
