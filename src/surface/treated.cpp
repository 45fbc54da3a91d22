// The paper's count of cubes to treat again after a change (Ferley §3.2): those with a changed
// corner, counted 64 at a time.
#include <algorithm>
#include <bit>

#include "bozzetto/base/simd.hpp"
#include "bozzetto/surface/surface.hpp"
#include "surface/key_runs.hpp"

namespace bozzetto {
namespace {

// The changed corners of one column of blocks, asked for with ascending k.
class ColumnBits {
 public:
  ColumnBits(std::span<const ChangedRun> changed, Key first)
      : end_(changed.data() + changed.size()) {
    const auto after = std::partition_point(
        changed.begin(), changed.end(), [&](const ChangedRun& run) { return !(first < run.key); });
    at_ = changed.data() + (after - changed.begin());
    if (after != changed.begin()) --at_;
    i_ = first.i;
    j_ = first.j;
  }

  const CornerBits& at(std::int32_t k) {
    static constexpr CornerBits kNone{};
    while (at_ != end_ && (at_->key < Key{i_, j_, k}) && !covers(k)) ++at_;
    return at_ != end_ && covers(k) ? at_->corners : kNone;
  }

 private:
  bool covers(std::int32_t k) const {
    return at_->key.i == i_ && at_->key.j == j_ && at_->key.k <= k && k < at_->key.k + at_->length;
  }

  const ChangedRun* at_;
  const ChangedRun* end_;
  std::int32_t i_, j_;
};

// A block of side 8 and its seven neighbours above, number 4·di + 2·dj + dk.
using Octet = std::array<const CornerBits*, 8>;

// Cubes of one slice of corners that have a changed corner there: bit j · 8 + k.
BOZZETTO_KERNEL std::uint64_t feltInSlice(const Octet& blocks, int i) {
  constexpr std::uint64_t kFirst = 0x0101010101010101;  // k = 0 of every row
  const int from = i / 8 * 4, slice = i % 8;
  const auto word = [&](int n) { return (*blocks[from + n])[slice]; };
  const std::uint64_t own = word(0) | (word(0) >> 1 & ~(kFirst << 7)) | (word(1) & kFirst) << 7;
  const std::uint64_t row = word(2) & 255;  // j = 8
  const std::uint64_t last = row | row >> 1 | (word(3) & 1) << 7;
  return own | own >> 8 | last << 56;
}

BOZZETTO_KERNEL std::int64_t octetKernel(const Octet& blocks) {
  std::int64_t count = 0;
  std::uint64_t below = feltInSlice(blocks, 0);
  for (int i = 1; i <= 8; ++i) {
    const std::uint64_t above = feltInSlice(blocks, i);
    count += std::popcount(below | above);
    below = above;
  }
  return count;
}

BOZZETTO_SIMD_DISPATCH(std::int64_t, treatedIn, octetKernel, (const Octet& blocks), (blocks))

std::int64_t treatedIn(const KeyRun& run, std::span<const ChangedRun> changed) {
  const Key key = run.key;
  std::array<ColumnBits, 4> columns{
      ColumnBits(changed, key), ColumnBits(changed, key + Key{0, 1, 0}),
      ColumnBits(changed, key + Key{1, 0, 0}), ColumnBits(changed, key + Key{1, 1, 0})};
  std::int64_t count = 0;
  Octet blocks;
  for (std::int32_t k = key.k; k < key.k + run.length; ++k) {
    for (std::size_t n = 0; n < 4; ++n) {
      blocks[2 * n] = k == key.k ? &columns[n].at(k) : blocks[2 * n + 1];
      blocks[2 * n + 1] = &columns[n].at(k + 1);
    }
    count += treatedIn(blocks);
  }
  return count;
}

}  // namespace

template <int Side>
std::int64_t treatedCubes(std::span<const ChangedRun> changed) {
  std::vector<TouchedRun> touched;
  touched.reserve(changed.size());
  for (const ChangedRun& run : changed) {
    if (run.corners != CornerBits{}) touched.push_back({run});
  }
  std::int64_t count = 0;
  for (const KeyRun& run : dilated(joined(std::move(touched)), 1, 0)) {
    count += Side == 1 ? run.length : treatedIn(run, changed);
  }
  return count;
}

template std::int64_t treatedCubes<1>(std::span<const ChangedRun>);
template std::int64_t treatedCubes<8>(std::span<const ChangedRun>);

}  // namespace bozzetto
