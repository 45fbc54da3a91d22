// Where the columns of corners along k cross a closed surface, and how often the surface winds
// round a corner.
#pragma once
#include <span>
#include <vector>

#include "bozzetto/grid/key.hpp"
#include "bozzetto/mesh/triangle_mesh.hpp"

namespace bozzetto {

/// Positions in cells from corner (0, 0, 0) on; all triangles inside [0, size).
class Columns {
 public:
  Columns(const TriangleMesh& mesh, std::int32_t sizeI, std::int32_t sizeJ);

  /// Winding number of a corner: how often the surface is entered minus left on the way up to it.
  int winding(std::int32_t i, std::int32_t j, double k) const;

 private:
  struct Crossing {
    float k;
    std::int32_t turn;
  };
  std::span<const Crossing> column(std::int32_t i, std::int32_t j) const;

  std::int32_t sizeI_, sizeJ_;
  std::vector<std::size_t> start_;
  std::vector<Crossing> crossings_;
};

}  // namespace bozzetto
