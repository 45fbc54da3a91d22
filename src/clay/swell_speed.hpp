// How fast a swelling tool moves each cell of clay along one way out: by the tool's form as seen
// that way, whether it stands in the clay or on it; less and less below where it stands; slower
// where little clay stands behind, so that a sheet grows thicker instead of bulging on both sides.
#pragma once
#include <vector>

#include "clay/placed_tool.hpp"

namespace bozzetto::clay {

/// Numbers for the keys of a box; 0 beyond it.
class BoxField {
 public:
  explicit BoxField(const KeyBox& box);
  const KeyBox& box() const { return box_; }
  float& operator[](Key key) { return values_[index(key)]; }
  float at(Key key) const { return box_.contains(key) ? values_[index(key)] : 0.0f; }

 private:
  std::size_t index(Key key) const;
  KeyBox box_;
  Key size_;
  std::vector<float> values_;
};

/// 1 at the tool's core, 0 at its surface.
double partAt(const PlacedTool& tool, Key key);

/// The cell nearest to where it stands.
Key standOf(const PlacedTool& tool);

/// `wanted` is as the tool has it, `speed` as far as clay stands behind; `fullness` is that of the
/// clay inside, by the cells behind before all; 0 where all is surface.
struct SwellSpeed {
  BoxField wanted, speed, fullness;
};

/// 0 … 1 over the tool's box, what is below where it stands, and a little more on every side; `out`
/// has length 1. O(box).
SwellSpeed swellSpeed(const Region& region, const PlacedTool& tool, const glm::dvec3& out);

}  // namespace bozzetto::clay
