// Sculpted tools as pushers: their signed distance, found once when the stroke begins, so that
// clay inside knows the way out (Dewaele §3.2.2).
#pragma once
#include <memory>
#include <vector>

#include "bozzetto/tool/sculpture.hpp"
#include "bozzetto/tool/solid.hpp"

namespace bozzetto::clay {

/// Signed distance to a sculpture's surface, in its own cells, on a grid round it of at most 160
/// nodes a side.
class SculptedDistance {
 public:
  explicit SculptedDistance(const Sculpture& sculpture);
  /// At a place in the sculpture's cells from its centre; negative inside. Grows linearly outside
  /// the grid.
  double at(const glm::dvec3& place) const;

 private:
  struct Node {
    std::int32_t i, j, k;
  };
  std::size_t index(Node n) const;
  void sample(const Sculpture& sculpture);
  void seed(const std::vector<float>& density, float iso);
  void sweep();
  float solve(Node n) const;

  Node size_{0, 0, 0};
  double spacing_ = 1;           // cells of the sculpture between nodes
  glm::dvec3 low_{0};            // first node, in cells from the centre
  std::vector<float> distance_;  // in nodes
  std::vector<bool> near_;       // known from the density itself
};

/// The tool with the centre of its box at the pose, radii as a freeform tool has them.
std::unique_ptr<Solid> makeSculptedSolid(std::shared_ptr<const SculptedDistance> distance,
                                         const Sculpture& sculpture, const DabPose& pose);

}  // namespace bozzetto::clay
