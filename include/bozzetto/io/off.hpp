// OFF (Geomview): ascii OFF, COFF, NOFF and their mixtures. Read only.
#pragma once
#include <cstddef>
#include <span>
#include <string_view>

#include "bozzetto/base/bytes.hpp"
#include "bozzetto/base/progress.hpp"
#include "bozzetto/mesh/triangle_mesh.hpp"

namespace bozzetto {

/// Throws Error, opened by `name`, for anything that is not such a file.
/// Polygons become fans; vertex colours of COFF are kept, face colours ignored.
TriangleMesh readOff(std::span<const std::byte> bytes, std::string_view name,
                     Progress& progress = Progress::none());

}  // namespace bozzetto
