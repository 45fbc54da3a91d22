// Replaying a recording from start to end, on its own grid or another.
#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "bozzetto/sculptor/recording.hpp"
#include "bozzetto/sculptor/sculptor.hpp"

namespace bozzetto {

struct ReplayOptions {
  SurfaceUpkeep upkeep = SurfaceUpkeep::none;
  /// World units per cell in place of what the recording (or the clay it starts on) says. The clay
  /// is resampled first; later resample operations are scaled by the same factor.
  std::optional<double> spacing;
  SolidRef solid;                         ///< of the document it starts on
  std::vector<ShelfItem> shelf{};         ///< of the document
  std::vector<clay::Support> supports{};  ///< of the document
  clay::Stiffness stiffness{};            ///< of the document
  clay::Settings settings{};              ///< of the document
  MassLedger ledger{};                    ///< of the document
  int depth = 0;                          ///< of recordings that make tools for recordings
};

struct ReplayResult {
  Clay field;
  SolidRef solid;                        ///< null when there is none
  std::vector<ShelfItem> shelf;          ///< of the document
  std::vector<clay::Support> supports;   ///< of the document
  clay::Stiffness stiffness;             ///< of the document
  clay::Settings settings;               ///< of the document
  MassLedger ledger;                     ///< of the document
  std::vector<OperationReport> reports;  ///< one an operation
};

/// Notes that a recording was made on other clay. Throws Error where there is none.
void requireStart(const Recording& recording, const Clay& clay,
                  Progress& progress = Progress::none());

/// Requires its start. Throws Error naming the operation (counted from 1) that cannot be done.
ReplayResult replay(const Recording& recording, const Clay& from, const ReplayOptions& options = {},
                    Progress& progress = Progress::none());

/// The same on a sculptor that is there already; `done` is called after each operation with its
/// number.
std::vector<OperationReport> replay(const Recording& recording, Sculptor& sculptor,
                                    Progress& progress = Progress::none(),
                                    const std::function<void(std::size_t)>& done = {});

/// Sums of counts and times; mass before the first and after the last.
OperationReport totalOf(const std::vector<OperationReport>& reports);

}  // namespace bozzetto
