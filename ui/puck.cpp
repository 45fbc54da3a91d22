#include "ui/puck.hpp"

#include <spnav.h>

#include <algorithm>

namespace bozzetto::ui {
namespace {

constexpr double kFullDeflection = 350;  // what spacenavd tells at the device's stop
constexpr double kLongestHold = 0.1;     // seconds one event may stand for

double part(int value) { return std::clamp(value / kFullDeflection, -1.0, 1.0); }

// spacenavd counts z away from the viewer; the picture's z comes towards.
PuckMoved movedBy(const spnav_event_motion& motion) {
  PuckMoved moved;
  moved.push = {part(motion.x), part(motion.y), -part(motion.z)};
  moved.turn = {part(motion.rx), part(motion.ry), -part(motion.rz)};
  moved.seconds = std::clamp(double(motion.period) / 1000, 0.0, kLongestHold);
  return moved;
}

}  // namespace

Puck::Puck() : connected_(spnav_open() != -1) {}

Puck::~Puck() {
  if (connected_) spnav_close();
}

std::vector<InputEvent> Puck::poll() {
  std::vector<InputEvent> events;
  spnav_event event;
  while (connected_ && spnav_poll_event(&event) != 0) {
    if (event.type == SPNAV_EVENT_MOTION) events.emplace_back(movedBy(event.motion));
    if (event.type == SPNAV_EVENT_BUTTON) {
      events.emplace_back(PuckButton{event.button.bnum, event.button.press != 0});
    }
  }
  return events;
}

}  // namespace bozzetto::ui
