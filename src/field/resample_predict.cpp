// How large a resampled field will be, before any of it is made.
#include <algorithm>
#include <cmath>
#include <string>

#include "bozzetto/base/error.hpp"
#include "bozzetto/base/parallel.hpp"
#include "bozzetto/field/resample.hpp"
#include "field/resample_ratio.hpp"
#include "field/resample_step.hpp"

namespace bozzetto {
namespace {

using Block = CornerBlock<8>;

constexpr std::size_t kNodeBytes = 56;  // as KeyTree::nodeBytes counts

struct Count {
  double corners = 0, nodes = 0, blocks = 0;
};

Count operator+(const Count& a, const Count& b) {
  return {a.corners + b.corners, a.nodes + b.nodes, a.blocks + b.blocks};
}

Count countOf(const ResampledRun& part, double weight) {
  Count count;
  for (const float value : part.block->value) count.corners += value > 0 ? 1 : 0;
  count.corners *= part.run.length * weight;
  count.nodes = weight;
  count.blocks = part.block->interned ? 0 : weight;
  return count;
}

// Ratios down to this are worked out; finer grids follow from it by powers of the ratio.
constexpr double kFinest = 1.0 / 8;
constexpr std::size_t kSampledColumns = 512;

// New block indices whose first corner lies in old block `block`, or a few of them, evenly
// scattered, each standing for `weight`.
struct Picked {
  std::vector<std::int32_t> blocks;
  double weight = 1;
};

Picked pick(std::int32_t block, double ratio, std::uint32_t scatter) {
  constexpr std::int32_t kMost = 2;
  const auto low = static_cast<std::int32_t>(std::ceil(block / ratio));
  const auto high = static_cast<std::int32_t>(std::ceil((block + 1.0) / ratio));
  Picked result;
  const std::int32_t count = high - low;
  const std::int32_t taken = std::min(kMost, count);
  for (std::int32_t n = 0; n < taken; ++n) {
    const std::int32_t begin = low + count * n / taken, end = low + count * (n + 1) / taken;
    result.blocks.push_back(begin + static_cast<std::int32_t>(scatter % (end - begin)));
  }
  if (taken > 0) result.weight = static_cast<double>(count) / taken;
  return result;
}

// What the new columns that begin in one old column will hold.
Count countColumn(const Clay& field, const KeyRun& old, double ratio) {
  const auto scatter = static_cast<std::uint32_t>(old.key.i * 73856093 ^ old.key.j * 19349663);
  const Picked is = pick(old.key.i, ratio, scatter >> 3 & 0xffff);
  const Picked js = pick(old.key.j, ratio, scatter >> 11 & 0xffff);
  const auto low = static_cast<std::int32_t>(std::floor(old.key.k / ratio)) - 1;
  const auto high = static_cast<std::int32_t>(std::ceil((old.key.k + old.length) / ratio)) + 1;
  Count sum;
  for (const std::int32_t i : is.blocks) {
    for (const std::int32_t j : js.blocks) {
      const auto parts = resampleRun(field, {{i, j, low}, high - low}, {ratio, 1e-4f});
      for (const ResampledRun& part : parts) sum = sum + countOf(part, is.weight * js.weight);
    }
  }
  return sum;
}

// Works out a sample of columns.
Count countSampled(const Clay& field, double ratio) {
  const std::vector<KeyRun> columns = resampledKeys(field, 1);
  const std::size_t stride = std::max<std::size_t>(1, columns.size() / kSampledColumns);
  std::vector<Count> counts((columns.size() + stride - 1) / stride);
  parallelFor(counts.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      counts[n] = countColumn(field, columns[n * stride], ratio);
    }
  });
  Count sum;
  for (const Count& count : counts) sum = sum + count;
  const double weight =
      counts.empty() ? 0 : static_cast<double>(columns.size()) / static_cast<double>(counts.size());
  return {sum.corners * weight, sum.nodes * weight, sum.blocks * weight};
}

Count countFiner(const Clay& field, double ratio) {
  const double worked = std::max(ratio, kFinest);
  Count count = countSampled(field, worked);
  const double finer = worked / ratio;
  const double runs = count.nodes - count.blocks;
  count.corners *= finer * finer * finer;
  count.blocks *= finer * finer * finer;
  count.nodes = count.blocks + runs * finer * finer;
  return count;
}

