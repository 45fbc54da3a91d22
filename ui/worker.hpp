// The clay's own thread: tasks in order, finished pieces handed to the window, which never waits.
#pragma once
#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

#include "ui/clay_desk.hpp"

namespace bozzetto::ui {

/// A long job as the window sees it.
class LongJob : public Progress {
 public:
  explicit LongJob(std::string title) : title_(std::move(title)) {}

  bool report(std::string_view what, double done) override;
  void note(std::string_view text) override;

  const std::string& title() const { return title_; }
  double done() const { return done_; }
  void cancel() { cancelled_ = true; }
  bool isCancelled() const { return cancelled_; }
  bool isOver() const { return over_; }
  bool failed() const { return failed_; }
  std::vector<std::string> takeNotes();

 private:
  friend class ClayWorker;
  std::string title_;
  std::atomic<double> done_ = 0;
  std::atomic<bool> cancelled_ = false, over_ = false, failed_ = false;
  std::mutex mutex_;
  std::vector<std::string> notes_;
};

class ClayWorker {
 public:
  using Task = std::function<void(ClayDesk&)>;
  using Work = std::function<void(ClayDesk&, Progress&)>;

  /// `wake` is called from the worker's thread when there is something to take.
  explicit ClayWorker(std::function<void()> wake);
  /// Finishes what was asked for, but cancels long jobs.
  ~ClayWorker();
  ClayWorker(const ClayWorker&) = delete;
  ClayWorker& operator=(const ClayWorker&) = delete;

  /// Done in order. An Error becomes one of the publication's errors.
  void post(Task task);
  /// A job that may take long; told through what is returned.
  std::shared_ptr<LongJob> start(std::string title, Work work);

  /// Takes strokes back that are still on their way to the clay, as soon as this dab is made.
  void giveUpStrokes();

  /// What is finished since the last call; never waits for clay.
  Publication take();
  bool hasNews() const { return news_; }
  /// True when everything asked for is done (better light may still be on its way).
  bool isIdle() const;
  /// Waits until all is done, rest included: for tests and for the end.
  void waitUntilSettled();

 private:
  void run();
  void publish(ClayDesk& desk);
  bool rest(ClayDesk& desk);
  std::optional<Task> next(const ClayDesk& desk);

  std::function<void()> wake_;
  mutable std::mutex mutex_;
  std::condition_variable work_, settled_;
  std::deque<Task> tasks_;
  Publication ready_;
  std::atomic<bool> news_ = false, givenUp_ = false;
  std::shared_ptr<LongJob> job_;
  bool stop_ = false, busy_ = false, resting_ = true;
  std::thread thread_;
};

}  // namespace bozzetto::ui
