// Pen pressure, which GLFW does not tell: a second connection to the X server that listens to the
// pen's own device. (Listening to all devices would take GLFW's events away.)
#pragma once
#include <memory>
#include <vector>

#include "ui/events.hpp"

namespace bozzetto::ui {

class Pen {
 public:
  /// Listens on this X window. Without a pen, or without X, there is nothing to tell.
  explicit Pen(unsigned long window);
  ~Pen();
  Pen(const Pen&) = delete;
  Pen& operator=(const Pen&) = delete;

  /// How many devices with pressure there are. They may come and go.
  int devices() const;
  /// `sent`: also what the X server has not delivered yet, for a round trip to it.
  enum class Reach { delivered, sent };
  /// The pen's moves since the last call, with pressure, in window pixels.
  std::vector<PointerMoved> poll(Reach reach = Reach::delivered);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace bozzetto::ui
