// What opening a folder finds and a History lives on.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bozzetto/history/history.hpp"
#include "history/journal.hpp"

namespace bozzetto {

/// A state that recovery can start from beside the scene's file: a checkpoint, or no clay at all.
struct Anchor {
  StepNumber state = 0;
  bool file = true;
};

template <int Side>
struct HistoryParts {
  HistoryLimits limits;
  StepTree tree;
  std::uint64_t moment = 0;
  StepNumber lastNumber = 0;  ///< ever used
  FieldScale scale;           ///< of the clay now
  Beside beside;              ///< the clay now

  // Of a folder. Without a journal steps are read from it and none is written.
  FileSystem* files = nullptr;
  std::filesystem::path folder;
  std::optional<FileLock> lock;  // given back after the journal is done
  std::unique_ptr<undo::Journal<Side>> journal;
  std::vector<Anchor> anchors;
  std::optional<StepNumber> saved;  ///< the state that the scene's file has
  std::uint64_t savedMoment = 0;
  /// Undo-files that nothing leads to; the first to go.
  std::vector<StepNumber> lostSteps;
};

}  // namespace bozzetto
