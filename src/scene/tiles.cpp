#include "scene/tiles.hpp"

#include <algorithm>

namespace bozzetto {
namespace {

std::vector<Key> sortedUnique(std::vector<Key> tiles) {
  std::sort(tiles.begin(), tiles.end());
  tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
  return tiles;
}

void note(std::vector<Key>& tiles, Key block) {
  const Key tile = tileOf(block);
  if (tiles.empty() || tiles.back() != tile) tiles.push_back(tile);
}

}  // namespace

std::vector<Key> tilesOf(const Clay::Tree& tree) {
  std::vector<Key> tiles;
  for (const auto& [key, run] : tree) note(tiles, key);
  return sortedUnique(std::move(tiles));
}

std::vector<Key> changedTiles(const Clay::Tree& before, const Clay::Tree& after) {
  std::vector<Key> tiles;
  auto old = before.begin();
  auto now = after.begin();
  while (old != before.end() || now != after.end()) {
    const bool onlyOld = now == after.end() || (old != before.end() && old->first < now->first);
    const bool onlyNow = old == before.end() || (now != after.end() && now->first < old->first);
    const bool same = !onlyOld && !onlyNow && old->second.length == now->second.length &&
                      old->second.block == now->second.block;
    if (!same) note(tiles, onlyNow ? now->first : old->first);
    if (!onlyNow) ++old;
    if (!onlyOld) ++now;
  }
  return sortedUnique(std::move(tiles));
}

Chunk chunkAt(const Clay::Tree& tree, Key tile) {
  Chunk chunk{tile, {}};
  const Key first = tile * 8;
  for (int column = 0; column < 64; ++column) {
    const Key low = first + Key{column / 8, column % 8, 0};
    const Key end = low + Key{0, 0, 8};
    for (auto node = tree.from(low); node != tree.end() && node->first < end; ++node) {
      if (node->first < low) continue;
      chunk.runs.push_back({{node->first, node->second.length}, node->second.block});
    }
  }
  return chunk;
}

}  // namespace bozzetto
