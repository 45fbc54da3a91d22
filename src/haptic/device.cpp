#include "bozzetto/haptic/device.hpp"

#include <algorithm>
#include <cmath>

namespace bozzetto::haptic {

ScriptedDevice::ScriptedDevice(std::vector<Knot> path, std::size_t room) : path_(std::move(path)) {
  forces_.reserve(room);
}

DeviceState ScriptedDevice::read(double time) {
  if (path_.empty()) return {};
  const auto after = std::ranges::upper_bound(path_, time, {}, &Knot::time);
  if (after == path_.begin()) return path_.front().state;
  if (after == path_.end()) return path_.back().state;
  const Knot &a = *(after - 1), &b = *after;
  const double t = (time - a.time) / (b.time - a.time);
  return {(1 - t) * a.state.position + t * b.state.position, a.state.button};
}

void ScriptedDevice::push(const glm::dvec3& force, double) {
  if (forces_.size() < forces_.capacity()) forces_.push_back(force);
}

void MouseDevice::place(const DeviceState& state) {
  x_ = state.position.x, y_ = state.position.y, z_ = state.position.z;
  button_ = state.button;
}

glm::dvec3 MouseDevice::force() const { return {fx_.load(), fy_.load(), fz_.load()}; }

DeviceState MouseDevice::read(double time) {
  const glm::dvec3 wanted = glm::dvec3(x_.load(), y_.load(), z_.load()) + give_ * force();
  const double passed = readAt_ ? time - *readAt_ : 0;
  at_ = readAt_ && lag_ > 0 ? at_ + (wanted - at_) * (passed / (lag_ + passed)) : wanted;
  readAt_ = time;
  return {at_, button_.load()};
}

void MouseDevice::push(const glm::dvec3& force, double) {
  fx_ = force.x, fy_ = force.y, fz_ = force.z;
}

void HandDevice::push(const glm::dvec3& force, double seconds) {
  constexpr double inner = 1e-4;
  const int steps = std::max(1, static_cast<int>(std::lround(seconds / inner)));
  const double h = seconds / steps;
  for (int step = 0; step < steps; ++step) {
    const glm::dvec3 hand =
        options_.handStiffness * (wanted_ - position_) - options_.handDamping * velocity_;
    velocity_ += h / options_.mass * (force + hand - options_.damping * velocity_);
    position_ += h * velocity_;
  }
}

}  // namespace bozzetto::haptic
