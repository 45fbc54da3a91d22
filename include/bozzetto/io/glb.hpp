// GLB (binary glTF 2.0): triangles of all meshes of the scene, placed by their nodes, with COLOR_0.
#pragma once
#include <cstddef>
#include <span>
#include <string_view>

#include "bozzetto/base/bytes.hpp"
#include "bozzetto/base/progress.hpp"
#include "bozzetto/mesh/triangle_mesh.hpp"

namespace bozzetto {

/// Throws Error, opened by `name`, for anything that is not such a file.
/// Only the embedded buffer: no URI is ever followed. Sparse accessors and Draco or meshopt
/// compression are errors. Colours are linear in the file and sRGB here. Skins, morphs and
/// materials are ignored.
TriangleMesh readGlb(std::span<const std::byte> bytes, std::string_view name,
                     Progress& progress = Progress::none());

/// Normals and colours when the mesh has them; single precision round the middle of the bounds,
/// which the node's translation holds, where the mesh is small beside its distance from the origin.
Bytes writeGlb(const TriangleMesh& mesh, Progress& progress = Progress::none());

}  // namespace bozzetto
