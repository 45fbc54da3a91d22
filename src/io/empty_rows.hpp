// The blocks that no triangle comes near: solid or empty.
#pragma once
#include <vector>

#include "bozzetto/base/progress.hpp"
#include "bozzetto/grid/delta.hpp"
#include "io/block_kernel.hpp"

namespace bozzetto {

/// Solid runs between the blocks of `tasks` (in key order), relative to the grid mesh's first
/// block. Of closed meshes one winding number a gap tells. Of open meshes every block is asked,
/// blocks near open edges become `holes` or `rim`, and blocks that the ½ level of the winding
/// number passes through are added to `tasks` (which stays in order).
std::vector<KeyRun> emptyRows(const GridMesh& grid, const WindingTree& winding,
                              std::vector<BlockTask>& tasks, Progress& progress);

}  // namespace bozzetto
