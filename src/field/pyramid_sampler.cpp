#include <algorithm>
#include <cmath>

#include "bozzetto/field/pyramid.hpp"
#include "field/trilinear.hpp"

namespace bozzetto {
namespace {

using Geometry = BlockGeometry<8>;

// Where a place lies in level L: x_L = x / 2^L − (1 − 2^−L) / 2, origin's whole part apart.
struct LevelPlace {
  Key base;
  glm::vec3 fraction;
};

LevelPlace placeIn(Key origin, glm::vec3 position, int level) {
  const float scale = 1.0f / static_cast<float>(1 << level);
  LevelPlace result;
  for (const Axis axis : kAxes) {
    const int a = index(axis);
    const auto rest = static_cast<float>(origin[axis] & ((1 << level) - 1));
    const float x = (rest + position[a]) * scale - 0.5f * (1.0f - scale);
    const float whole = std::floor(x);
    result.base[axis] = (origin[axis] >> level) + static_cast<std::int32_t>(whole);
    result.fraction[a] = x - whole;
  }
  return result;
}

}  // namespace

PyramidSampler::PyramidSampler(const Clay& field, const Pyramid& pyramid, Key origin)
    : origin_(origin), field_(field.tree) {
  for (int n = 1; n <= pyramid.levels(); ++n) levels_.emplace_back(pyramid.level(n));
}

template <class Block>
float PyramidSampler::interpolate(BlockCache<Block>& blocks, Key base, glm::vec3 fraction) {
  std::array<float, 8> corners;
  const Key block = Geometry::blockOf(base);
  const Key in = base - Geometry::firstCornerOf(block);
  if (in.i < 7 && in.j < 7 && in.k < 7) {
    // All eight in one block.
    const Block* content = blocks.find(block);
    if (content == nullptr) return 0.0f;
    const float* v = content->value.data() + Geometry::indexOf(in.i, in.j, in.k);
    corners = {v[0], v[1], v[8], v[9], v[64], v[65], v[72], v[73]};
  } else {
    for (int n = 0; n < 8; ++n) {
      const Key corner = base + cubeCorner(n);
      const Block* content = blocks.find(Geometry::blockOf(corner));
      corners[n] = content == nullptr ? 0.0f : content->value[Geometry::indexOf(corner)];
    }
  }
  return trilinear(corners, fraction);
}

float PyramidSampler::sampleLevel(glm::vec3 position, int level) {
  const LevelPlace place = placeIn(origin_, position, level);
  return level == 0 ? interpolate(field_, place.base, place.fraction)
                    : interpolate(levels_[static_cast<std::size_t>(level - 1)], place.base,
                                  place.fraction);
}

float PyramidSampler::sample(glm::vec3 position, float level) {
  const int last = static_cast<int>(levels_.size());
  const float at = std::clamp(level, 0.0f, static_cast<float>(last));
  const int low = static_cast<int>(at);
  const float value = sampleLevel(position, low);
  const float part = at - static_cast<float>(low);
  return part > 0 ? mix(value, sampleLevel(position, low + 1), part) : value;
}

}  // namespace bozzetto
