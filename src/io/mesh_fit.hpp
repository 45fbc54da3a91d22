// How well the clay fits the mesh that it came from.
#pragma once
#include "io/grid_mesh.hpp"

namespace bozzetto {

/// Fills fitMax, fitMean and corners of the report: at each used vertex of the mesh the trilinear
/// value v tells |v - ½|·2 cells to the surface.
void measureFit(const GridMesh& grid, const KeyTree<CornerBlock<8>>& tree, ImportReport& report);

}  // namespace bozzetto
