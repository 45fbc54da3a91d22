// Open Inventor 2.1 ascii, the format Ferley's paper exports. Written only.
#pragma once
#include "bozzetto/base/bytes.hpp"
#include "bozzetto/base/progress.hpp"
#include "bozzetto/mesh/triangle_mesh.hpp"

namespace bozzetto {

/// One IndexedFaceSet; normals and packed colours per vertex when the mesh has them.
Bytes writeInventor(const TriangleMesh& mesh, Progress& progress = Progress::none());

}  // namespace bozzetto
