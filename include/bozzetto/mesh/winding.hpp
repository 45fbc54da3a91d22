// Is a point inside? The generalised winding number of a triangle soup (Jacobson, Kavan & Sorkine
// 2013), summed through a tree in which far triangles count as one (Barill, Dickson, Schmidt, Levin
// & Jacobson 2018, §3, to second order).
#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>

#include "bozzetto/mesh/triangle_mesh.hpp"

namespace bozzetto {

/// Built once, asked from many threads. Keeps no reference to the mesh.
class WindingTree {
 public:
  /// O(n log n), about 0.3 µs a triangle and level.
  explicit WindingTree(const TriangleMesh& mesh);
  ~WindingTree();
  WindingTree(const WindingTree&) = delete;
  WindingTree& operator=(const WindingTree&) = delete;

  /// 1 inside a closed outward mesh, 0 outside, -1 inside an inward one, 2 where two bodies
  /// overlap; in between, and smooth, where the mesh is open. Good to about 0.005; exact up to
  /// rounding for triangles near the point. O(log n).
  double at(const glm::dvec3& point) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace bozzetto
