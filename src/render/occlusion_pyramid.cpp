// Occupancy from density, then level over level.
#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "bozzetto/base/parallel.hpp"
#include "bozzetto/render/occlusion.hpp"

namespace bozzetto {
namespace {

using Level = OcclusionPyramid::Level;
using Brick = Ref<OccupancyBrick>;
constexpr int kSide = OccupancyBrick::kSide;
using Geometry = BlockGeometry<kSide>;

const Brick& solidBrick() {
  static const Brick brick = [] {
    Brick solid(new OccupancyBrick());
    solid->texel.fill(255);
    return solid;
  }();
  return brick;
}

// Null when there is only air, the one solid brick when there is only clay.
Brick tidy(Brick brick) {
  const auto& texel = brick->texel;
  if (std::any_of(texel.begin(), texel.end(), [&](auto t) { return t != texel[0]; })) return brick;
  return texel[0] == 255 ? solidBrick() : texel[0] == 0 ? nullptr : brick;
}

std::uint8_t quantised(float occupancy) {
  return std::uint8_t(std::clamp(occupancy, 0.f, 1.f) * 255 + .5f);
}

// A block's values with one more all around its faces; what central differences need.
struct BlockWithRim {
  static constexpr int kRow = kSide + 2;
  std::array<float, kRow * kRow * kRow> value;

  BlockWithRim(const Clay& clay, Key block);
  static constexpr int indexOf(int i, int j, int k) {
    return ((i + 1) * kRow + j + 1) * kRow + k + 1;
  }
};

BlockWithRim::BlockWithRim(const Clay& clay, Key block) {
  value.fill(0);
  for (int di = -1; di <= 1; ++di) {
    for (int dj = -1; dj <= 1; ++dj) {
      for (int dk = -1; dk <= 1; ++dk) {
        if (std::abs(di) + std::abs(dj) + std::abs(dk) > 1) continue;
        const Clay::Block* near = clay.tree.find(block + Key{di, dj, dk});
        if (near == nullptr) continue;
        const auto first = [](int d) { return d < 0 ? -1 : d > 0 ? kSide : 0; };
        const auto last = [](int d) { return d < 0 ? 0 : d > 0 ? kSide + 1 : kSide; };
        for (int i = first(di); i < last(di); ++i) {
          for (int j = first(dj); j < last(dj); ++j) {
            for (int k = first(dk); k < last(dk); ++k) {
              value[std::size_t(indexOf(i, j, k))] = near->value[std::size_t(
                  Geometry::indexOf(i & (kSide - 1), j & (kSide - 1), k & (kSide - 1)))];
            }
          }
        }
      }
    }
  }
}

// Signed distance by the value over its slope, as a ramp of two cells: clay made with soft tools
// shades like clay made with hard ones.
Brick occupancyOf(const Clay& clay, Key block) {
  const BlockWithRim rim(clay, block);
  constexpr int stepI = BlockWithRim::kRow * BlockWithRim::kRow, stepJ = BlockWithRim::kRow;
  Brick brick(new OccupancyBrick());
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      for (int k = 0; k < kSide; ++k) {
        const float* v = &rim.value[std::size_t(BlockWithRim::indexOf(i, j, k))];
        const float gi = v[stepI] - v[-stepI], gj = v[stepJ] - v[-stepJ], gk = v[1] - v[-1];
        const float slope = .5f * std::sqrt(gi * gi + gj * gj + gk * gk);
        const float above = v[0] - clay.scale.iso;
        brick->texel[std::size_t(Geometry::indexOf(i, j, k))] =
            quantised(slope > 1e-4f ? .5f + above / (2 * slope)
                      : above >= 0  ? 1.f
                                    : 0.f);
      }
    }
  }
  return tidy(std::move(brick));
}

// Box of 2 and then (1 2 1)/4, in one: six fine texels from 2t − 2 on.
constexpr float kDown[6] = {1 / 8.f, 1 / 8.f, 2 / 8.f, 2 / 8.f, 1 / 8.f, 1 / 8.f};

