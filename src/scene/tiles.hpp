// Which chunks a tree of clay is made of, and which of them differ between two trees.
#pragma once
#include <set>

#include "scene/chunk_codec.hpp"

namespace bozzetto {

/// The tiles in which runs begin, in key order. O(nodes).
std::vector<Key> tilesOf(const Clay::Tree& tree);

/// The tiles whose chunks differ: by block pointers, so both trees must be alive. O(nodes).
std::vector<Key> changedTiles(const Clay::Tree& before, const Clay::Tree& after);

/// The runs that begin in the tile, in key order; none: no chunk. O(64 log n).
Chunk chunkAt(const Clay::Tree& tree, Key tile);

}  // namespace bozzetto
