// Relief that grows (Takai §3, figure 11): where a swelling tool is, clay may hold less, and what
// is too much comes out. Left to find its own way it goes to all sides; here it goes the way the
// surface faces, as far as the clay inside can make good what lacks behind it.
#pragma once
#include <string>

#include "clay/evening.hpp"
#include "clay/layer.hpp"

namespace bozzetto::clay {

class Swelling {
 public:
  /// One step: nothing without swelling tools. O(rows of the region) and, for a while, O(cells
  /// inside that lack).
  void run(Work& work);
  /// After the last step: what still lacks spreads.
  void finish(Work& work);
  /// For the sculptor, after the last step: where most of what was asked for could not be given.
  std::string remark() const;

 private:
  bool wish(Work& work);
  void wishFor(Region& region, const PlacedTool& tool, const glm::dvec3& out);

  Evening evening_;
  double asked_ = 0, given_ = 0;  // cells of clay × speed
};

}  // namespace bozzetto::clay