Brick coarser(const OcclusionPyramid& pyramid, int fineLevel, Key brick) {
  constexpr int fine = 2 * kSide + 4;
  std::array<float, fine * fine * fine> a;
  const Key low = brick * (2 * kSide) - Key{2, 2, 2};
  pyramid.read(fineLevel, {low, low + Key{fine - 1, fine - 1, fine - 1}}, a);
  // One axis after the other: rows of `fine` values shrink to kSide, the fastest index first.
  std::array<float, fine * fine * fine> b;
  int rows = fine * fine;
  for (int axis = 0; axis < 3; ++axis) {
    for (int row = 0; row < rows; ++row) {
      for (int t = 0; t < kSide; ++t) {
        float sum = 0;
        for (int n = 0; n < 6; ++n) sum += kDown[n] * a[std::size_t(row * fine + 2 * t + n)];
        b[std::size_t(t * rows + row)] = sum;  // transposed: the next axis becomes the fastest
      }
    }
    std::swap(a, b);
    rows = rows / fine * kSide;
  }
  Brick result(new OccupancyBrick());
  std::transform(a.begin(), a.begin() + Geometry::kCount, result->texel.begin(), quantised);
  return tidy(std::move(result));
}

// The coarse bricks that texels of the level's bricks reach.
std::vector<Key> reachedBy(const Level& level) {
  const auto first = [](std::int32_t brick) { return (brick * kSide - 3) >> 4; };
  const auto last = [](std::int32_t brick) { return (brick * kSide + kSide + 1) >> 4; };
  std::vector<Key> keys;
  for (const auto& [key, run] : level) {
    for (std::int32_t i = first(key.i); i <= last(key.i); ++i) {
      for (std::int32_t j = first(key.j); j <= last(key.j); ++j) {
        for (std::int32_t k = first(key.k); k <= last(key.k + run.length - 1); ++k) {
          keys.push_back({i, j, k});
        }
      }
    }
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  return keys;
}

template <class Make>
Level built(const std::vector<Key>& keys, Make&& make) {
  std::vector<Brick> bricks(keys.size());
  parallelFor(keys.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) bricks[n] = make(keys[n]);
  });
  Level level;
  for (std::size_t n = 0; n < keys.size(); ++n) {
    if (!bricks[n]) continue;
    level.put(keys[n], bricks[n]);
    if (bricks[n] == solidBrick()) level.join(keys[n]);
  }
  return level;
}

}  // namespace

OcclusionPyramid::OcclusionPyramid(const Clay& clay) {
  std::vector<Key> surfaceBlocks;
  for (const auto& [key, run] : clay.tree) {
    if (run.length == 1) surfaceBlocks.push_back(key);
  }
  levels_[0] = built(surfaceBlocks, [&](Key key) { return occupancyOf(clay, key); });
  for (const auto& [key, run] : clay.tree) {
    if (run.length > 1 && run.block->low >= clay.scale.iso) {
      levels_[0].put(key, run.length, solidBrick());
      levels_[0].join(key);
    }
  }
  for (int n = 1; n < kLevels; ++n) {
    levels_[std::size_t(n)] = built(reachedBy(levels_[std::size_t(n) - 1]),
                                    [&](Key key) { return coarser(*this, n - 1, key); });
  }
}

void OcclusionPyramid::read(int level, const KeyBox& box, std::span<float> texels) const {
  std::fill(texels.begin(), texels.end(), 0.f);
  const std::size_t rowK = std::size_t(box.high.k - box.low.k + 1);
  const std::size_t rowJ = std::size_t(box.high.j - box.low.j + 1);
  const Key first = Geometry::blockOf(box.low), last = Geometry::blockOf(box.high);
  const Level& bricks = this->level(level);

  const auto copyBrick = [&](const OccupancyBrick& brick, Key key) {
    const KeyBox part = Geometry::cornersOf(key);
    for (int i = std::max(part.low.i, box.low.i); i <= std::min(part.high.i, box.high.i); ++i) {
      for (int j = std::max(part.low.j, box.low.j); j <= std::min(part.high.j, box.high.j); ++j) {
        const int begin = std::max(part.low.k, box.low.k), end = std::min(part.high.k, box.high.k);
        const std::size_t row =
            (std::size_t(i - box.low.i) * rowJ + std::size_t(j - box.low.j)) * rowK;
        for (int k = begin; k <= end; ++k) {
          texels[row + std::size_t(k - box.low.k)] =
              float(brick.texel[std::size_t(Geometry::indexOf({i, j, k}))]) / 255;
        }
      }
    }
  };
  for (std::int32_t i = first.i; i <= last.i; ++i) {
    for (std::int32_t j = first.j; j <= last.j; ++j) {
      for (auto node = bricks.from({i, j, first.k}); node != bricks.end(); ++node) {
        const auto& [key, run] = *node;
        if (key.i != i || key.j != j || key.k > last.k) break;
        const std::int32_t end = std::min(last.k, key.k + run.length - 1);
        for (std::int32_t k = std::max(first.k, key.k); k <= end; ++k) {
          copyBrick(*run.block, {i, j, k});
        }
      }
    }
  }
}

}  // namespace bozzetto
