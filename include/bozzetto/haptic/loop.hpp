// The haptic loop: a thousand times a second, without lock, allocation or solver. The clay's thread
// and the loop hand each other values through buffers that neither waits for (McDonnell & Qin
// §6.1).
#pragma once
#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

#include "bozzetto/haptic/device.hpp"
#include "bozzetto/haptic/force.hpp"

namespace bozzetto::haptic {

/// One writer, one reader, three slots: the newest value is always to be had, nobody waits.
template <class Value>
class Exchange {
 public:
  /// The slot to fill, then `publish`.
  Value& draft() { return slots_[writing_]; }
  void publish() {
    writing_ = middle_.exchange(writing_ | kFresh, std::memory_order_acq_rel) & kIndex;
  }
  /// True when something newer has come; `newest` is it.
  bool update() {
    if ((middle_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
    reading_ = middle_.exchange(reading_, std::memory_order_acq_rel) & kIndex;
    return true;
  }
  const Value& newest() const { return slots_[reading_]; }

 private:
  static constexpr unsigned kFresh = 4, kIndex = 3;
  std::array<Value, 3> slots_{};
  unsigned writing_ = 0, reading_ = 1;
  std::atomic<unsigned> middle_{2};
};

/// What the clay's thread tells after each step.
struct Scene {
  bool grabbed = false;
  glm::dvec3 grabbedPoint{0};
  double ropeStiffness = 0;     ///< N/m
  double surfaceStiffness = 0;  ///< N/m; 0 = the surface is not felt
  std::vector<TouchTriangle> surface;
  ForceLimits limits;
};

/// What the loop tells.
struct Felt {
  glm::dvec3 position{0}, force{0};
  bool button = false;
};

/// One tick: what a device at this place feels at this time. Deterministic; no allocation.
class Coupling {
 public:
  /// A newer scene, at the time it came.
  void see(const Scene& scene, double time);
  glm::dvec3 force(const Scene& scene, const glm::dvec3& device, double time);

 private:
  GrabbedPoint grabbed_;
  SurfaceProxy proxy_;
};

/// How long the ticks took and how late they came, in microseconds by powers of two: slot n counts
/// [2ⁿ, 2ⁿ⁺¹).
struct TickHistogram {
  std::array<std::uint64_t, 32> work{}, late{};
  void count(std::array<std::uint64_t, 32>& slots, double seconds);
  /// Upper end of the slot below which this part of all ticks lies, in seconds.
  static double quantile(const std::array<std::uint64_t, 32>& slots, double part);
};

/// Runs a device in a thread of its own from construction to destruction.
class Loop {
 public:
  explicit Loop(Device& device, double seconds = 1e-3);
  ~Loop();
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  Exchange<Scene>& scene() { return scene_; }  ///< the clay's thread drafts and publishes
  Exchange<Felt>& felt() { return felt_; }     ///< the clay's thread updates and reads
  /// Stops the thread; the histogram may be read afterwards.
  void stop();
  const TickHistogram& histogram() const { return histogram_; }

 private:
  void run();

  Device& device_;
  double seconds_;
  Exchange<Scene> scene_;
  Exchange<Felt> felt_;
  TickHistogram histogram_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace bozzetto::haptic
