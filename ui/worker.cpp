#include "ui/worker.hpp"

#include <algorithm>
#include <chrono>
#include <new>

namespace bozzetto::ui {
namespace {

constexpr auto kBetween = std::chrono::milliseconds(8);  // between dabs shown, at least
constexpr auto kLongest = std::chrono::milliseconds(60);

// Calls `work`; the text of what went wrong, or nothing.
template <class Do>
std::string errorOf(const Do& work) {
  try {
    work();
    return "";
  } catch (const Cancelled&) {
    return "";
  } catch (const std::bad_alloc&) {
    return "not enough memory";
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace

bool LongJob::report(std::string_view, double done) {
  done_ = std::clamp(done, 0.0, 1.0);
  return !cancelled_;
}

void LongJob::note(std::string_view text) {
  const std::lock_guard lock(mutex_);
  notes_.emplace_back(text);
}

std::vector<std::string> LongJob::takeNotes() {
  const std::lock_guard lock(mutex_);
  return std::exchange(notes_, {});
}

ClayWorker::ClayWorker(std::function<void()> wake)
    : wake_(std::move(wake)), thread_([this] { run(); }) {}

ClayWorker::~ClayWorker() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
    if (job_) job_->cancel();
  }
  work_.notify_one();
  thread_.join();
  for (const auto& [job, thread] : beside_) job->cancel();
}

void ClayWorker::post(Task task) {
  {
    const std::lock_guard lock(mutex_);
    tasks_.push_back(std::move(task));
  }
  work_.notify_one();
}

std::shared_ptr<LongJob> ClayWorker::start(std::string title, Work work, Brings brings) {
  auto job = std::make_shared<LongJob>(std::move(title), brings);
  {
    const std::lock_guard lock(mutex_);
    job_ = job;
  }
  post([this, job, work = std::move(work)](ClayDesk& desk) {
    const std::string error = errorOf([&] { work(desk, *job); });
    for (std::string& text : job->takeNotes()) desk.note(std::move(text));
    if (!error.empty()) desk.fail(error);
    job->failed_ = !error.empty() || job->isCancelled();
    done_ = job;
  });
  return job;
}

std::shared_ptr<LongJob> ClayWorker::startBeside(std::string title,
                                                 std::function<Beside(ClayDesk&)> prepare) {
  auto job = std::make_shared<LongJob>(std::move(title), Brings::work);
  post([this, job, prepare = std::move(prepare)](ClayDesk& desk) {
    const auto finished = [](const auto& each) { return each.second.finished(); };
    if (std::ranges::all_of(beside_, finished)) beside_.clear();
    beside_.emplace_back(job, Background([this, job, work = prepare(desk)] {
                           job->error_ = errorOf([&] { work(*job); });
                           job->failed_ = !job->error_.empty() || job->isCancelled();
                           job->over_ = true;
                           wake_();
                         }));
  });
  return job;
}

void ClayWorker::giveUpStrokes() {
  givenUp_ = true;
  post([this](ClayDesk& desk) {
    desk.cancelStroke();
    givenUp_ = false;
  });
}

Publication ClayWorker::take() {
  const std::lock_guard lock(mutex_);
  news_ = false;
  return std::exchange(ready_, {});
}

bool ClayWorker::hasTasks() const {
  const std::lock_guard lock(mutex_);
  return !tasks_.empty() || working_;
}

bool ClayWorker::isIdle() const {
  const std::lock_guard lock(mutex_);
  return tasks_.empty() && !busy_;
}

void ClayWorker::waitUntilSettled() {
  std::unique_lock lock(mutex_);
  settled_.wait(lock, [this] { return tasks_.empty() && !busy_ && resting_; });
}

void ClayWorker::publish(ClayDesk& desk) {
  Publication fresh = desk.take();
  if (fresh.empty()) return;
  {
    const std::lock_guard lock(mutex_);
    ready_.add(std::move(fresh));
    news_ = true;
  }
  wake_();
}

// What waits for a quiet moment, piece by piece while nothing is asked for. False when there is
// something to do, or all is done.
bool ClayWorker::rest(ClayDesk& desk) {
  {
    const std::lock_guard lock(mutex_);
    if (!tasks_.empty() || resting_ || stop_) return false;
  }
  const bool more = desk.settle();
  publish(desk);
  const std::lock_guard lock(mutex_);
  resting_ = !more;
  return more;
}

// The next task, an empty one when the desk wants to be looked after; nothing when it is time to
// end.
std::optional<ClayWorker::Task> ClayWorker::next(const ClayDesk& desk) {
  std::unique_lock lock(mutex_);
  busy_ = desk.isWaiting();
  if (tasks_.empty() && resting_ && !busy_) settled_.notify_all();
  const auto due = [this] { return stop_ || !tasks_.empty(); };
  if (const auto patience = desk.patience()) {
    if (!work_.wait_for(lock, *patience, due)) return Task([](ClayDesk&) {});
  } else {
    work_.wait(lock, due);
  }
  if (tasks_.empty()) return std::nullopt;
  Task task = std::move(tasks_.front());
  tasks_.pop_front();
  busy_ = working_ = true;
  resting_ = false;
  return task;
}

// After its publication: who sees the end can take what came of it.
void ClayWorker::endTask() {
  {
    const std::lock_guard lock(mutex_);
    working_ = false;
  }
  if (!done_) return;
  std::exchange(done_, nullptr)->over_ = true;
  wake_();
}

// Half the time is for dabs, however long it takes to show them: under load, or where a second
// surface follows, a stroke would lag ever more behind the hand.
void ClayWorker::show(ClayDesk& desk) {
  const Clock::time_point began = Clock::now();
  desk.showDabs();
  publish(desk);
  shown_ = Clock::now();
  between_ = std::clamp<Clock::duration>(shown_ - began, kBetween, kLongest);
}

bool ClayWorker::isTime() const { return Clock::now() - shown_ >= between_; }

// More of the stroke is on its way.
bool ClayWorker::mayWait(const ClayDesk& desk) const {
  if (done_ || !desk.inStroke() || isTime()) return false;
  const std::lock_guard lock(mutex_);
  return !tasks_.empty();
}

void ClayWorker::run() {
  ClayDesk desk;
  desk.givesUp = [this] { return givenUp_.load(); };
  publish(desk);
  while (const std::optional<Task> task = next(desk)) {
    const std::string error = errorOf([&] {
      (*task)(desk);
      while (desk.dab())
        if (isTime()) show(desk);
      if (!mayWait(desk)) show(desk);
    });
    if (!error.empty()) desk.fail(error);
    desk.lookAfter();
    if (!mayWait(desk)) publish(desk);
    endTask();
    while (rest(desk)) {
    }
  }
}

}  // namespace bozzetto::ui
