// One pass of resampling by a ratio in (0, 2], column by column.
#pragma once
#include <vector>

#include "bozzetto/field/field.hpp"
#include "field/resample_kernel.hpp"

namespace bozzetto {

struct ResamplePass {
  double ratio;     ///< old cells per new cell
  float dropBelow;  ///< smaller values are dropped
};

struct ResampledRun {
  KeyRun run;
  Ref<CornerBlock<8>> block;
};

/// The runs of new blocks that can hold clay, sorted, one column after the other. Throws Error when
/// they would leave the workspace.
std::vector<KeyRun> resampledKeys(const Clay& field, double ratio);

/// The new blocks of one such run; runs longer than 1 are interned. Thread-safe.
std::vector<ResampledRun> resampleRun(const Clay& field, const KeyRun& run,
                                      const ResamplePass& pass);

}  // namespace bozzetto
