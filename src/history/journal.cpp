#include "history/journal.hpp"

#include <sched.h>

#include <chrono>
#include <cstdio>

namespace bozzetto::undo {
namespace {

constexpr std::uint64_t kSyncEvery = 32u << 20;  // bytes of a checkpoint
constexpr std::chrono::seconds kRetryAfter{1};

std::string numbered(StepNumber number, const char* ending) {
  char name[32];
  std::snprintf(name, sizeof name, "%010u%s", number, ending);
  return name;
}

// Whoever wakes the writer goes on at once: it is not to take the caller's core.
void neverPreempt() {
  const sched_param parameters{};
  ::sched_setscheduler(0, SCHED_BATCH, &parameters);  // of this thread; a hint that may be refused
}

}  // namespace

std::string stepFileName(StepNumber step) { return numbered(step, kStepEnding); }
std::string checkpointFileName(StepNumber state) { return numbered(state, kCheckpointEnding); }
std::string pictureFileName(StepNumber step) { return numbered(step, kPictureEnding); }

/// A checkpoint that is being written; the file goes with it unless it was finished.
template <int Side>
struct Journal<Side>::Running {
  Running(const std::filesystem::path& path, FileSystem& files, const FileHead& head,
          const KeyTree<Block>& tree, const Beside& beside)
      : file(path, files), writer(head, tree, beside), state(head.step.number) {}

  /// False when it is finished and in its place.
  bool advance() {
    const Bytes bytes = writer.next();
    if (bytes.empty()) {
      file.putInPlace();
      return false;
    }
    file.file().write(offset, bytes);
    offset += bytes.size();
    if (offset - synced < kSyncEvery) return true;
    file.file().sync();
    synced = offset;
    return true;
  }

