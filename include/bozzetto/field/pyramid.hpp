// Half-resolution copies of the density: what occlusion, cavity and minified tools read instead of
// many corners.
//
// Corner I of a level averages corners 2I−2…2I+3 of the level below along each axis with weights
// [1 1 2 2 1 1]/8: a 2×2×2 box, then one [1 2 1]/4. Its centre lies at 2I + ½ of the level below,
// so x_L = (x_{L−1} − ½) / 2. Level 0 is the field itself.
#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "bozzetto/field/block_cache.hpp"
#include "bozzetto/field/field.hpp"

namespace bozzetto {

/// 8³ densities of one level. Equal blocks of the inside are one block in memory.
struct DensityBlock : RefCounted {
  static constexpr int kSide = 8;
  static constexpr int kCount = 512;
  alignas(64) std::array<float, kCount> value{};
  bool uniform = false;  ///< all equal; shared, never written

  static void* operator new(std::size_t size);
  static void operator delete(void* block, std::size_t size);
};

using DensityTree = KeyTree<DensityBlock>;

/// A value type: copying it copies block pointers only.
class Pyramid {
 public:
  /// `levels` ≥ 1 copies, each half as fine as the one before.
  explicit Pyramid(int levels = 6) : trees_(static_cast<std::size_t>(levels)) {}

  /// Makes all levels from the field. O(blocks near the surface + runs), in parallel.
  void rebuild(const Clay& field);

  /// Brings up to date what depends on the changed block keys (Delta::keys()); the same bits as a
  /// rebuild. O(changed blocks), in parallel.
  void refresh(const Clay& field, std::span<const KeyRun> changed);

  int levels() const { return static_cast<int>(trees_.size()); }
  /// Level 1 … levels().
  const DensityTree& level(int n) const { return trees_[static_cast<std::size_t>(n - 1)]; }
  /// Of nodes and blocks, each uniform one once.
  std::size_t bytes() const;

 private:
  std::vector<DensityTree> trees_;
};

/// Samples a field and its pyramid at places relative to one corner, in cells. Keeps the blocks
/// found last, so that coherent places cost some ten nanoseconds. Good while neither changes; one
/// per thread.
class PyramidSampler {
 public:
  PyramidSampler(const Clay& field, const Pyramid& pyramid, Key origin = {});

  /// Places are relative to this corner from now on. Places up to 2²⁰ cells away are precise.
  void setOrigin(Key origin) { origin_ = origin; }

  /// Mean density about origin + position: trilinear in two levels and linear between them. A
  /// level beyond the last is the last; below 0 is 0.
  float sample(glm::vec3 position, float level);

  /// Trilinear in one level, 0 … levels().
  float sampleLevel(glm::vec3 position, int level);

 private:
  template <class Block>
  float interpolate(BlockCache<Block>& blocks, Key base, glm::vec3 place);

  Key origin_;
  BlockCache<CornerBlock<8>> field_;
  std::vector<BlockCache<DensityBlock>> levels_;
};

}  // namespace bozzetto
