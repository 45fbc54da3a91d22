// The writer: one thread that puts what happens to a history on the disk, in order, and says how
// far it has come. Handing over costs pointers.
#pragma once
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "bozzetto/base/file.hpp"
#include "history/place_file.hpp"
#include "history/step_change.hpp"
#include "history/undo_file.hpp"

namespace bozzetto::undo {

std::string stepFileName(StepNumber step);
std::string checkpointFileName(StepNumber state);
std::string pictureFileName(StepNumber step);
inline constexpr const char* kPlaceFile = "place";
inline constexpr const char* kLockFile = "lock";
inline constexpr const char* kStepEnding = ".undo";
inline constexpr const char* kCheckpointEnding = ".checkpoint";
inline constexpr const char* kPictureEnding = ".png";

template <int Side>
class Journal {
 public:
  using Block = CornerBlock<Side>;
  using Change = StepChange<Side>;
  using DeltaPointer = typename Change::DeltaPointer;

  struct StepEvent {
    std::uint64_t moment;
    Step step;
    Change change;
    Bytes thumbnail;
  };
  struct MoveEvent {
    HistoryPlace place;
    std::uint64_t savedMoment;
    DeltaPointer delta;  ///< from where we were; null for none
  };
  struct RemoveEvent {
    std::string name;
  };
  struct PictureEvent {
    std::string name;
    Bytes png;
  };
  /// Of all events before it.
  struct CheckpointEvent {
    HistoryPlace place;
    FieldScale scale;
    Beside beside;
  };

  /// What has come of events, since it was asked last.
  struct News {
    struct Written {
      StepNumber step;
      std::uint64_t corners, bytes;
    };
    std::vector<Written> written;
    std::optional<StepNumber> checkpoint;  ///< one is there now
    bool checkpointFailed = false;
  };

  struct Start {
    KeyTree<Block> tree;   ///< the clay as of now; a duplicate is kept for checkpoints
    std::uint64_t moment;  ///< of the last event that the folder has
  };
  Journal(FileSystem& files, std::filesystem::path folder, HistoryIdentity identity, Start start);
  /// Writes what is waiting, if the disk lets it.
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  void add(StepEvent event) { queue(std::move(event)); }
  void add(MoveEvent event) { queue(std::move(event)); }
  void remove(std::string name) { queue(RemoveEvent{std::move(name)}); }
  void add(PictureEvent event) { queue(std::move(event)); }
  void add(CheckpointEvent event) { queue(std::move(event)); }
  /// Lets go of blocks on the writer's thread.
  void release(Change change);

  /// Everything up to this moment is on the disk, synced.
  std::uint64_t durableMoment() const;
  /// Returns when `moment` is durable. Throws Error when the disk does not take it.
  void waitDurable(std::uint64_t moment);
  /// Why the disk does not take what waits; empty when all is well. Tried again with every event.
  std::string trouble() const;
  News news();

 private:
  using Event = std::variant<StepEvent, MoveEvent, RemoveEvent, PictureEvent, CheckpointEvent>;
  struct Running;

  void queue(Event event);
  void work();
  bool workOnce(std::unique_lock<std::mutex>& lock);
  std::uint64_t write(StepEvent& event);
  std::uint64_t write(MoveEvent& event);
  std::uint64_t write(RemoveEvent& event);
  std::uint64_t write(PictureEvent& event);
  std::uint64_t write(CheckpointEvent& event);
  void continueCheckpoint();
  void endCheckpoint();
  void follow(const DeltaPointer& delta);

  FileSystem* files_;
  std::filesystem::path folder_;
  HistoryIdentity identity_;

  // The thread's own.
  KeyTree<Block> tree_;                  // the clay as of the last written event
  std::vector<DeltaPointer> following_;  // what came since the running checkpoint began
  std::unique_ptr<Running> running_;

  mutable std::mutex mutex_;
  std::condition_variable wake_, done_;
  std::deque<Event> events_;
  std::vector<Change> released_;
  News news_;
  std::uint64_t durable_ = 0;
  std::string trouble_;
  bool retry_ = false, stop_ = false;
  std::thread thread_;
};

}  // namespace bozzetto::undo
