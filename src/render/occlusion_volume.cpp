// Occupancy from density, block by block; its pyramid is the field's own kind.
#include <algorithm>
#include <array>
#include <cmath>

#include "bozzetto/base/parallel.hpp"
#include "bozzetto/grid/edit.hpp"
#include "bozzetto/render/occlusion.hpp"

namespace bozzetto {
namespace {

using Block = Clay::Block;
using Geometry = Clay::Geometry;
constexpr int kSide = Block::kSide;

// A block's values with one more all around its faces: what central differences need.
struct BlockWithRim {
  static constexpr int kRow = kSide + 2;
  static constexpr int kStepI = kRow * kRow, kStepJ = kRow, kStepK = 1;
  std::array<float, kRow * kRow * kRow> value{};

  BlockWithRim(const Clay& clay, Key block) {
    copy(clay, block, {0, 0, 0});
    for (const Axis axis : kAxes) {
      for (const int side : {-1, 1}) {
        Key step;
        step[axis] = side;
        copy(clay, block, step);
      }
    }
  }
  const float* at(int i, int j, int k) const { return &value[indexOf(i, j, k)]; }

 private:
  static std::size_t indexOf(int i, int j, int k) {
    return std::size_t((i + 1) * kStepI + (j + 1) * kStepJ + k + 1);
  }
  static int first(int step) { return step < 0 ? -1 : step > 0 ? kSide : 0; }
  static int last(int step) { return step < 0 ? 0 : step > 0 ? kSide + 1 : kSide; }

  void copy(const Clay& clay, Key block, Key step) {
    const Block* source = clay.tree.find(block + step);
    if (source == nullptr) return;
    for (int i = first(step.i); i < last(step.i); ++i) {
      for (int j = first(step.j); j < last(step.j); ++j) {
        for (int k = first(step.k); k < last(step.k); ++k) {
          value[indexOf(i, j, k)] = source->value[std::size_t(Geometry::indexOf({i, j, k}))];
        }
      }
    }
  }
};

// Signed distance, the value over its slope, as a ramp of two cells.
float occupancy(const float* v, float iso) {
  using Rim = BlockWithRim;
  const float gi = v[Rim::kStepI] - v[-Rim::kStepI], gj = v[Rim::kStepJ] - v[-Rim::kStepJ];
  const float gk = v[Rim::kStepK] - v[-Rim::kStepK];
  const float slope = .5f * std::sqrt(gi * gi + gj * gj + gk * gk), above = v[0] - iso;
  if (slope < 1e-4f) return above >= 0 ? 1.f : 0.f;
  return std::clamp(.5f + above / (2 * slope), 0.f, 1.f);
}

void fillOccupancy(const Clay& clay, Key key, Block& block) {
  const BlockWithRim rim(clay, key);
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      for (int k = 0; k < kSide; ++k) {
        block.value[std::size_t(Geometry::indexOf(i, j, k))] =
            occupancy(rim.at(i, j, k), clay.scale.iso);
      }
    }
  }
  block.updateRange();
}

// The runs and what touches their faces: slopes reach one corner over.
std::vector<KeyRun> withNeighbours(std::span<const KeyRun> runs) {
  std::vector<KeyRun> result;
  for (const auto& [key, length] : runs) {
    result.push_back({key - Key{0, 0, 1}, length + 2});
    for (const Key step : {Key{-1, 0, 0}, Key{1, 0, 0}, Key{0, -1, 0}, Key{0, 1, 0}}) {
      result.push_back({key + step, length});
    }
  }
  return result;
}

