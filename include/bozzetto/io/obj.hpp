// Wavefront OBJ: positions, colours after the position, polygons, negative indices.
#pragma once
#include <cstddef>
#include <span>
#include <string_view>

#include "bozzetto/base/bytes.hpp"
#include "bozzetto/base/progress.hpp"
#include "bozzetto/mesh/triangle_mesh.hpp"

namespace bozzetto {

/// Throws Error, opened by `name`, for anything that is not such a file.
/// Polygons become fans; materials, textures, lines and curves are ignored.
TriangleMesh readObj(std::span<const std::byte> bytes, std::string_view name,
                     Progress& progress = Progress::none());

/// With normals and colours (0…1 after the position) when the mesh has them.
Bytes writeObj(const TriangleMesh& mesh, Progress& progress = Progress::none());

}  // namespace bozzetto
