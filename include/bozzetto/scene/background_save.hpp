// Saving while the sculptor goes on: autosaves, checkpoints, and saves of large scenes.
#pragma once
#include <atomic>
#include <memory>

#include "bozzetto/base/background.hpp"
#include "bozzetto/scene/scene_file.hpp"

namespace bozzetto {

/// Saves a copy of a document, which shares its blocks, on a thread of its own. Whoever edits the
/// document meanwhile gets new blocks and never waits. The SceneFile must outlive this and is not
/// to be used before it has finished.
class BackgroundSave {
 public:
  BackgroundSave(SceneFile& file, std::filesystem::path path, Document document);
  /// Waits; what was not asked for is not told.
  ~BackgroundSave() = default;
  BackgroundSave(const BackgroundSave&) = delete;
  BackgroundSave& operator=(const BackgroundSave&) = delete;

  bool finished() const { return job_.finished(); }
  /// 0…1
  double done() const { return watch_->done; }
  /// Asks it to stop; the old file stays. It may be too late.
  void cancel() { watch_->stop = true; }
  /// Waits for the end. Throws what the save threw: only after this has returned is the document
  /// saved.
  SaveReport result();

 private:
  struct Watch : Progress {
    bool report(std::string_view, double part) override {
      done = part;
      return !stop;
    }
    std::atomic<double> done{0};
    std::atomic<bool> stop{false};
    SaveReport saved;
  };
  std::unique_ptr<Watch> watch_;
  Background job_;
};

}  // namespace bozzetto
