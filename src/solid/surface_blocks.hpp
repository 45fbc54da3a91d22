// Which blocks of corners a surface comes near, and which triangles it is that do.
#pragma once
#include <span>
#include <vector>

#include "bozzetto/grid/key.hpp"
#include "bozzetto/mesh/triangle_mesh.hpp"

namespace bozzetto {

struct NearTriangle {
  Key block;
  std::uint32_t triangle;
  friend auto operator<=>(const NearTriangle&, const NearTriangle&) = default;
};

/// Pairs of blocks of side 8 and triangles within `reach` cells of one of their corners, in order
/// of blocks; a few pairs too many, none missing. In parallel.
std::vector<NearTriangle> nearTriangles(const TriangleMesh& mesh, double reach);

}  // namespace bozzetto
