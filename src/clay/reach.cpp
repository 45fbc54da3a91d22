#include "clay/reach.hpp"

#include <algorithm>
#include <set>

namespace bozzetto::clay {
namespace {

// Half the side of the box that is left of a body too large to be taken whole.
constexpr std::int32_t kCutReach = 96;

void include(KeyBox& box, Key key) {
  if (box.empty()) box = {key, key};
  for (const Axis axis : kAxes) {
    box.low[axis] = std::min(box.low[axis], key[axis]);
    box.high[axis] = std::max(box.high[axis], key[axis]);
  }
}

template <int Side>
bool hasClay(const Edit<CornerBlock<Side>>& edit, Key tile) {
  if constexpr (Side == Region::kTile) return edit.read(tile) != nullptr;
  bool any = false;
  for (std::int32_t n = 0; n < 64 && !any; ++n)
    edit.visit({tile * 8 + Key{n / 8, n % 8, 0}, 8},
               [&](KeyRun, const CornerBlock<Side>* block) { any = any || block != nullptr; });
  return any;
}

KeyBox cornersOf(const KeyBox& tiles) {
  return {tiles.low * Region::kTile, tiles.high * Region::kTile + Key{7, 7, 7}};
}

bool affordable(const KeyBox& tiles) {
  KeyBox wide = tiles;
  for (const Axis axis : kAxes) wide.low[axis] -= 3, wide.high[axis] += 3;
  return wide.count() <= kMostCorners / 512;
}

}  // namespace

template <int Side>
Reach connectedClay(const Edit<CornerBlock<Side>>& edit, const KeyBox& seeds) {
  KeyBox tiles;
  std::set<Key> seen;
  std::vector<Key> open;
  const auto visit = [&](Key tile) {
    if (seen.contains(tile) || !hasClay<Side>(edit, tile)) return;
    seen.insert(tile);
    open.push_back(tile);
    include(tiles, tile);
  };
  const Key low = BlockGeometry<8>::blockOf(seeds.low),
            high = BlockGeometry<8>::blockOf(seeds.high);
  for (std::int32_t i = low.i; i <= high.i; ++i)
    for (std::int32_t j = low.j; j <= high.j; ++j)
      for (std::int32_t k = low.k; k <= high.k; ++k) visit({i, j, k});
  while (!open.empty()) {
    const Key tile = open.back();
    open.pop_back();
    for (const Axis axis : kAxes)
      for (const std::int32_t step : {-1, 1}) {
        Key next = tile;
        next[axis] += step;
        visit(next);
      }
    if (seen.size() <= kMostTiles && affordable(tiles)) continue;
    KeyBox cut = seeds;
    for (const Axis axis : kAxes) {
      const std::int32_t middle = seeds.low[axis] + (seeds.high[axis] - seeds.low[axis]) / 2;
      cut.low[axis] = std::min(cut.low[axis] - 16, middle - kCutReach);
      cut.high[axis] = std::max(cut.high[axis] + 16, middle + kCutReach);
    }
    return {tileBox(cut, 0), false};
  }
  return {tiles.empty() ? KeyBox{} : cornersOf(tiles), true};
}

template <int Side>
bool anyClay(const Edit<CornerBlock<Side>>& edit, const KeyBox& box) {
  const Key low = BlockGeometry<8>::blockOf(box.low), high = BlockGeometry<8>::blockOf(box.high);
  bool any = false;
  for (std::int32_t i = low.i; i <= high.i; ++i)
    for (std::int32_t j = low.j; j <= high.j; ++j)
      for (std::int32_t k = low.k; k <= high.k && !any; ++k) any = hasClay<Side>(edit, {i, j, k});
  return any;
}

template <int Side>
Reach allClay(const Edit<CornerBlock<Side>>& edit) {
  KeyBox corners;
  std::int64_t count = 0;
  for (const auto& [key, run] : edit.tree()) {
    const Key first = key * Side;
    include(corners, first);
    include(corners, first + Key{Side - 1, Side - 1, Side * run.length - 1});
    count += std::int64_t{run.length} * Side * Side * Side;
  }
  if (corners.empty()) return {};
  const KeyBox box = tileBox(corners, 0);
  const bool fits =
      count <= std::int64_t{kMostTiles} * 512 &&
      affordable({BlockGeometry<8>::blockOf(box.low), BlockGeometry<8>::blockOf(box.high)});
  return {box, fits};
}

template Reach connectedClay<1>(const Edit<CornerBlock<1>>&, const KeyBox&);
template Reach connectedClay<8>(const Edit<CornerBlock<8>>&, const KeyBox&);
template bool anyClay<1>(const Edit<CornerBlock<1>>&, const KeyBox&);
template bool anyClay<8>(const Edit<CornerBlock<8>>&, const KeyBox&);
template Reach allClay<1>(const Edit<CornerBlock<1>>&);
template Reach allClay<8>(const Edit<CornerBlock<8>>&);

}  // namespace bozzetto::clay
