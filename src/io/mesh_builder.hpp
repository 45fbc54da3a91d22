// What all mesh readers need: fans, colours, the last checks.
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

#include "bozzetto/mesh/triangle_mesh.hpp"

namespace bozzetto {

/// Appends a polygon as a fan round its first vertex: right for convex polygons, and of the right
/// winding number for all planar ones. Polygons of less than three vertices add nothing.
void appendFan(TriangleMesh& mesh, std::span<const std::uint32_t> polygon);

/// 0…1 to 0…255, rounded; clamped outside, 0 for nan.
std::uint8_t colourByte(double unit);

/// Throws Error unless the mesh is valid, has triangles, and few enough for 32-bit side numbers.
void requireMesh(const TriangleMesh& mesh, std::string_view name);

}  // namespace bozzetto