// Uniform stretches of a run are put at once; keys of the other blocks go to `mixed`.
void putUniform(const Clay& clay, KeyRun run, Edit<Block>& edit, std::vector<Key>& mixed) {
  edit.replace(run, nullptr);
  const Key end{run.key.i, run.key.j, run.key.k + run.length};
  for (auto node = clay.tree.from(run.key); node != clay.tree.end() && node->first < end; ++node) {
    const auto& [key, stretch] = *node;
    const std::int32_t first = std::max(key.k, run.key.k);
    const std::int32_t length = std::min(key.k + stretch.length, end.k) - first;
    const Key start{key.i, key.j, first};
    if (!stretch.block->interned) {
      mixed.push_back(start);
    } else if (stretch.block->low >= clay.scale.iso) {
      edit.replace({start, length}, Block::uniform(1, 0));
    }
  }
}

Delta<Block> update(const Clay& clay, std::span<const KeyRun> runs, Clay::Tree& occupied) {
  Edit<Block> edit(occupied);
  std::vector<Key> mixed;
  for (const KeyRun& run : runs) putUniform(clay, run, edit, mixed);
  std::sort(mixed.begin(), mixed.end());
  mixed.erase(std::unique(mixed.begin(), mixed.end()), mixed.end());
  std::vector<Ref<Block>> blocks(mixed.size());
  for (Ref<Block>& block : blocks) block = edit.fresh();
  parallelFor(mixed.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) fillOccupancy(clay, mixed[n], *blocks[n]);
  });
  for (std::size_t n = 0; n < mixed.size(); ++n) edit.replace({mixed[n], 1}, blocks[n]);
  return edit.commit();
}

// Copies what lies inside `box` of every block of a tree; the rest of `texels` stays.
template <class Tree>
void copyBox(const Tree& tree, const KeyBox& box, std::span<float> texels) {
  const std::size_t row = std::size_t(box.high.k - box.low.k + 1);
  const std::size_t slab = row * std::size_t(box.high.j - box.low.j + 1);
  const auto copyBlock = [&](const float* value, Key block) {
    const KeyBox part = Geometry::cornersOf(block);
    const int begin = std::max(part.low.k, box.low.k), end = std::min(part.high.k, box.high.k);
    for (int i = std::max(part.low.i, box.low.i); i <= std::min(part.high.i, box.high.i); ++i) {
      for (int j = std::max(part.low.j, box.low.j); j <= std::min(part.high.j, box.high.j); ++j) {
        const float* from = value + Geometry::indexOf({i, j, begin});
        const std::size_t to = std::size_t(i - box.low.i) * slab +
                               std::size_t(j - box.low.j) * row + std::size_t(begin - box.low.k);
        std::copy(from, from + (end - begin + 1), texels.begin() + std::ptrdiff_t(to));
      }
    }
  };
  const Key first = Geometry::blockOf(box.low), last = Geometry::blockOf(box.high);
  for (std::int32_t i = first.i; i <= last.i; ++i) {
    for (std::int32_t j = first.j; j <= last.j; ++j) {
      const Key end{i, j, last.k + 1};
      for (auto node = tree.from({i, j, first.k}); node != tree.end() && node->first < end;
           ++node) {
        const auto& [key, run] = *node;
        const std::int32_t until = std::min(end.k, key.k + run.length);
        for (std::int32_t k = std::max(first.k, key.k); k < until; ++k) {
          copyBlock(run.block->value.data(), {i, j, k});
        }
      }
    }
  }
}

}  // namespace

OcclusionVolume::OcclusionVolume(const Clay& clay) {
  std::vector<KeyRun> runs;
  for (const auto& [key, run] : clay.tree) runs.push_back({key, run.length});
  update(clay, runs, occupied_.tree);
  pyramid_.rebuild(occupied_);
}

void OcclusionVolume::refresh(const Clay& clay, std::span<const KeyRun> changed) {
  const Delta<Block> delta = update(clay, withNeighbours(changed), occupied_.tree);
  pyramid_.refresh(occupied_, delta.keys());
}

void OcclusionVolume::read(int level, const KeyBox& box, std::span<float> texels) const {
  std::fill(texels.begin(), texels.end(), 0.f);
  if (level == 0) {
    copyBox(occupied_.tree, box, texels);
  } else {
    copyBox(pyramid_.level(level), box, texels);
  }
}

}  // namespace bozzetto
