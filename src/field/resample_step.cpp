#include "field/resample_step.hpp"

#include <cmath>

#include "bozzetto/base/error.hpp"
#include "field/column_sweep.hpp"

namespace bozzetto {
namespace {

constexpr int kSide = 8;

struct BlockRange {
  std::int32_t low, high;
};

// New blocks with a corner within reach of old blocks `low` … `high` along one axis.
BlockRange reached(std::int32_t low, std::int32_t high, double ratio) {
  const double reach = std::max(1.0, ratio);
  const double first = std::ceil((double{kSide} * low - reach) / ratio);
  const double last = std::floor((double{kSide} * high + kSide - 1 + reach) / ratio);
  if (first < -kWorkspaceRim || last > kWorkspaceRim) {
    throw Error("the resampled clay would leave the workspace of ±2^30 cells");
  }
  return {static_cast<std::int32_t>(first) >> 3, static_cast<std::int32_t>(last) >> 3};
}

// The last block in [from, end) whose source window still lies below old block `steady`; `from`
// when none does.
std::int32_t lastSteady(std::int32_t from, std::int32_t end, std::int32_t steady, double ratio) {
  std::int32_t good = from, bad = end;
  while (bad - good > 1) {
    const std::int32_t middle = good + (bad - good) / 2;
    (firstSourceBlock(middle, ratio) <= steady - 4 ? good : bad) = middle;
  }
  return good;
}

void append(std::vector<ResampledRun>& made, const KeyRun& run, const Ref<CornerBlock<8>>& block) {
  if (!block) return;
  if (!block->interned) {
    made.push_back({{run.key, 1}, block});
    for (std::int32_t n = 1; n < run.length; ++n) {
      made.push_back({{run.key + Key{0, 0, n}, 1}, Ref(new CornerBlock<8>(*block))});
    }
    return;
  }
  const bool goesOn = !made.empty() && made.back().block == block &&
                      made.back().run.key + Key{0, 0, made.back().run.length} == run.key;
  if (goesOn) made.back().run.length += run.length;
  if (!goesOn) made.push_back({run, block});
}

}  // namespace

std::vector<KeyRun> resampledKeys(const Clay& field, double ratio) {
  std::vector<KeyRun> old;
  old.reserve(field.tree.nodeCount());
  for (const auto& [key, run] : field.tree) old.push_back({key, run.length});
  std::vector<KeyRun> keys;
  for (const KeyRun& run : merged(std::move(old))) {
    const BlockRange i = reached(run.key.i, run.key.i, ratio);
    const BlockRange j = reached(run.key.j, run.key.j, ratio);
    const BlockRange k = reached(run.key.k, run.key.k + run.length - 1, ratio);
    for (std::int32_t ni = i.low; ni <= i.high; ++ni) {
      for (std::int32_t nj = j.low; nj <= j.high; ++nj) {
        keys.push_back({{ni, nj, k.low}, k.high - k.low + 1});
      }
    }
  }
  return merged(std::move(keys));
}

std::vector<ResampledRun> resampleRun(const Clay& field, const KeyRun& run,
                                      const ResamplePass& pass) {
  const AxisTaps i(run.key.i, pass.ratio), j(run.key.j, pass.ratio);
  ColumnSweep<CornerBlock<8>, 4> sweep(
      field.tree, {i.lowBlock(), j.lowBlock(), firstSourceBlock(run.key.k, pass.ratio)});
  std::vector<ResampledRun> made;
  const std::int32_t end = run.key.k + run.length;
  for (std::int32_t at = run.key.k; at < end;) {
    const AxisTaps k(at, pass.ratio);
    SourceBlocks sources;
    const std::int32_t steady = sweep.window(k.lowBlock(), sources);
    const std::int32_t next = lastSteady(at, end, steady, pass.ratio) + 1;
    append(made, {{run.key.i, run.key.j, at}, next - at},
           resampleBlock(sources, {&i, &j, &k}, pass.dropBelow));
    at = next;
  }
  return made;
}

}  // namespace bozzetto
