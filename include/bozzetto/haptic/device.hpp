// Devices with a position and, some of them, a force that can be felt. Real ones and simulated ones
// look alike to the loop (McDonnell & Qin §6.1, solid.md §4). Metres, seconds, newtons.
#pragma once
#include <atomic>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

namespace bozzetto::haptic {

struct DeviceState {
  glm::dvec3 position{0};
  bool button = false;
};

/// Called once a millisecond from the haptic thread: no lock, no allocation, no waiting.
class Device {
 public:
  virtual ~Device() = default;
  virtual DeviceState read(double time) = 0;
  virtual void push(const glm::dvec3& force, double seconds) = 0;
};

/// Rests at the origin and feels nothing.
class NullDevice : public Device {
 public:
  DeviceState read(double) override { return {}; }
  void push(const glm::dvec3&, double) override {}
};

/// Follows a written path, linearly between its places; keeps the forces it was given.
class ScriptedDevice : public Device {
 public:
  struct Knot {
    double time;
    DeviceState state;
  };
  /// `room`: how many forces can be kept; later ones are dropped.
  ScriptedDevice(std::vector<Knot> path, std::size_t room);
  DeviceState read(double time) override;
  void push(const glm::dvec3& force, double seconds) override;
  std::span<const glm::dvec3> forces() const { return forces_; }

 private:
  std::vector<Knot> path_;
  std::vector<glm::dvec3> forces_;
};

/// Placed by a mouse or pen in another thread. What is felt shows as a lag: the position gives way
/// to the force by `give` metres a newton, and follows within `lag` seconds, like a mass held by a
/// hand: that keeps springs stiffer than 1/give stable (up to 2·lag/tick/give).
class MouseDevice : public Device {
 public:
  explicit MouseDevice(double give, double lag = 0) : give_(give), lag_(lag) {}
  void place(const DeviceState& state);  ///< from the window's thread
  glm::dvec3 force() const;              ///< for the window's arrow
  DeviceState read(double time) override;
  void push(const glm::dvec3& force, double seconds) override;

 private:
  std::atomic<double> x_{0}, y_{0}, z_{0}, fx_{0}, fy_{0}, fz_{0};
  std::atomic<bool> button_{false};
  double give_, lag_;
  glm::dvec3 at_{0};  // of the loop's thread, as is when it was read
  std::optional<double> readAt_;
};

struct HandOptions {
  double mass = 0.06;        ///< of the device, kg
  double damping = 0.5;      ///< of the device, N·s/m
  double handStiffness = 0;  ///< of the hand that holds it, N/m; 0 = nobody
  double handDamping = 0;    ///< N·s/m
};

/// A mass with damping, held by a hand that wants to be elsewhere; fixed inner step of 0.1 ms.
class HandDevice : public Device {
 public:
  explicit HandDevice(const HandOptions& options, const glm::dvec3& start = glm::dvec3(0))
      : options_(options), position_(start), wanted_(start) {}
  void reachFor(const glm::dvec3& place) { wanted_ = place; }
  void kick(const glm::dvec3& velocity) { velocity_ = velocity; }
  DeviceState read(double) override { return {position_, true}; }
  void push(const glm::dvec3& force, double seconds) override;
  const glm::dvec3& velocity() const { return velocity_; }

 private:
  HandOptions options_;
  glm::dvec3 position_, wanted_, velocity_{0};
};

}  // namespace bozzetto::haptic
