#include "solid/mass_band.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bozzetto/base/parallel.hpp"
#include "bozzetto/field/block_cache.hpp"

namespace bozzetto {
namespace {

using Block = CornerBlock<8>;

constexpr float kDust = 1e-4f;
constexpr int kApron = 10;
constexpr int kMostPasses = 40;

struct BandCorner {
  std::uint16_t n;
  float value, weight;
  Attributes attributes;  // its own, or of the densest neighbour where it is empty
};
using Band = std::vector<BandCorner>;

float moved(const BandCorner& corner, double c) {
  const float value = std::clamp(corner.value + static_cast<float>(c) * corner.weight, 0.0f, 1.0f);
  return value < kDust ? 0.0f : value;
}

// The values of a block and of one corner more on every side.
class Apron {
 public:
  Apron(BlockCache<Block>& blocks, Key key) {
    for (int i = 0; i < kApron; ++i)
      for (int j = 0; j < kApron; ++j)
        for (int k = 0; k < kApron; ++k) {
          const Key corner = key * 8 + Key{i - 1, j - 1, k - 1};
          const Block* block = blocks.find(BlockGeometry<8>::blockOf(corner));
          const int from = BlockGeometry<8>::indexOf(corner);
          const auto at = static_cast<std::size_t>(indexOf(i, j, k));
          value_[at] = block == nullptr ? 0 : block->value[from];
          attributes_[at] = block == nullptr ? 0 : block->attributes[from];
        }
  }

  bool flat() const {
    return std::ranges::all_of(value_, [&](float v) { return v == value_[0]; });
  }

  // Binomial blur of corner (i, j, k) of the block.
  float blurred(int i, int j, int k) const {
    float sum = 0;
    forNeighbours(i, j, k, [&](std::size_t at, float weight) { sum += weight * value_[at]; });
    return sum / 64;
  }

  float value(int i, int j, int k) const {
    return value_[static_cast<std::size_t>(indexOf(i + 1, j + 1, k + 1))];
  }

  Attributes attributes(int i, int j, int k) const {
    auto densest = static_cast<std::size_t>(indexOf(i + 1, j + 1, k + 1));
    if (value_[densest] > 0) return attributes_[densest];
    forNeighbours(i, j, k, [&](std::size_t at, float) {
      if (value_[at] > value_[densest]) densest = at;
    });
    return attributes_[densest];
  }

 private:
  static int indexOf(int i, int j, int k) { return (i * kApron + j) * kApron + k; }

  template <class Callback>
  static void forNeighbours(int i, int j, int k, Callback&& callback) {
    constexpr std::array<float, 3> weights{1, 2, 1};
    for (int n = 0; n < 27; ++n) {
      const int di = n / 9, dj = n / 3 % 3, dk = n % 3;
      const float weight =
          weights[std::size_t(di)] * weights[std::size_t(dj)] * weights[std::size_t(dk)];
      callback(static_cast<std::size_t>(indexOf(i + di, j + dj, k + dk)), weight);
    }
  }

  std::array<float, kApron * kApron * kApron> value_;
  std::array<Attributes, kApron * kApron * kApron> attributes_;
};

Band bandOf(BlockCache<Block>& blocks, Key key) {
  Band band;
  const Apron apron(blocks, key);
  if (apron.flat()) return band;
  for (int n = 0; n < 512; ++n) {
    const int i = n / 64, j = n / 8 % 8, k = n % 8;
    const float b = apron.blurred(i, j, k), weight = 4 * b * (1 - b);
    if (weight <= 0) continue;
    band.push_back(
        {static_cast<std::uint16_t>(n), apron.value(i, j, k), weight, apron.attributes(i, j, k)});
  }
  return band;
}

std::vector<Band> bandsOf(const KeyTree<Block>& tree, const std::vector<Key>& keys) {
  std::vector<Band> bands(keys.size());
  parallelFor(keys.size(), 16, [&](std::size_t begin, std::size_t end) {
    BlockCache<Block> blocks(tree);
    for (std::size_t n = begin; n < end; ++n) bands[n] = bandOf(blocks, keys[n]);
  });
  return bands;
}

// Summed block by block in order, so that threads do not show.
double gain(const std::vector<Band>& bands, double c) {
  std::vector<double> sums(bands.size(), 0);
  parallelFor(bands.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
      for (const BandCorner& corner : bands[n])
        sums[n] += double(moved(corner, c)) - double(corner.value);
  });
  double sum = 0;
  for (const double each : sums) sum += each;
  return sum;
}

double bisect(const std::vector<Band>& bands, double wanted) {
  double low = -0.5, high = 0.5;
  if (gain(bands, low) > wanted) return low;
  if (gain(bands, high) < wanted) return high;
  for (int n = 0; n < 50; ++n) {
    const double middle = (low + high) / 2;
    (gain(bands, middle) < wanted ? low : high) = middle;
  }
  return (low + high) / 2;
}

void write(Edit<Block>& edit, Key key, const Band& band, double c) {
  const bool changes = std::ranges::any_of(
      band, [&](const BandCorner& corner) { return moved(corner, c) != corner.value; });
  if (!changes) return;
  Block& block = edit.write(key);
  for (const BandCorner& corner : band) {
    block.value[corner.n] = moved(corner, c);
    block.attributes[corner.n] = block.value[corner.n] > 0 ? corner.attributes : 0;
  }
  block.updateRange();
}

}  // namespace

double massOf(const KeyTree<Block>& tree, const std::vector<Key>& keys) {
  double sum = 0;
  for (const Key key : keys) {
    const Block* block = tree.find(key);
    if (block == nullptr) continue;
    for (const float value : block->value) sum += value;
  }
  return sum;
}

double matchMass(Edit<Block>& edit, const std::vector<Key>& keys, double target) {
  double total = 0;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    const double missing = target - massOf(edit.tree(), keys);
    if (std::abs(missing) <= 1e-9 * target) break;
    const auto bands = bandsOf(edit.tree(), keys);
    const double c = bisect(bands, missing);
    for (std::size_t n = 0; n < keys.size(); ++n) write(edit, keys[n], bands[n], c);
    total += c;
    if (std::abs(c) < 0.5) break;
  }
  return total;
}

}  // namespace bozzetto
