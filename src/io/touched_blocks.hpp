// Which blocks have corners near which triangles.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "bozzetto/grid/key.hpp"
#include "bozzetto/mesh/triangle_mesh.hpp"

namespace bozzetto {

/// A block number packed so that order is the order of keys: 21 bits each of i, j, k.
using PackedBlock = std::uint64_t;

constexpr PackedBlock packBlock(Key block) {
  return PackedBlock(block.i) << 42 | PackedBlock(block.j) << 21 | PackedBlock(block.k);
}
constexpr Key unpackBlock(PackedBlock packed) {
  constexpr PackedBlock mask = (1 << 21) - 1;
  return {static_cast<std::int32_t>(packed >> 42), static_cast<std::int32_t>(packed >> 21 & mask),
          static_cast<std::int32_t>(packed & mask)};
}

struct BlockTriangle {
  PackedBlock block;
  std::uint32_t triangle;
};

/// Every pair of a block and a triangle that comes within `reach` cells of the box of the block's
/// corners, perhaps a few more, by block and then triangle. Positions are in cells; none may lie
/// within reach of a negative block. In parallel.
std::vector<BlockTriangle> touchedBlocks(std::span<const glm::dvec3> positions,
                                         std::span<const TriangleMesh::Triangle> triangles,
                                         double reach);

}  // namespace bozzetto
