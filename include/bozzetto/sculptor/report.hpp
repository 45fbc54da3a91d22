// What one operation did and cost.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "bozzetto/solid/tools.hpp"

namespace bozzetto {

/// Counts are the paper's (Ferley §3.2), summed over dabs.
struct OperationReport {
  std::string op;
  double msField = 0, msSurface = 0, msHistory = 0;
  std::int64_t dabs = 0;
  std::int64_t visited = 0, computed = 0, dirty = 0;
  std::int64_t treated = 0;              ///< cubes re-examined; 0 without surface upkeep
  double massBefore = 0, massAfter = 0;  ///< world units, from exact sums
  double massDropped = 0;                ///< let go by smoothing thin support
  std::size_t changedBlocks = 0;
  std::optional<RunReport> physics{};  ///< of tools that let a solid move
};

}  // namespace bozzetto
