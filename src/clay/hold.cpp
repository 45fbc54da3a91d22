#include "bozzetto/clay/hold.hpp"

#include <algorithm>
#include <cmath>

#include "bozzetto/base/error.hpp"

namespace bozzetto::clay {
namespace {

struct Piece {
  KeyRun run;
  bool interned;
};

Attributes held(Attributes attributes, Attributes hold) {
  return (attributes & 0xffffff) | hold << 24;
}

// Runs of the tree that meet the box; interned ones that lie inside wholly stay runs.
template <int Side>
std::vector<Piece> piecesIn(const KeyTree<CornerBlock<Side>>& tree, const KeyBox& box) {
  std::vector<Piece> pieces;
  for (const auto& [key, run] : tree) {
    const Key low = key * Side,
              high = (key + Key{0, 0, run.length - 1}) * Side + Key{Side - 1, Side - 1, Side - 1};
    bool apart = false;
    for (const Axis axis : kAxes)
      apart = apart || low[axis] > box.high[axis] || high[axis] < box.low[axis];
    if (apart) continue;
    const bool inside = box.contains(low) && box.contains(high);
    if (inside && run.block->interned) {
      pieces.push_back({{key, run.length}, true});
      continue;
    }
    for (std::int32_t n = 0; n < run.length; ++n)
      pieces.push_back({{key + Key{0, 0, n}, 1}, false});
  }
  return pieces;
}

template <int Side>
void holdBlock(Edit<CornerBlock<Side>>& edit, Key key, const KeyBox& box, Attributes hold) {
  const Key first = key * Side;
  CornerBlock<Side>* block = nullptr;
  for (int n = 0; n < CornerBlock<Side>::kCount; ++n) {
    if (!box.contains(first + Key{n / (Side * Side), n / Side % Side, n % Side})) continue;
    if (block == nullptr) {
      if (edit.read(key) == nullptr) return;
      block = &edit.write(key);
    }
    if (block->value[n] > 0) block->attributes[n] = held(block->attributes[n], hold);
  }
}

template <int Side>
void setHold(Edit<CornerBlock<Side>>& edit, const KeyBox& box, Attributes hold) {
  for (const Piece& piece : piecesIn<Side>(edit.tree(), box)) {
    if (!piece.interned) {
      holdBlock<Side>(edit, piece.run.key, box, hold);
      continue;
    }
    const CornerBlock<Side>* block = edit.read(piece.run.key);
    edit.replace(piece.run,
                 CornerBlock<Side>::uniform(block->value[0], held(block->attributes[0], hold)));
  }
}

}  // namespace

template <int Side>
void holdClay(Edit<CornerBlock<Side>>& edit, const KeyBox& box, double amount) {
  if (!(amount >= 0 && amount <= 1))
    throw Error("hold amount: " + std::to_string(amount) + " found, a number in 0…1 expected");
  setHold<Side>(edit, box, static_cast<Attributes>(std::lround(amount * 255)));
}

template <int Side>
void releaseClay(Edit<CornerBlock<Side>>& edit) {
  constexpr std::int32_t rim = kWorkspaceRim;
  setHold<Side>(edit, {{-rim, -rim, -rim}, {rim, rim, rim}}, 0);
}

template void holdClay(Edit<CornerBlock<1>>&, const KeyBox&, double);
template void holdClay(Edit<CornerBlock<8>>&, const KeyBox&, double);
template void releaseClay(Edit<CornerBlock<1>>&);
template void releaseClay(Edit<CornerBlock<8>>&);

}  // namespace bozzetto::clay
