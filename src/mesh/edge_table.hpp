// The triangle sides of a mesh, grouped by undirected edge, without a hash table: sides are dealt
// into buckets by their smaller vertex and each short bucket is sorted.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "bozzetto/base/function_ref.hpp"
#include "bozzetto/mesh/triangle_mesh.hpp"

namespace bozzetto {

/// One side of a triangle. Corner 3·t + n starts side n of triangle t.
struct TriangleSide {
  std::uint32_t other;   ///< the larger vertex of the edge
  std::uint32_t corner;  ///< where the side starts
  bool rising;           ///< walked from the smaller vertex to the larger
};

/// Calls visit(smaller vertex, sides) for every undirected edge, in the order of (smaller, larger)
/// vertex; sides are in the order of corners. Sides from a vertex to itself are left out.
void forEachEdge(const TriangleMesh& mesh,
                 FunctionRef<void(std::uint32_t, std::span<const TriangleSide>)> visit);

}  // namespace bozzetto
