// STL, both kinds: a soup of triangles without shared vertices, single precision.
#pragma once
#include <cstddef>
#include <span>
#include <string_view>

#include "bozzetto/base/bytes.hpp"
#include "bozzetto/base/progress.hpp"
#include "bozzetto/mesh/triangle_mesh.hpp"

namespace bozzetto {

/// Throws Error, opened by `name`, for anything that is not such a file.
/// Welds vertices at equal positions. Colours of any dialect are ignored.
TriangleMesh readStl(std::span<const std::byte> bytes, std::string_view name,
                     Progress& progress = Progress::none());

/// Binary. Coordinates become single precision; colours and shared vertices are lost.
Bytes writeStl(const TriangleMesh& mesh, Progress& progress = Progress::none());

}  // namespace bozzetto
