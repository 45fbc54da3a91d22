// The same clay on a finer or coarser grid, in the same world place: corner n lies at n · spacing.
#pragma once
#include <cstddef>
#include <cstdint>

#include "bozzetto/base/progress.hpp"
#include "bozzetto/field/field.hpp"

namespace bozzetto {

struct ResamplePrediction {
  std::int64_t corners = 0;  ///< with clay
  std::size_t bytes = 0;     ///< of nodes and blocks
};

struct ResampleOptions {
  /// A result predicted to need more memory than this is refused before any work.
  std::size_t memoryLimit = std::size_t{8} << 30;
};

/// What a resampled field would be, within 20 % for solids larger than a few blocks: a sample of
/// block columns is worked out and counted up. Some tens of milliseconds. Throws Error as resample
/// does for a bad spacing.
ResamplePrediction predictResample(const Clay& field, double spacing);

/// The field at another spacing (world units, > 0). Finer: trilinear. Coarser: a tent filter as
/// wide as the new cells, so that nothing aliases and mass stays within 1 % for shapes thicker than
/// some new cells. Linear slopes stay exact; values never leave the range of their sources; values
/// below 1e-4 are dropped. Colours are means weighted by density, hold is the nearest corner's. The
/// same spacing gives the same field, blocks shared. O(blocks near the surface + runs) of both
/// fields, in parallel; the same bits for any number of threads. Throws Error for a bad spacing,
/// for clay that would leave the workspace, and beyond the memory limit; Cancelled when told to.
Clay resample(const Clay& field, double spacing, const ResampleOptions& options = {},
              Progress& progress = Progress::none());

}  // namespace bozzetto
