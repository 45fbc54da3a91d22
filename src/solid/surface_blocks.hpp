// Which blocks of corners a surface comes near, and which triangles it is that do.
#pragma once
#include <span>
#include <vector>

#include "bozzetto/grid/key.hpp"
#include "bozzetto/mesh/triangle_mesh.hpp"

namespace bozzetto {

/// Block keys are packed into one number that sorts like them; each index in [0, 2²¹).
struct NearTriangle {
  std::uint64_t code;
  std::uint32_t triangle;

  static std::uint64_t codeOf(Key block) {
    return static_cast<std::uint64_t>(block.i) << 42 | static_cast<std::uint64_t>(block.j) << 21 |
           static_cast<std::uint64_t>(block.k);
  }
  Key block() const {
    const auto part = [&](int shift) {
      return static_cast<std::int32_t>(code >> shift & 0x1fffff);
    };
    return {part(42), part(21), part(0)};
  }
};

/// Pairs of blocks of side 8 and triangles within `reach` cells of one of their corners, in order
/// of blocks; a few pairs too many, none missing. All places in [1, 2²⁴). In parallel.
std::vector<NearTriangle> nearTriangles(const TriangleMesh& mesh, double reach);

}  // namespace bozzetto
