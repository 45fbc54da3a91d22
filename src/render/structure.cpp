// Outer sides of unions of cubes, block by block. A cube's side is drawn where the cube beyond it
// is not in the set.
#include "bozzetto/render/structure.hpp"

#include <algorithm>
#include <array>
#include <bitset>
#include <functional>
#include <set>

#include "bozzetto/field/block_cache.hpp"
#include "bozzetto/field/sampler.hpp"
#include "render/names.hpp"

namespace bozzetto {
namespace {

constexpr int kSide = 8;
using Geometry = Clay::Geometry;
using Member = std::function<bool(Key cube)>;

bool hasClay(FieldSampler<8>& sampler, Key cube) {
  for (int corner = 0; corner < 8; ++corner) {
    const Key step{corner >> 2 & 1, corner >> 1 & 1, corner & 1};
    if (sampler.corner(cube + step) > 0) return true;
  }
  return false;
}

// Membership of a block's cubes and of those one beyond its faces, asked once each.
class Members {
 public:
  Members(Key firstCube, const Member& member) {
    for (int n = 0; n < kCount; ++n) in_[std::size_t(n)] = member(firstCube + placeOf(n));
  }
  bool at(Key local) const { return in_[std::size_t(numberOf(local))]; }

 private:
  static constexpr int kRow = kSide + 2, kCount = kRow * kRow * kRow;
  static int numberOf(Key p) { return ((p.i + 1) * kRow + p.j + 1) * kRow + p.k + 1; }
  static Key placeOf(int n) { return {n / kRow / kRow - 1, n / kRow % kRow - 1, n % kRow - 1}; }
  std::bitset<kCount> in_;
};

// Side of the cube at `low` across `axis`, on its + or − face: four vertices, two triangles.
void addSide(UnpackedPatch& patch, Key low, Axis axis, bool plus, FieldSampler<8>& sampler) {
  const std::size_t a = index(axis), u = (a + 1) % 3, v = (a + 2) % 3;
  const auto first = std::uint16_t(patch.positions.size());
  glm::vec3 normal(0);
  normal[int(a)] = plus ? 1 : -1;
  Colour colour;
  for (int corner = 0; corner < 4; ++corner) {
    glm::vec3 p(low.i, low.j, low.k);
    p[int(a)] += plus;
    p[int(u)] += corner == 1 || corner == 2;
    p[int(v)] += corner >= 2;
    patch.positions.push_back(p);
    patch.normals.push_back(normal);
  }
  colour = sampler.colour({patch.origin + low, glm::vec3(.5f)});
  patch.colours.insert(patch.colours.end(), 4, colour);
  for (const int n : plus ? std::array{0, 1, 2, 0, 2, 3} : std::array{0, 2, 1, 0, 3, 2}) {
    patch.indices.push_back(std::uint16_t(first + n));
  }
}

UnpackedPatch sidesOf(Key block, const Member& member, FieldSampler<8>& sampler) {
  UnpackedPatch patch(Geometry::firstCornerOf(block));
  const Members members(patch.origin, member);
  for (int n = 0; n < kSide * kSide * kSide; ++n) {
    const Key cube{n / kSide / kSide, n / kSide % kSide, n % kSide};
    if (!members.at(cube)) continue;
    for (const Axis axis : kAxes) {
      for (const int side : {-1, 1}) {
        Key beyond = cube;
        beyond[axis] += side;
        if (!members.at(beyond)) addSide(patch, cube, axis, side > 0, sampler);
      }
    }
  }
  return patch;
}

bool isFull(const Clay::Block* block) {
  return block != nullptr && block->interned && block->low > 0;
}

// No cube of such a block, nor of those before it, has a side to show.
bool isDeepInside(BlockCache<Clay::Block>& blocks, Key block) {
  for (int n = 0; n < 27; ++n) {
    if (!isFull(blocks.find(block + Key{n / 9 - 1, n / 3 % 3 - 1, n % 3 - 1}))) return false;
  }
  return true;
}

// Blocks of cubes that may show a side: those that share a corner with a block not deep inside.
std::set<Key> blocksToShow(const Clay& clay) {
  std::set<Key> blocks;
  BlockCache<Clay::Block> cache(clay.tree);
  for (const auto& [key, run] : clay.tree) {
    for (std::int32_t n = 0; n < run.length; ++n) {
      const Key block = key + Key{0, 0, n};
      if (isDeepInside(cache, block)) continue;
      for (int corner = 0; corner < 8; ++corner) {
        blocks.insert(block - Key{corner >> 2 & 1, corner >> 1 & 1, corner & 1});
      }
    }
  }
  return blocks;
}

std::vector<UnpackedPatch> allCubes(const Clay& clay) {
  FieldSampler<8> sampler(clay);
  const Member member = [&](Key cube) { return hasClay(sampler, cube); };
  std::vector<UnpackedPatch> patches;
  for (const Key block : blocksToShow(clay)) {
    UnpackedPatch patch = sidesOf(block, member, sampler);
    if (!patch.indices.empty()) patches.push_back(std::move(patch));
  }
  return patches;
}

// The crossing list as the surface keeps it, looked up by cube.
std::vector<UnpackedPatch> crossingCubes(const Surface<8>& surface, const Clay& clay) {
  FieldSampler<8> sampler(clay);
  BlockCache<SurfacePatch> cache(surface.patches());
  const Member member = [&](Key cube) {
    const SurfacePatch* patch = cache.find(Geometry::blockOf(cube));
    if (patch == nullptr) return false;
    const auto number = std::uint16_t(Geometry::indexOf(cube));
    const auto cubes = patch->content().cubes;
    const auto at = std::lower_bound(cubes.begin(), cubes.end(), number,
                                     [](const CrossingCube& c, int n) { return c.cube < n; });
    return at != cubes.end() && at->cube == number;
  };
  std::vector<UnpackedPatch> patches;
  for (const auto& [block, run] : surface.patches()) {
    patches.push_back(sidesOf(block, member, sampler));
  }
  return patches;
}

}  // namespace

Structure parseStructure(std::string_view name) {
  using enum Structure;
  return parseName<Structure>("structure", name,
                              {{"surface", surface},
                               {"cubes", cubes},
                               {"crossing-cubes", crossingCubes},
                               {"height-field", heights}});
}

std::vector<UnpackedPatch> structurePatches(const Surface<8>& surface, const Clay& clay,
                                            Structure structure) {
  if (structure == Structure::cubes) return allCubes(clay);
  if (structure == Structure::crossingCubes) return crossingCubes(surface, clay);
  std::vector<UnpackedPatch> patches;
  patches.reserve(std::size_t(surface.totals().patches));
  for (const auto& [block, run] : surface.patches()) {
    patches.emplace_back(Geometry::firstCornerOf(block), *run.block);
  }
  return patches;
}

}  // namespace bozzetto