// The corners of one eighth of a block that are neither empty nor full: where new blocks will not
// be uniform. The whole eighth where it is uneven without a slope.
KeyBox slopeOf(const Block& block, Key eighth, int& corners) {
  KeyBox box;
  bool empty = false, full = false;
  for (int n = 0; n < 64; ++n) {
    const Key at = eighth + Key{n / 16, n / 4 % 4, n % 4};
    const float value = block.value[Block::Geometry::indexOf(at)];
    empty |= !(value > 0);
    full |= value >= block.high;
    if (!(value > 0) || value >= block.high) continue;
    if (box.empty()) box = {at, at};
    for (const Axis axis : kAxes) {
      box.low[axis] = std::min(box.low[axis], at[axis]);
      box.high[axis] = std::max(box.high[axis], at[axis]);
    }
    ++corners;
  }
  return box.empty() && empty && full ? KeyBox{eighth, eighth + Key{3, 3, 3}} : box;
}

// The new blocks that a box of old corners reaches.
void addReached(std::vector<Key>& reached, const KeyBox& box, double ratio) {
  const auto blockAt = [&](std::int32_t corner, double by) {
    return static_cast<std::int32_t>(std::floor((corner + by * ratio) / (8 * ratio)));
  };
  for (std::int32_t i = blockAt(box.low.i, -1); i <= blockAt(box.high.i, 1); ++i)
    for (std::int32_t j = blockAt(box.low.j, -1); j <= blockAt(box.high.j, 1); ++j)
      for (std::int32_t k = blockAt(box.low.k, -1); k <= blockAt(box.high.k, 1); ++k)
        reached.push_back({i, j, k});
}

// Many old corners a new one: from the extent of the slopes, block by block.
Count countCoarser(const Clay& field, double ratio) {
  std::vector<Key> reached;
  double inside = 0;
  int slope = 0;
  for (const auto& [key, run] : field.tree) {
    const Block& block = *run.block;
    if (block.low > 0) inside += double{Block::kCount} * run.length;
    if (block.interned && run.length > 2) continue;
    if (block.low <= 0) {
      for (const float value : block.value) inside += value > 0 ? 1 : 0;
    }
    for (int n = 0; n < 8; ++n) {
      const KeyBox box = slopeOf(block, Key{n >> 2, n >> 1 & 1, n & 1} * 4, slope);
      if (box.empty()) continue;
      addReached(reached, {key * 8 + box.low, key * 8 + box.high}, ratio);
    }
  }
  std::sort(reached.begin(), reached.end());
  reached.erase(std::unique(reached.begin(), reached.end()), reached.end());
  // A slope is two cells thick; clay spreads by most of the tent.
  const double area = slope / 2.0;
  Count count;
  count.corners = (inside + area * 0.85 * ratio) / (ratio * ratio * ratio);
  count.blocks = static_cast<double>(reached.size());
  count.nodes = 1.2 * count.blocks;
  return count;
}

}  // namespace

double resampleRatio(const Clay& field, double spacing) {
  const double ratio = spacing / field.scale.spacing;
  if (!(spacing > 0) || !std::isfinite(spacing) || !(ratio > 0x1p-20) || !(ratio < 0x1p30)) {
    throw Error("resample to spacing " + std::to_string(spacing) +
                ": a number > 0 and not absurdly far from " + std::to_string(field.scale.spacing) +
                " expected");
  }
  const KeyBox bounds = statistics(field).bounds;
  for (const Axis axis : kAxes) {
    if (bounds.empty()) break;
    const double farthest =
        std::max(std::abs(double(bounds.low[axis])), std::abs(double(bounds.high[axis])));
    if ((farthest + 16) / ratio + 16 > kWorkspaceRim) {
      throw Error("resample to spacing " + std::to_string(spacing) +
                  ": the clay would leave the workspace of ±2^30 cells");
    }
  }
  return ratio;
}

ResamplePrediction predictResample(const Clay& field, double spacing) {
  const double ratio = resampleRatio(field, spacing);
  const Count count = ratio <= 2 ? countFiner(field, ratio) : countCoarser(field, ratio);
  const double bytes = count.nodes * kNodeBytes + count.blocks * double{sizeof(Block)};
  return {static_cast<std::int64_t>(std::min(1e18, count.corners)),
          static_cast<std::size_t>(std::min(1e18, bytes))};
}

}  // namespace bozzetto
