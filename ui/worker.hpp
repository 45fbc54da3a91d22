// The clay's own thread: tasks in order, finished pieces handed to the window, which never waits.
#pragma once
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

#include "bozzetto/base/background.hpp"
#include "ui/clay_desk.hpp"

namespace bozzetto::ui {

/// What becomes of the document by a job.
enum class Brings { work, anotherDocument };

/// A long job as the window sees it.
class LongJob : public Progress {
 public:
  LongJob(std::string title, Brings brings) : title_(std::move(title)), brings_(brings) {}

  bool report(std::string_view what, double done) override;
  void note(std::string_view text) override;

  const std::string& title() const { return title_; }
  Brings brings() const { return brings_; }
  double done() const { return done_; }
  void cancel() { cancelled_ = true; }
  bool isCancelled() const { return cancelled_; }
  /// What came of it can be taken.
  bool isOver() const { return over_; }
  bool failed() const { return failed_; }
  std::vector<std::string> takeNotes();
  /// What went wrong beside the clay's thread, once it is over.
  const std::string& error() const { return error_; }

 private:
  friend class ClayWorker;
  std::string title_;
  Brings brings_;
  std::atomic<double> done_ = 0;
  std::atomic<bool> cancelled_ = false, over_ = false, failed_ = false;
  std::mutex mutex_;
  std::vector<std::string> notes_;
  std::string error_;
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
  std::shared_ptr<LongJob> start(std::string title, Work work, Brings brings = Brings::work);

  using Beside = std::function<void(Progress&)>;
  /// A job on a thread of its own, with a copy of what it needs, which `prepare` makes on this one.
  std::shared_ptr<LongJob> startBeside(std::string title, std::function<Beside(ClayDesk&)> prepare);

  /// Takes strokes back that are still on their way to the clay, as soon as this dab is made.
  void giveUpStrokes();

  /// What is finished since the last call; never waits for clay.
  Publication take();
  bool hasNews() const { return news_; }
  /// True until everything asked for is done and can be taken.
  bool hasTasks() const;
  /// The same, and all of it is on the disk (better light may still be on its way).
  bool isIdle() const;
  /// Waits until all is done, rest included: for tests and for the end.
  void waitUntilSettled();

 private:
  void run();
  void publish(ClayDesk& desk);
  void show(ClayDesk& desk);
  bool isTime() const;
  bool mayWait(const ClayDesk& desk) const;
  bool rest(ClayDesk& desk);
  std::optional<Task> next(const ClayDesk& desk);
  void endTask();

  std::function<void()> wake_;
  mutable std::mutex mutex_;
  std::condition_variable work_, settled_;
  std::deque<Task> tasks_;
  Publication ready_;
  std::atomic<bool> news_ = false, givenUp_ = false;
  std::shared_ptr<LongJob> job_, done_;  // the last one; the one whose end is to be told
  bool stop_ = false, working_ = false, busy_ = false, resting_ = true;
  std::vector<std::pair<std::shared_ptr<LongJob>, Background>> beside_;
  using Clock = std::chrono::steady_clock;
  Clock::time_point shown_;    // when the clay was, last
  Clock::duration between_{};  // how long the next one waits
  std::thread thread_;
};

}  // namespace bozzetto::ui
