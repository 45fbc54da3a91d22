// One job on a thread of its own: what may take its time while somebody goes on working.
#pragma once
#include <functional>
#include <memory>

namespace bozzetto {

/// Starts with the object, which waits for its end. The job may use parallelFor.
class Background {
 public:
  explicit Background(std::function<void()> job);
  ~Background();
  Background(Background&&) noexcept;
  Background& operator=(Background&&) = delete;

  /// Never waits.
  bool finished() const;
  /// Returns when the job has; throws what it threw.
  void wait();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bozzetto
