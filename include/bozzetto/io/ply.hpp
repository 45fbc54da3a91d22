// PLY (Stanford): ascii, binary little and big endian; unknown elements and properties are skipped.
#pragma once
#include <cstddef>
#include <span>
#include <string_view>

#include "bozzetto/base/bytes.hpp"
#include "bozzetto/base/progress.hpp"
#include "bozzetto/mesh/triangle_mesh.hpp"

namespace bozzetto {

/// Throws Error, opened by `name`, for anything that is not such a file.
/// Polygons become fans. Colours: red green blue (or diffuse_*) of any type per vertex.
TriangleMesh readPly(std::span<const std::byte> bytes, std::string_view name,
                     Progress& progress = Progress::none());

/// Binary little endian; floats, or doubles where the mesh is small beside its distance from the
/// origin; normals and colours when the mesh has them; faces hold only vertex_indices.
Bytes writePly(const TriangleMesh& mesh, Progress& progress = Progress::none());

}  // namespace bozzetto
