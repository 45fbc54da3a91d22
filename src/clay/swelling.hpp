// Relief that grows (Takai §3, figure 11): where a swelling tool is, clay may hold less, and what
// is too much comes out. Left to find its own way it goes to all sides; here it goes the way the
// surface faces, and what lacks behind it is made good by the clay inside.
#pragma once
#include "clay/evening.hpp"
#include "clay/layer.hpp"

namespace bozzetto::clay {

class Swelling {
 public:
  /// One step: nothing without swelling tools. O(rows of the region) and, for a while, O(cells
  /// inside that lack).
  void run(Work& work);

 private:
  bool wish(Work& work);
  void wishFor(Region& region, const PlacedTool& tool, const glm::dvec3& out);

  Evening evening_;
};

}  // namespace bozzetto::clay
