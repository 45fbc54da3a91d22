// Triangle meshes from and to files: which format, then that format's own reader or writer.
#pragma once
#include <filesystem>
#include <string_view>

#include "bozzetto/base/progress.hpp"
#include "bozzetto/mesh/triangle_mesh.hpp"

namespace bozzetto {

enum class MeshFormat { stl, ply, obj, off, glb, inventor };

/// By extension, any case. Throws Error listing the known ones.
MeshFormat meshFormatOf(const std::filesystem::path& path);

/// Reads .stl .ply .obj .off .glb. What the file's first bytes say wins over its extension. The
/// mesh is valid and has at least one triangle; world coordinates are kept. Throws Error naming
/// file and byte or line; memory stays within about 30 times the file.
TriangleMesh readMesh(const std::filesystem::path& path, Progress& progress = Progress::none());

/// Writes .stl .ply .obj .glb .iv by extension. Never leaves half a file under the name.
void writeMesh(const std::filesystem::path& path, const TriangleMesh& mesh,
               Progress& progress = Progress::none());

/// The same with the format given, so that `path` may be "-" or /dev/stdout.
void writeMesh(const std::filesystem::path& path, MeshFormat format, const TriangleMesh& mesh,
               Progress& progress = Progress::none());

}  // namespace bozzetto
