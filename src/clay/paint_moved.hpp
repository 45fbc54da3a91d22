// Painted stiffness on its way with the clay: from the setup into regions, and back.
#pragma once
#include <algorithm>
#include <optional>
#include <span>

#include "bozzetto/clay/stiffness.hpp"
#include "clay/exchange.hpp"

namespace bozzetto::clay {

// Painted stiffness while it is moved: blocks that do not change stay shared.
class PaintMoved {
 public:
  explicit PaintMoved(const Stiffness& stiffness) : now_(stiffness) {
    if (!stiffness.any()) return;
    clay_ = *stiffness.painted;
    edit_.emplace(clay_.tree);
  }
  Stiffness now() {
    if (any() && !edit_->commit().changes.empty()) now_ = stiffnessOf(clay_);
    return now_;
  }
  bool any() const { return edit_.has_value(); }

  template <int Side>
  void load(Region& region, const Edit<CornerBlock<Side>>& edit) const {
    if (any()) loadStiffness<Side>(region, edit, *edit_);
  }
  void store(const Region& region, std::span<const Key> tiles) {
    if (any()) storeStiffness(region, tiles, *edit_);
  }
  /// The greatest offset, or more. O(blocks).
  float most() const {
    float most = 0;
    for (const auto& [key, run] : clay_.tree) {
      const CornerBlock<8>& block = *run.block;
      if (!block.oneColour || colourOf(block.only).r > 0) most = std::max(most, block.high);
    }
    return std::min(most, 1.0f);
  }

 private:
  Stiffness now_;
  Clay clay_;
  std::optional<Edit<CornerBlock<8>>> edit_;
};

}  // namespace bozzetto::clay
