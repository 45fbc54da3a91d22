// Sculpted tools as pushers: their signed distance, found once for a tool, so that clay inside
// knows the way out (Dewaele §3.2.2).
#pragma once
#include <array>
#include <vector>

#include "bozzetto/tool/sculpture.hpp"

namespace bozzetto {

/// Signed distance to a sculpture's surface, in its own cells, on a grid round it of at most 160
/// nodes a side. O(nodes).
class SculptedDistance {
 public:
  explicit SculptedDistance(const Sculpture& sculpture);
  /// At a place in the sculpture's cells from its centre; negative inside. Grows linearly outside
  /// the grid.
  double at(const glm::dvec3& place) const;
  /// How deep its nodes inside are at most, and on the mean; in cells of the sculpture.
  double deepest() const { return deepest_; }
  double meanDepth() const { return meanDepth_; }

 private:
  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(i) * std::size_t(size_[1]) + std::size_t(j)) *
               std::size_t(size_[2]) +
           std::size_t(k);
  }
  std::vector<float> densities(const Sculpture& sculpture) const;
  void find(const std::vector<float>& density, float iso);
  void findDepths();

  std::array<int, 3> size_{};
  double spacing_ = 1;           // cells of the sculpture between nodes
  glm::dvec3 low_{0};            // first node, in cells from the centre
  std::vector<float> distance_;  // in nodes
  double deepest_ = 0, meanDepth_ = 0;
};

}  // namespace bozzetto
