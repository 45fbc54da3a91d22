#include "bozzetto/haptic/loop.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace bozzetto::haptic {

void Coupling::see(const Scene& scene, double time) {
  if (scene.grabbed) {
    grabbed_.arrive(scene.grabbedPoint, time);
  } else {
    grabbed_.letGo();
  }
}

glm::dvec3 Coupling::force(const Scene& scene, const glm::dvec3& device, double time) {
  glm::dvec3 sum(0);
  if (scene.grabbed && grabbed_.grabbed())
    sum += ropeForce(device, grabbed_.at(time), scene.ropeStiffness, scene.limits);
  if (scene.surfaceStiffness > 0)
    sum += proxy_.touch(scene.surface, device, scene.surfaceStiffness, scene.limits).force;
  return limited(sum, scene.limits.force);
}

void TickHistogram::count(std::array<std::uint64_t, 32>& slots, double seconds) {
  const double micros = std::max(1.0, seconds * 1e6);
  ++slots[static_cast<std::size_t>(std::min(31.0, std::floor(std::log2(micros))))];
}

double TickHistogram::quantile(const std::array<std::uint64_t, 32>& slots, double part) {
  double all = 0, below = 0;
  for (const auto slot : slots) all += double(slot);
  for (std::size_t n = 0; n < slots.size(); ++n) {
    below += double(slots[n]);
    if (below >= part * all) return std::exp2(double(n + 1)) * 1e-6;
  }
  return 0;
}

Loop::Loop(Device& device, double seconds)
    : device_(device), seconds_(seconds), thread_([this] { run(); }) {}

Loop::~Loop() { stop(); }

void Loop::stop() {
  stop_ = true;
  if (thread_.joinable()) thread_.join();
}

void Loop::run() {
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point then) {
    return std::chrono::duration<double>(Clock::now() - then).count();
  };
  const auto start = Clock::now();
  Coupling coupling;
  for (std::uint64_t tick = 0; !stop_; ++tick) {
    const double due = double(tick) * seconds_;
    const auto dueTime =
        start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(due));
    std::this_thread::sleep_until(dueTime);
    const auto begin = Clock::now();
    histogram_.count(histogram_.late, std::chrono::duration<double>(begin - dueTime).count());

    if (scene_.update()) coupling.see(scene_.newest(), due);
    const DeviceState state = device_.read(due);
    const glm::dvec3 force = coupling.force(scene_.newest(), state.position, due);
    device_.push(force, seconds_);
    felt_.draft() = {state.position, force, state.button};
    felt_.publish();
    histogram_.count(histogram_.work, since(begin));
  }
}

}  // namespace bozzetto::haptic