  NewFile file;
  CheckpointWriter<Side> writer;
  StepNumber state;
  std::uint64_t offset = 0, synced = 0;
};

template <int Side>
Journal<Side>::Journal(FileSystem& files, std::filesystem::path folder, HistoryIdentity identity,
                       Start start)
    : files_(&files),
      folder_(std::move(folder)),
      identity_(identity),
      tree_(std::move(start.tree)),
      durable_(start.moment) {
  thread_ = std::thread([this] { work(); });
}

template <int Side>
Journal<Side>::~Journal() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

template <int Side>
void Journal<Side>::queue(Event event) {
  {
    const std::lock_guard lock(mutex_);
    events_.push_back(std::move(event));
    retry_ = true;
  }
  wake_.notify_all();
}

template <int Side>
void Journal<Side>::release(Change change) {
  const std::lock_guard lock(mutex_);
  released_.push_back(std::move(change));
}

template <int Side>
std::uint64_t Journal<Side>::durableMoment() const {
  const std::lock_guard lock(mutex_);
  return durable_;
}

template <int Side>
void Journal<Side>::waitDurable(std::uint64_t moment) {
  std::unique_lock lock(mutex_);
  if (durable_ >= moment) return;
  trouble_.clear();
  retry_ = true;
  wake_.notify_all();
  done_.wait(lock, [&] { return durable_ >= moment || !trouble_.empty(); });
  if (durable_ < moment) throw Error(trouble_);
}

template <int Side>
std::string Journal<Side>::trouble() const {
  const std::lock_guard lock(mutex_);
  return trouble_;
}

template <int Side>
typename Journal<Side>::News Journal<Side>::news() {
  const std::lock_guard lock(mutex_);
  return std::exchange(news_, {});
}

template <int Side>
void Journal<Side>::work() {
  neverPreempt();
  std::unique_lock lock(mutex_);
  for (;;) {
    const auto due = [&] { return stop_ || !events_.empty() || running_; };
    wake_.wait(lock, due);
    if (!events_.empty()) {
      if (!workOnce(lock)) {
        if (stop_) return;
        retry_ = false;
        wake_.wait_for(lock, kRetryAfter, [&] { return stop_ || retry_; });
      }
    } else if (stop_) {
      return;
    } else {
      lock.unlock();
      continueCheckpoint();
      lock.lock();
    }
  }
}

// Writes the first event; false when the disk does not take it.
template <int Side>
bool Journal<Side>::workOnce(std::unique_lock<std::mutex>& lock) {
  Event& event = events_.front();  // others only add at the end
  std::vector<Change> released = std::exchange(released_, {});
  lock.unlock();
  released.clear();
  std::uint64_t moment = 0;
  std::string trouble;
  try {
    moment = std::visit([&](auto& each) { return write(each); }, event);
  } catch (const std::exception& error) {
    trouble = error.what();
    if (trouble.empty()) trouble = "cannot write";
  }
  lock.lock();
  trouble_ = trouble;
  if (trouble.empty()) {
    Event done = std::move(events_.front());
    events_.pop_front();
    durable_ = std::max(durable_, moment);
    lock.unlock();
    { const Event gone = std::move(done); }
    lock.lock();
  }
  done_.notify_all();
  return trouble.empty();
}

template <int Side>
std::uint64_t Journal<Side>::write(StepEvent& event) {
  FileHead head;
  head.identity = identity_;
  head.moment = event.moment;
  head.step = event.step;
  const Change& change = event.change;
  const Bytes beside = encodeBesidePart(change.before, change.after);
  const Bytes bytes = encodeUndoFile<Side>(head, *change.clay, {event.thumbnail, beside});
  writeFile(folder_ / stepFileName(event.step.number), bytes, *files_);
  follow(change.clay);
  const std::lock_guard lock(mutex_);
  news_.written.push_back({head.step.number, head.step.changedCorners, head.step.bytes});
  return event.moment;
}

// Of moves in a row only the last is written.
template <int Side>
std::uint64_t Journal<Side>::write(MoveEvent& event) {
  {
    const std::lock_guard lock(mutex_);
    if (events_.size() > 1 && std::holds_alternative<MoveEvent>(events_[1])) {
      if (event.delta) follow(event.delta);
      return 0;
    }
  }
  const Bytes bytes = encodePlace({identity_, event.place, event.savedMoment});
  writeFile(folder_ / kPlaceFile, bytes, *files_);
  if (event.delta) follow(event.delta);
  return event.place.moment;
}

// A file that cannot be removed harms nobody.
template <int Side>
std::uint64_t Journal<Side>::write(RemoveEvent& event) {
  try {
    files_->remove(folder_ / event.name);
  } catch (const Error&) {
  }
  return 0;
}

// Nothing hangs on a picture.
template <int Side>
std::uint64_t Journal<Side>::write(PictureEvent& event) {
  try {
    writeFile(folder_ / event.name, event.png, *files_);
  } catch (const Error&) {
  }
  return 0;
}

template <int Side>
std::uint64_t Journal<Side>::write(CheckpointEvent& event) {
  if (running_) return 0;
  FileHead head;
  head.identity = identity_;
  head.moment = event.place.moment;
  head.step.number = event.place.place;
  head.step.parent = event.place.tip;
  head.step.mark = event.place.mark;
  head.step.note = {"", event.scale, event.scale};
  try {
    running_ = std::make_unique<Running>(folder_ / checkpointFileName(event.place.place), *files_,
                                         head, tree_, event.beside);
  } catch (const Error&) {
    const std::lock_guard lock(mutex_);
    news_.checkpointFailed = true;
  }
  return 0;
}

template <int Side>
void Journal<Side>::continueCheckpoint() {
  const StepNumber state = running_->state;
  bool failed = false;
  try {
    if (running_->advance()) return;
  } catch (const std::exception&) {
    failed = true;
  }
  endCheckpoint();
  const std::lock_guard lock(mutex_);
  news_.checkpointFailed = failed;
  if (!failed) news_.checkpoint = state;
}

template <int Side>
void Journal<Side>::endCheckpoint() {
  running_.reset();
  for (const DeltaPointer& delta : std::exchange(following_, {})) follow(delta);
}

// Keeps the duplicate up to date; while it is being written it waits.
template <int Side>
void Journal<Side>::follow(const DeltaPointer& delta) {
  if (running_) {
    following_.push_back(delta);
  } else {
    delta->apply(tree_, Direction::forward);
  }
}

template class Journal<1>;
template class Journal<8>;

}  // namespace bozzetto::undo
