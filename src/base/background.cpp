#include "bozzetto/base/background.hpp"

#include <atomic>
#include <exception>
#include <thread>
#include <utility>

namespace bozzetto {

struct Background::State {
  std::function<void()> job;
  std::exception_ptr failure;
  std::atomic<bool> finished{false};
  std::thread thread;

  void run() noexcept {
    try {
      job();
    } catch (...) {
      failure = std::current_exception();
    }
    job = nullptr;  // lets go of what the job held
    finished = true;
  }
};

Background::Background(std::function<void()> job) : state_(std::make_unique<State>()) {
  state_->job = std::move(job);
  state_->thread = std::thread([state = state_.get()] { state->run(); });
}

Background::Background(Background&&) noexcept = default;

Background::~Background() {
  if (state_ && state_->thread.joinable()) state_->thread.join();
}

bool Background::finished() const { return state_->finished; }

void Background::wait() {
  if (state_->thread.joinable()) state_->thread.join();
  if (state_->failure) std::rethrow_exception(std::exchange(state_->failure, nullptr));
}

}  // namespace bozzetto
