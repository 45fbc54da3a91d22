// What a long job tells while it runs, and how it is told to stop.
#pragma once
#include <string_view>

#include "bozzetto/base/error.hpp"

namespace bozzetto {

/// Receives progress; the default listens to nothing and never stops a job. Calls come from the
/// thread that started the job. `report` returns false to ask the job to stop.
class Progress {
 public:
  virtual ~Progress() = default;
  /// `done` in 0…1 of the step named `what`.
  virtual bool report([[maybe_unused]] std::string_view what, [[maybe_unused]] double done) {
    return true;
  }

  /// Something people should know before or while the job runs: a prediction, an adjustment.
  virtual void note([[maybe_unused]] std::string_view text) {}

  /// Reports and throws Cancelled when asked to stop.
  void step(std::string_view what, double done) {
    if (!report(what, done)) throw Cancelled();
  }

  /// One that listens to nothing.
  static Progress& none() {
    static Progress silent;
    return silent;
  }
};

}  // namespace bozzetto
