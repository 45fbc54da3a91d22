#include "solid/raise.hpp"

namespace bozzetto {
namespace {

constexpr Attributes kHoldBits = 0xff000000u;

// True when the corner changed.
bool raiseCorner(float& value, Attributes& attributes, float wanted, Attributes colour) {
  if (wanted <= value) return false;
  const std::uint8_t hold = holdOf(attributes);
  const float rise = (wanted - value) * (1 - static_cast<float>(hold) / 255);
  if (rise <= 0) return false;
  value = hold == 0 ? wanted : value + rise;
  if (hold < 128) attributes = colour | (attributes & kHoldBits);
  return true;
}

bool raises(const CornerBlock<8>* block, const WantedDensities& wanted) {
  for (int n = 0; n < 512; ++n)
    if (wanted[n] > (block == nullptr ? 0.0f : block->value[n])) return true;
  return false;
}

const WantedDensities& allFull() {
  static const WantedDensities full = [] {
    WantedDensities each;
    each.fill(1);
    return each;
  }();
  return full;
}

}  // namespace

std::int64_t raise(Edit<CornerBlock<8>>& edit, Key key, const WantedDensities& wanted,
                   Attributes colour) {
  if (!raises(edit.read(key), wanted)) return 0;
  CornerBlock<8>& block = edit.write(key);
  std::int64_t dirty = 0;
  for (int n = 0; n < 512; ++n)
    dirty += raiseCorner(block.value[n], block.attributes[n], wanted[n], colour) ? 1 : 0;
  block.updateRange();
  return dirty;
}

std::int64_t raise(Edit<CornerBlock<1>>& edit, Key key, const WantedDensities& wanted,
                   Attributes colour) {
  std::int64_t dirty = 0;
  for (int n = 0; n < 512; ++n) {
    const Key corner = key * 8 + Key{n / 64, n / 8 % 8, n % 8};
    const CornerBlock<1>* old = edit.read(corner);
    if (wanted[n] <= (old == nullptr ? 0.0f : old->value[0])) continue;
    CornerBlock<1>& block = edit.write(corner);
    dirty += raiseCorner(block.value[0], block.attributes[0], wanted[n], colour) ? 1 : 0;
    block.updateRange();
  }
  return dirty;
}

std::int64_t raiseFull(Edit<CornerBlock<8>>& edit, KeyRun run, Attributes colour) {
  std::vector<std::pair<KeyRun, bool>> pieces;
  edit.visit(run, [&](KeyRun piece, const CornerBlock<8>* block) {
    if (block == nullptr || block->low < 1) pieces.emplace_back(piece, block == nullptr);
  });
  std::int64_t dirty = 0;
  for (const auto& [piece, empty] : pieces) {
    if (empty) {
      edit.replace(piece, CornerBlock<8>::uniform(1, colour));
      dirty += std::int64_t{512} * piece.length;
      continue;
    }
    for (std::int32_t n = 0; n < piece.length; ++n)
      dirty += raise(edit, piece.key + Key{0, 0, n}, allFull(), colour);
  }
  return dirty;
}

std::int64_t raiseFull(Edit<CornerBlock<1>>& edit, KeyRun run, Attributes colour) {
  std::int64_t dirty = 0;
  for (std::int32_t n = 0; n < run.length; ++n)
    dirty += raise(edit, run.key + Key{0, 0, n}, allFull(), colour);
  return dirty;
}

}  // namespace bozzetto
